#include "surface/sector_jets.hpp"

#include <algorithm>
#include <optional>

#include "base/each_once.hpp"
#include "base/parallel.hpp"
#include "mesh/neighbourhood.hpp"
#include "surface/jet.hpp"

namespace taut {
namespace {

constexpr std::size_t fewest_points_of_jet = 8;  // 1.5 for each coefficient of a quadratic polynomial
constexpr int fewest_rings_of_jet = 3;           // two do not hold enough points for the fourth degree
constexpr int most_rings_of_jet = 5;
constexpr double least_cosine = 0.2;  ///< between the normals of a sector and its neighbour: the surface folds beyond

/// The edges between sectors, each once.
std::vector<std::array<Index, 2>> edges_between(const Sectors& sectors) {
  std::vector<std::array<Index, 2>> edges;
  edges.reserve(3 * sectors.of_triangle.size());
  for (const auto& s : sectors.of_triangle)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [p, q] = std::minmax(s[k], s[(k + 1) % 3]);
      edges.push_back({p, q});
    }
  keep_each_once(edges);
  return edges;
}

class JetFinder {
public:
  JetFinder(const Facets& facets, const Sectors& sectors, double tolerance)
      : facets_(facets),
        sectors_(sectors),
        normals_(max_normals(facets, sectors)),
        neighbours_(neighbours_of_vertices(edges_between(sectors), sectors.vertices.size())),
        tolerance_(tolerance) {}

  [[nodiscard]] std::vector<Derivatives> run() const {
    std::vector<Derivatives> found(sectors_.vertices.size());
    std::vector<std::optional<Neighbourhood>> scratch(static_cast<std::size_t>(worker_count()));
    const Chunks chunks(found.size(), 512);
    for_each_task(chunks.size(), [&](std::size_t chunk, int worker) {
      auto& around = scratch[static_cast<std::size_t>(worker)];
      if (!around) around.emplace(neighbours_);
      for (std::size_t s = chunks.begin(chunk); s < chunks.end(chunk); ++s)
        found[s] = jet(normals_[s], offsets_around(static_cast<Index>(s), *around), tolerance_);
    });
    return found;
  }

private:
  [[nodiscard]] std::vector<Vec3> offsets_around(Index centre, Neighbourhood& around) const {
    std::vector<Vec3> offsets;
    around.start_at(centre);
    std::size_t added = 1;
    for (int ring = 1; ring <= (offsets.size() < fewest_points_of_jet ? most_rings_of_jet : fewest_rings_of_jet);
         ++ring) {
      around.grow();
      for (; added < around.vertices().size(); ++added) {
        const Index s = around.vertices()[added];
        // A neighbour on the other side of a thin part belongs to another sheet of the surface.
        if (dot(normals_[centre], normals_[s]) >= least_cosine) offsets.push_back(place(s) - place(centre));
      }
    }
    return offsets;
  }

  [[nodiscard]] const Vec3& place(Index sector) const { return facets_.points[sectors_.vertices[sector]]; }

  const Facets& facets_;
  const Sectors& sectors_;
  std::vector<Vec3> normals_;
  Buckets<Index> neighbours_;
  double tolerance_;
};

}  // namespace

std::vector<Vec3> max_normals(const Facets& facets, const Sectors& sectors) {
  std::vector<Vec3> normals(sectors.vertices.size());
  for (const TriangleId t : ids<TriangleId>(facets.triangles.size())) {
    const auto v = places_of(facets, t);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 a = v[(k + 1) % 3] - v[k], b = v[(k + 2) % 3] - v[k];
      Vec3& normal = normals[sectors.of_triangle[t][k]];
      normal = normal + 1 / (dot(a, a) * dot(b, b)) * cross(a, b);
    }
  }
  for (Vec3& n : normals) {
    const double length = norm(n);
    n = length > 0 ? 1 / length * n : Vec3{0, 0, 1};
  }
  return normals;
}

std::vector<Derivatives> sector_jets(const Facets& facets, const Sectors& sectors, double tolerance) {
  return JetFinder(facets, sectors, tolerance).run();
}

}  // namespace taut
