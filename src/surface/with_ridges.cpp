#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/box.hpp"
#include "locate/point_finder.hpp"
#include "mesh/door.hpp"
#include "surface/surface_input.hpp"
#include "taut/error.hpp"
#include "taut/ridges.hpp"

namespace taut {
namespace {

using Edge = std::array<Index, 2>;

/// Files have six digits at least.
constexpr double tolerance_of_places = 1e-6;

Edge ascending(const Edge& e) {
  return {std::min(e[0], e[1]), std::max(e[0], e[1])};
}

/// The edges of all triangles, ascending; each at least once.
std::vector<Edge> surface_edges(const Mesh& mesh) {
  std::vector<Edge> edges;
  for (const EdgeUse& use : edge_uses(surface_of(mesh).facets.triangles))
    edges.push_back({Index{use.edge[0]}, Index{use.edge[1]}});
  return edges;
}

bool contains(const std::vector<Edge>& edges, const Edge& edge) {
  return std::binary_search(edges.begin(), edges.end(), ascending(edge));
}

constexpr const char* no_surface_edge = "is no edge of a triangle of the boundary or between regions";

void mark(Mesh& mesh, const std::vector<Edge>& ridges) {
  std::map<Edge, Index> index_of;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    index_of.try_emplace(ascending(mesh.edges[e]), static_cast<Index>(e));
  std::vector<std::uint8_t> is_ridge(mesh.edges.size() + ridges.size(), 0);
  for (const Index e : mesh.ridges) is_ridge[e] = 1;
  for (const Edge& ridge : ridges) {
    const auto [at, is_new] = index_of.try_emplace(ascending(ridge), static_cast<Index>(mesh.edges.size()));
    if (is_new) mesh.edges.push_back(ridge);
    if (is_ridge[at->second] == 0) mesh.ridges.push_back(at->second);
    is_ridge[at->second] = 1;
  }
  if (!mesh.edge_refs.empty()) mesh.edge_refs.resize(mesh.edges.size(), 0);
}

void require_surface_edges(std::span<const Edge> edges, const std::vector<Edge>& allowed, std::size_t points) {
  for (std::size_t e = 0; e < edges.size(); ++e) {
    for (const Index v : edges[e])
      if (v >= points)
        throw InputError(
            fmt::format("ridges: edge {}: vertex {} found, expected 1..{}", e + 1, std::size_t{v} + 1, points));
    if (!contains(allowed, edges[e]))
      throw InputError(
          fmt::format("ridges: edge {} ({} {}) {}", e + 1, edges[e][0] + 1, edges[e][1] + 1, no_surface_edge));
  }
}

/// Of all ridges; of all edges if none is one.
std::vector<Index> chosen_edges(const Mesh& lines) {
  if (!lines.ridges.empty()) return lines.ridges;
  std::vector<Index> all(lines.edges.size());
  for (std::size_t e = 0; e < all.size(); ++e) all[e] = static_cast<Index>(e);
  return all;
}

std::vector<Index> points_of(const std::vector<Edge>& edges) {
  std::vector<Index> points;
  for (const auto& [a, b] : edges) points.insert(points.end(), {a, b});
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

std::string place(const Point& p) {
  return fmt::format("({:.6g} {:.6g} {:.6g})", p[0], p[1], p[2]);
}

/// The edges of a mesh, found by the places of their ends.
class EdgeFinder {
public:
  explicit EdgeFinder(const Mesh& mesh)
      : edges_(surface_edges(mesh)),
        tolerance_(tolerance_of_places * box_around(mesh.points).diagonal()),
        points_(mesh.points, points_of(edges_), tolerance_) {}

  /// Where an edge of `lines` lies; several at a slit.
  [[nodiscard]] std::vector<Edge> at(const Mesh& lines, Index edge) const {
    const auto [a, b] = lines.edges[edge];
    std::vector<Edge> found;
    for (const Index p : partners(lines, a))
      for (const Index q : partners(lines, b))
        if (contains(edges_, {p, q})) found.push_back({p, q});
    if (found.empty())
      throw InputError(fmt::format("ridges: edge {} ({} {}) from {} to {} {} of the mesh", edge + 1, a + 1, b + 1,
                                   place(lines.points[a]), place(lines.points[b]), no_surface_edge));
    return found;
  }

private:
  [[nodiscard]] std::vector<Index> partners(const Mesh& lines, Index point) const {
    std::vector<Index> found = points_.at(lines.points[point]);
    if (found.empty())
      throw InputError(fmt::format("ridges: vertex {} {}: no vertex of a triangle of the mesh lies within {:.3g} of it",
                                   point + 1, place(lines.points[point]), tolerance_));
    return found;
  }

  std::vector<Edge> edges_;
  double tolerance_;
  PointFinder points_;
};

void require_sound_lines(const Mesh& lines) {
  Mesh used;
  used.points = lines.points;
  used.edges = lines.edges;
  used.ridges = lines.ridges;
  try {
    require_sound_entities(used);
  } catch (const InputError& error) {
    throw InputError(fmt::format("ridges: {}", error.what()));
  }
}

}  // namespace

Mesh with_ridges(Mesh mesh, std::span<const std::array<Index, 2>> edges) {
  require_surface_edges(edges, surface_edges(mesh), mesh.points.size());
  mark(mesh, {edges.begin(), edges.end()});
  return mesh;
}

Mesh with_ridges(Mesh mesh, const Mesh& lines) {
  require_sound_lines(lines);
  std::vector<Edge> ridges;
  const EdgeFinder finder(mesh);
  for (const Index e : chosen_edges(lines)) {
    const std::vector<Edge> found = finder.at(lines, e);
    ridges.insert(ridges.end(), found.begin(), found.end());
  }
  mark(mesh, ridges);
  return mesh;
}

}  // namespace taut
