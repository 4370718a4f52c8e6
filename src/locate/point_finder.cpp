#include "locate/point_finder.hpp"

#include <algorithm>
#include <cmath>

namespace taut {
namespace {

constexpr int bits = 21;  // of a box along an axis, so that three fit into a key
constexpr std::int64_t most = (std::int64_t{1} << bits) - 1;

std::uint64_t key_of(const std::array<std::int64_t, 3>& box) {
  std::uint64_t key = 0;
  for (const std::int64_t i : box) key = key << bits | static_cast<std::uint64_t>(i);
  return key;
}

bool has_key(const std::array<std::int64_t, 3>& box) {
  return std::ranges::all_of(box, [](std::int64_t i) { return i >= 0 && i <= most; });
}

}  // namespace

PointFinder::PointFinder(std::span<const Point> points, std::span<const Index> wanted, double tolerance)
    : points_(points), tolerance_(tolerance) {
  if (wanted.empty()) return;
  low_ = points[wanted[0]];
  for (const Index p : wanted)
    for (std::size_t d = 0; d < 3; ++d) low_[d] = std::min(low_[d], points[p][d]);
  for (double& x : low_) x -= tolerance;  // so that the boxes around the lowest point have keys
  boxed_.reserve(wanted.size());
  for (const Index p : wanted) boxed_.push_back({key_of(box_of(points[p])), p});
  std::ranges::sort(boxed_);
}

std::vector<Index> PointFinder::at(const Point& x) const {
  std::vector<Index> nearest;
  double best = tolerance_;
  visit_around(x, [&](Index p) {
    const double distance = norm(Vec3(points_[p]) - Vec3(x));
    if (distance > best) return;
    if (distance < best) nearest.clear();
    best = distance;
    nearest.push_back(p);
  });
  // Points at one distance need not lie at one place.
  if (!nearest.empty())
    std::erase_if(nearest, [&, place = points_[std::ranges::min(nearest)]](Index p) { return points_[p] != place; });
  std::ranges::sort(nearest);
  return nearest;
}

PointFinder::Box PointFinder::box_of(const Point& x) const {
  Box box{};
  for (std::size_t d = 0; d < 3; ++d) {
    const double i = std::floor((x[d] - low_[d]) / tolerance_);
    box[d] = i >= -1 && i <= static_cast<double>(most) ? static_cast<std::int64_t>(i) : -2;  // far away: no box
  }
  return box;
}

template <class Visit>
void PointFinder::visit_around(const Point& x, Visit visit) const {
  const Box centre = box_of(x);
  for (std::int64_t i = -1; i <= 1; ++i)
    for (std::int64_t j = -1; j <= 1; ++j)
      for (std::int64_t k = -1; k <= 1; ++k) {
        const Box box = {centre[0] + i, centre[1] + j, centre[2] + k};
        if (!has_key(box)) continue;
        for (auto it = std::ranges::lower_bound(boxed_, Boxed{key_of(box), 0});
             it != boxed_.end() && it->key == key_of(box); ++it)
          visit(it->point);
      }
}

}  // namespace taut
