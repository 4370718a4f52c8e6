#include "levelset/samples.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"

namespace taut {
namespace {

constexpr double most_divisions = 1e5;

std::size_t divisions_of(const SurfaceMesh& surface, std::size_t t, double spacing, int least) {
  const auto& [i, j, k] = surface.triangles[t];
  const Vec3 &a = surface.points[i], &b = surface.points[j], &c = surface.points[k];
  const double longest = std::max(norm(b - a), std::max(norm(c - b), norm(a - c)));
  const double wanted = std::max(std::ceil(longest / spacing), static_cast<double>(least));
  return static_cast<std::size_t>(std::min(wanted, most_divisions));
}

}  // namespace

Samples::Samples(const SurfaceMesh& surface, double spacing, int divisions)
    : surface_(surface), first_row_(surface.triangles.size() + 1, 0) {
  for_each_index(surface.triangles.size(),
                 [&](std::size_t t) { first_row_[t + 1] = divisions_of(surface, t, spacing, divisions) + 1; });
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) first_row_[t + 1] += first_row_[t];
}

Samples::Row Samples::locate(std::size_t row) const {
  const auto above = std::upper_bound(first_row_.begin(), first_row_.end(), row);
  const auto t = static_cast<std::size_t>(above - first_row_.begin()) - 1;
  const auto& [i, j, k] = surface_.triangles[t];
  const Vec3& origin = surface_.points[i];
  const Vec3 along = surface_.points[j] - origin, up = surface_.points[k] - origin;
  return {origin, along, up, norm(cross(along, up)) / 2, row - first_row_[t], first_row_[t + 1] - first_row_[t] - 1};
}

}  // namespace taut
