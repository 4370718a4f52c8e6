#include "surface/sectors.hpp"

#include "base/disjoint_sets.hpp"

namespace taut {
namespace {

std::uint32_t place_at(std::span<const Corners> triangles, TriangleId t, VertexId v) {
  const Corners& of = triangles[t];
  return 3 * t + (of[0] == v ? 0U : of[1] == v ? 1U : 2U);
}

}  // namespace

Sectors find_sectors(std::span<const Corners> triangles, std::span<const EdgePair> smooth_edges) {
  const std::size_t places = 3 * triangles.size();  // corner k of triangle t: 3 t + k
  DisjointSets sets(places);
  for (const auto& [s, t] : smooth_edges)
    for (const VertexId v : s.edge) sets.join(place_at(triangles, s.triangle, v), place_at(triangles, t.triangle, v));
  Sectors sectors;
  sectors.of_triangle.resize(triangles.size());
  for (std::uint32_t place = 0; place < places; ++place) {
    const std::uint32_t root = sets.root(place);
    auto& sector = sectors.of_triangle[place / 3][place % 3];
    sector =
        root == place ? static_cast<std::uint32_t>(sectors.vertices.size()) : sectors.of_triangle[root / 3][root % 3];
    if (root == place) sectors.vertices.push_back(triangles[place / 3][place % 3]);
  }
  return sectors;
}

}  // namespace taut
