// How far the vertices of a mesh can go.
#include "motion/step.hpp"

#include <gtest/gtest.h>

#include "mesh/metric_grid.hpp"

namespace taut::test {
namespace {

/// A unit cube, one corner of which is to go along the diagonal, ten times as far as it is long.
class Corner {
public:
  explicit Corner(double edge_of_metric) : mesh_(metric_grid(1, 1 / (edge_of_metric * edge_of_metric) * identity3)) {}

  [[nodiscard]] Reach reach(double smallest) const {
    const Places places = [this](double share) {
      std::vector<Vec3> x;
      for (const Vertex& v : mesh_.vertices) x.push_back(is_corner(v.x) ? v.x - 10 * share * Vec3{1, 1, 1} : v.x);
      return x;
    };
    return reach_of(mesh_, places, 1, smallest);
  }

private:
  static bool is_corner(const Vec3& x) { return x[0] > 0.5 && x[1] > 0.5 && x[2] > 0.5; }

  TetMesh mesh_;
};

TEST(Reach, IsHalvedUntilAllTetrahedraArePositive) {
  const Reach reach = Corner(1).reach(0.01);
  EXPECT_EQ(reach.share, 1.0 / 16);
  EXPECT_EQ(reach.places.size(), 8U);
  EXPECT_TRUE(reach.in_the_way);
}

TEST(Reach, GoesBelowTheSmallestShareWhileEdgesChangeMuch) {
  EXPECT_EQ(Corner(1).reach(0.5).share, 1.0 / 16);
  EXPECT_EQ(Corner(0.1).reach(1).share, 1.0 / 16);
}

TEST(Reach, IsNoneIfEdgesChangeLittle) {
  const Reach reach = Corner(10).reach(0.5);
  EXPECT_EQ(reach.share, 0);
  EXPECT_TRUE(reach.in_the_way);
}

}  // namespace
}  // namespace taut::test
