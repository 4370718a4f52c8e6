#include <algorithm>

#include "base/parallel.hpp"
#include "base/sort.hpp"
#include "base/vec3.hpp"
#include "levelset/surface_door.hpp"
#include "taut/surface_mesh.hpp"

namespace taut {
namespace {

/// Sums over triangles.
struct Extent {
  double area = 0, six_volumes = 0;
  Extent& operator+=(const Extent& other) {
    area += other.area;
    six_volumes += other.six_volumes;
    return *this;
  }
};

Extent extent_of(const SurfaceMesh& surface) {
  return sum_in_order<Extent>(surface.triangles.size(), [&](Extent& sum, std::size_t t) {
    const auto& [i, j, k] = surface.triangles[t];
    const Vec3 &a = surface.points[i], &b = surface.points[j], &c = surface.points[k];
    sum.area += norm(cross(b - a, c - a)) / 2;
    sum.six_volumes += six_volumes(surface.points[0], a, b, c);
  });
}

/// Every side of every triangle by the edge that it passes; forward ones have an even index.
std::vector<KeyedIndex> sides_by_edge(const SurfaceMesh& surface) {
  std::vector<KeyedIndex> sides(3 * surface.triangles.size());
  for_each_index(sides.size(), [&](std::size_t s) {
    const auto& t = surface.triangles[s / 3];
    const Index from = t[s % 3], to = t[(s + 1) % 3];
    sides[s] = {std::uint64_t{std::min(from, to)} << 32 | std::max(from, to), from < to ? 0U : 1U};
  });
  sort(sides);
  return sides;
}

std::size_t count_open_edges(const std::vector<KeyedIndex>& sides) {
  std::size_t open = 0;
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    std::size_t backward = 0;
    for (; end < sides.size() && sides[end].key == sides[begin].key; ++end) backward += sides[end].index;
    open += 2 * backward != end - begin ? 1 : 0;
  }
  return open;
}

}  // namespace

SurfaceMeasures measure(const SurfaceMesh& surface) {
  require_sound(surface, "surface");
  SurfaceMeasures result;
  const Extent extent = extent_of(surface);
  result.area = extent.area;
  result.open_edges = count_open_edges(sides_by_edge(surface));
  if (result.open_edges == 0) result.volume = extent.six_volumes / 6;
  return result;
}

}  // namespace taut
