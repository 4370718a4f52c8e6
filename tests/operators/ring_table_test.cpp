#include "operators/ring_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "metric/random_metrics.hpp"

namespace taut {
namespace {

class Rings : public testing::TestWithParam<int> {
protected:
  const int n = GetParam();
  const RingTable& table = ring_tables[static_cast<std::size_t>(n - RingTable::smallest)];

  [[nodiscard]] std::vector<std::array<int, 3>> fan(int p) const {
    std::vector<std::array<int, 3>> triangles;
    for (int i = 0; i < n - 2; ++i) {
      const int k = table.fans[p][i];
      EXPECT_LT(k, table.triangle_count);
      triangles.push_back({table.triangles[k][0], table.triangles[k][1], table.triangles[k][2]});
    }
    return triangles;
  }
};

INSTANTIATE_TEST_SUITE_P(All, Rings, testing::Range(int{RingTable::smallest}, RingTable::largest + 1));

TEST_P(Rings, TrianglesAreListedOnceInAscendingOrder) {
  std::set<std::array<std::uint8_t, 3>> seen;
  for (int i = 0; i < table.triangle_count; ++i) {
    const auto& t = table.triangles[i];
    EXPECT_TRUE(t[0] < t[1] && t[1] < t[2] && t[2] < n);
    EXPECT_TRUE(seen.insert(t).second);
  }
}

TEST_P(Rings, EveryTriangleIsOfAFan) {
  std::set<std::array<int, 3>> used;
  for (int p = 0; p < n; ++p)
    for (const auto& t : fan(p)) used.insert(t);
  EXPECT_EQ(used.size(), static_cast<std::size_t>(table.triangle_count));
}

TEST_P(Rings, FansContainTheirVertexAndConform) {
  for (int p = 0; p < n; ++p) {
    std::map<std::pair<int, int>, int> uses;
    for (const auto& [a, b, c] : fan(p)) {
      EXPECT_TRUE(a == p || b == p || c == p);
      ++uses[{a, b}], ++uses[{b, c}], ++uses[{a, c}];
    }
    for (const auto& [edge, count] : uses) {
      const bool of_ring = edge.second == edge.first + 1 || (edge.first == 0 && edge.second == n - 1);
      EXPECT_EQ(count, of_ring ? 1 : 2);
    }
    EXPECT_EQ(uses.size(), static_cast<std::size_t>(n + n - 3)) << "the ring's edges and n - 3 diagonals";
  }
}

TEST_P(Rings, FansFillConvexPolygons) {
  test::Random random(1);
  for (int repeat = 0; repeat < 20; ++repeat) {
    std::vector<double> angles;
    for (int i = 0; i < n; ++i) angles.push_back(random.uniform(0, 6.28));
    std::sort(angles.begin(), angles.end());
    const auto area = [&](int a, int b, int c) {  // positive: the vertices lie on an ellipse in ascending order
      const auto x = [&](int i) { return 2 * std::cos(angles[i]); };
      const auto y = [&](int i) { return std::sin(angles[i]); };
      return (x(b) - x(a)) * (y(c) - y(a)) - (x(c) - x(a)) * (y(b) - y(a));
    };
    double whole = 0;
    for (int i = 1; i + 1 < n; ++i) whole += area(0, i, i + 1);
    for (int p = 0; p < n; ++p) {
      double sum = 0;
      for (const auto& [a, b, c] : fan(p)) {
        EXPECT_GE(area(a, b, c), 0);
        sum += area(a, b, c);
      }
      EXPECT_NEAR(sum, whole, 1e-14);
    }
  }
}

}  // namespace
}  // namespace taut
