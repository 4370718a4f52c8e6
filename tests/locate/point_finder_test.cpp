// Points found by their places, against a search of all.
#include "locate/point_finder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "metric/random_metrics.hpp"

namespace taut {
namespace {

std::vector<Index> by_search(const std::vector<Point>& points, const Point& x, double tolerance) {
  double best = std::numeric_limits<double>::infinity();
  std::vector<Index> found;
  for (Index p = 0; p < points.size(); ++p) {
    const double d = norm(points[p] - x);
    if (d > tolerance || d > best) continue;
    if (d < best) found.clear();
    best = d;
    found.push_back(p);
  }
  return found;
}

std::vector<Index> all_of(const std::vector<Point>& points) {
  std::vector<Index> all(points.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

TEST(PointFinder, FindsTheNearestAndAllAtItsPlace) {
  test::Random random(1);
  std::vector<Point> points;
  for (int i = 0; i < 3000; ++i) points.push_back(random.point());
  for (int i = 0; i < 100; ++i) points.push_back(points[7 * i]);
  std::size_t none_near = 0, several = 0;
  for (const double tolerance : {0.02, 0.1}) {
    const PointFinder finder(points, all_of(points), tolerance);
    for (int i = 0; i < 3000; ++i) {
      const Point x = i % 3 == 0 ? points[i] : Point(1.2 * random.point());
      const auto found = finder.at(x);
      ASSERT_EQ(found, by_search(points, x, tolerance));
      none_near += found.empty() ? 1 : 0;
      several += found.size() > 1 ? 1 : 0;
    }
  }
  EXPECT_GT(none_near, 100U);
  EXPECT_GT(several, 10U);
}

TEST(PointFinder, KnowsTheWantedPointsOnly) {
  const std::vector<Point> points = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}};
  const PointFinder finder(points, std::vector<Index>{1}, 1e-6);
  EXPECT_EQ(finder.at({0, 0, 1e-7}), (std::vector<Index>{1}));
  EXPECT_TRUE(finder.at({1, 0, 0}).empty());
  EXPECT_TRUE(PointFinder(points, {}, 1e-6).at({0, 0, 0}).empty());
}

TEST(PointFinder, TakesPlacesFarAway) {
  const std::vector<Point> points = {{0, 0, 0}, {1, 1, 1}};
  const PointFinder finder(points, all_of(points), 1e-6);
  for (const double far : {-1e300, -2.0, -3e-6, 1 + 3e-6, 2.0, 1e300}) EXPECT_TRUE(finder.at({far, far, far}).empty());
  EXPECT_EQ(finder.at({-5e-7, 0, 0}), (std::vector<Index>{0}));
  EXPECT_EQ(finder.at({1, 1, 1 + 5e-7}), (std::vector<Index>{1}));
}

}  // namespace
}  // namespace taut
