#include "surface/surface_edges.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "base/sort.hpp"

namespace taut {

std::vector<Corners> corners_of(std::span<const Triangle> triangles) {
  std::vector<Corners> corners(triangles.size());
  for_each_index(corners.size(), [&](std::size_t t) { corners[t] = triangles[t].v; });
  return corners;
}

std::vector<EdgeUse> edge_uses(std::span<const Corners> triangles) {
  std::vector<KeyedIndex> uses(3 * triangles.size());  // corner k of triangle t: 3 t + k
  for_each_index(uses.size(), [&](std::size_t i) {
    const Corners& v = triangles[i / 3];
    const auto [a, b] = std::minmax(v[(i + 1) % 3], v[(i + 2) % 3]);
    uses[i] = {(std::uint64_t{a} << 32) | b, static_cast<std::uint32_t>(i)};
  });
  sort(uses);
  std::vector<EdgeUse> result(uses.size());
  for_each_index(uses.size(), [&](std::size_t i) {
    const auto& [edge, corner] = uses[i];
    result[i] = {{static_cast<VertexId>(edge >> 32), static_cast<VertexId>(edge)},
                 static_cast<TriangleId>(corner / 3),
                 static_cast<int>(corner % 3)};
  });
  return result;
}

}  // namespace taut
