#include "surface/spokes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>

#include "base/disjoint_sets.hpp"
#include "surface/apexes.hpp"

namespace taut {
namespace {

constexpr int longest_spoke = 3;
constexpr std::size_t most_vertices_of_stray = 3;  ///< two edges that nothing continues at either end
constexpr std::size_t most_vertices_of_spokes = 32;
constexpr double most_bend_of_cone =
    5 * std::numbers::pi / 180;  ///< from one ring of vertices around its tip to the next

bool holds_vertex(std::span<const VertexId> vertices, VertexId v) {
  return std::find(vertices.begin(), vertices.end(), v) != vertices.end();
}

/// Whether other than two triangles meet at an edge of each vertex: around the others there are as many edges as
/// triangles.
std::vector<std::uint8_t> borders(const Facets& facets, std::span<const EdgePair> pairs,
                                  const Buckets<TriangleId>& triangles_at) {
  std::vector<std::size_t> edges(facets.points.size(), 0);
  for (const EdgePair& pair : pairs)
    for (const VertexId v : pair[0].edge) ++edges[v];
  std::vector<std::uint8_t> is_on_border(edges.size());
  for (std::size_t v = 0; v < edges.size(); ++v) is_on_border[v] = edges[v] != triangles_at[v].size();
  return is_on_border;
}

/// Connected ridges.
struct RidgeTree {
  std::vector<VertexId> vertices;
  int ends = 0;           ///< vertices where a ridge ends in a smooth part of the surface
  bool is_given = false;  ///< whether an edge is, by the input
};

/// By root of the set of vertices.
std::map<std::uint32_t, RidgeTree> connected_ridges(DisjointSets& connected, std::span<const EdgePair> pairs,
                                                    std::span<const Parting> parting,
                                                    std::span<const std::uint8_t> is_on_border) {
  std::map<VertexId, int> ridges_at;
  for (std::size_t e = 0; e < pairs.size(); ++e)
    if (parting[e] != Parting::smooth)
      for (const VertexId v : pairs[e][0].edge) ++ridges_at[v];
  std::map<std::uint32_t, RidgeTree> found;
  for (const auto& [v, count] : ridges_at) {
    RidgeTree& tree = found[connected.root(v)];
    tree.vertices.push_back(v);
    if (count == 1 && is_on_border[v] == 0) ++tree.ends;
  }
  for (std::size_t e = 0; e < pairs.size(); ++e)
    if (parting[e] == Parting::by_input) found[connected.root(pairs[e][0].edge[0])].is_given = true;
  return found;
}

/// The centre, the vertices at one edge from it, at two edges, and so on.
using Ring = std::vector<VertexId>;
std::vector<Ring> rings_around(VertexId centre, std::size_t rings, const Facets& facets,
                               const Buckets<TriangleId>& triangles_at) {
  std::vector<Ring> found{{centre}};
  Ring reached{centre};
  while (found.size() <= rings) {
    Ring next;
    for (const VertexId from : found.back())
      for (const TriangleId t : triangles_at[from])
        for (const VertexId v : facets.triangles[t])
          if (!holds_vertex(reached, v)) reached.push_back(v), next.push_back(v);
    found.push_back(std::move(next));
  }
  return found;
}

/// Number of rings that hold all of the vertices; more than there are if they do not.
std::size_t rings_with(const std::vector<Ring>& rings, std::span<const VertexId> vertices) {
  std::size_t left = vertices.size(), count = 0;
  for (; left > 0 && count < rings.size(); ++count)
    left -= static_cast<std::size_t>(
        std::count_if(vertices.begin(), vertices.end(), [&](VertexId v) { return holds_vertex(rings[count], v); }));
  return left > 0 ? rings.size() + 1 : count;
}

Vec3 direction(const Vec3& from, const Vec3& to) {
  const Vec3 d = to - from;
  const double length = norm(d);
  return length > 0 ? 1 / length * d : Vec3{};
}

/// Of the cone through the neighbours of the apex: perpendicular to the polygon that their directions make.
Vec3 axis_at(VertexId apex, const Facets& facets, const Buckets<TriangleId>& triangles_at) {
  Vec3 axis{};
  for (const TriangleId t : triangles_at[apex]) {
    const Corners& v = facets.triangles[t];
    const auto k = static_cast<std::size_t>(std::find(v.begin(), v.end(), apex) - v.begin());
    const Vec3& x = facets.points[apex];
    axis = axis + cross(direction(x, facets.points[v[(k + 1) % 3]]), direction(x, facets.points[v[(k + 2) % 3]]));
  }
  return direction({}, axis);
}

double mean_angle(std::span<const VertexId> vertices, const Vec3& apex, const Vec3& axis, const Facets& facets) {
  double sum = 0;
  for (const VertexId v : vertices) sum += std::acos(std::clamp(dot(axis, direction(apex, facets.points[v])), -1., 1.));
  return sum / static_cast<double>(vertices.size());
}

/// Whether ridges that are not connected to others are edges of the few triangles at the tip of a cone: what is beyond
/// them is seen from there at the same angle from the axis. On a pyramid that stands on a surface it is not, and around
/// a solid of a few triangles there is nothing beyond.
bool is_tip(const RidgeTree& tree, const std::vector<Ring>& rings, const Facets& facets,
            const Buckets<TriangleId>& triangles_at) {
  const std::size_t beyond = rings_with(rings, tree.vertices);
  if (beyond >= rings.size() || rings[beyond].size() < rings[1].size()) return false;
  const VertexId apex = rings[0][0];
  const Vec3 axis = axis_at(apex, facets, triangles_at);
  const auto angle = [&](const Ring& ring) { return mean_angle(ring, facets.points[apex], axis, facets); };
  return std::abs(angle(rings[beyond]) - angle(rings[1])) < most_bend_of_cone;
}

}  // namespace

void drop_spokes(const Facets& facets, std::span<const EdgePair> pairs, std::vector<Parting>& parting) {
  std::vector<EdgePair> not_given;
  DisjointSets connected(facets.points.size());
  for (std::size_t e = 0; e < pairs.size(); ++e) {
    if (parting[e] != Parting::by_input) not_given.push_back(pairs[e]);
    if (parting[e] != Parting::smooth) connected.join(pairs[e][0].edge[0], pairs[e][0].edge[1]);
  }
  const auto is_apex = find_apexes(facets, find_sectors(facets.triangles, not_given), {});
  const auto triangles_at = triangles_of_vertices(facets);
  const auto is_spokes = [&](const RidgeTree& tree) {
    return tree.vertices.size() <= most_vertices_of_spokes &&
           std::any_of(tree.vertices.begin(), tree.vertices.end(), [&](VertexId v) {
             if (is_apex[v] == 0) return false;
             const std::vector<Ring> rings = rings_around(v, longest_spoke, facets, triangles_at);
             const bool ends_nearby = tree.ends > 0 && rings_with(rings, tree.vertices) <= rings.size();
             return ends_nearby || is_tip(tree, rings, facets, triangles_at);
           });
  };
  const auto is_short = [](const RidgeTree& tree) {
    return tree.ends == 2 && tree.vertices.size() <= most_vertices_of_stray;
  };
  auto trees = connected_ridges(connected, pairs, parting, borders(facets, pairs, triangles_at));
  std::erase_if(trees, [&](const auto& entry) {
    const RidgeTree& tree = entry.second;
    return tree.is_given || !(is_spokes(tree) || is_short(tree));
  });
  for (std::size_t e = 0; e < pairs.size(); ++e)
    if (parting[e] == Parting::by_shape && trees.contains(connected.root(pairs[e][0].edge[0])))
      parting[e] = Parting::smooth;
}

}  // namespace taut
