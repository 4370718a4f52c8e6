#include "geometry/largest_plane.hpp"

#include <cstddef>

namespace taut {
namespace {

void snap_to_axis(Vec3& normal) {
  for (std::size_t d = 0; d < 3; ++d) {
    if (std::fabs(normal[d]) < 1 - 1e-15) continue;
    const double sign = normal[d] > 0 ? 1 : -1;
    normal = {};
    normal[d] = sign;
    return;
  }
}

}  // namespace

void LargestPlane::add(const std::array<Vec3, 3>& triangle) {
  const Vec3 normal = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  const double area = norm(normal);
  if (area <= largest_) return;
  largest_ = area;
  plane_.normal = (1 / area) * normal;
  snap_to_axis(plane_.normal);
  plane_.offset = dot(plane_.normal, triangle[0]);
}

}  // namespace taut
