// Where the points of a result lie in the input.
#include <gtest/gtest.h>

#include "adapt/checks.hpp"
#include "adapt/fields.hpp"

namespace taut {
namespace {

Point placed(const Mesh& mesh, const Host& host) {
  Point p{};
  for (std::size_t k = 0; k < 4; ++k) p = p + host.weights[k] * mesh.points[mesh.tetrahedra[host.tetrahedron][k]];
  return p;
}

// A point on a curved patch, or close to one, may lie outside the flat triangles of the input by about their sag. Its
// host is then one nearby.
class Hosts : public testing::TestWithParam<Surface> {
protected:
  static constexpr double sag_of_ball = 0.06;
  [[nodiscard]] double tolerance(bool is_ball, const Host& host) const {
    const bool is_inside = *std::ranges::min_element(host.weights) > 1e-12;
    return is_ball && GetParam() == Surface::adapt && !is_inside ? sag_of_ball : 1e-9;
  }
};

INSTANTIATE_TEST_SUITE_P(All, Hosts, testing::Values(Surface::adapt, Surface::planar),
                         [](const testing::TestParamInfo<Surface>& i) {
                           return i.param == Surface::adapt ? "adapt" : "planar";
                         });

TEST_P(Hosts, TellWhereEachPointLiesInTheInput) {
  for (const bool by_function : {true, false}) {
    const Mesh ball = test::ball(test::cube(6));
    for (Mesh mesh : {test::cube(6), test::two_regions(6), test::l_shape(6), ball}) {
      const bool is_ball = mesh.points == ball.points;
      test::jitter(mesh, 0.02, 1);
      for (std::size_t t = 0; t < mesh.tetrahedra.size(); t += 3)
        std::swap(mesh.tetrahedra[t][0], mesh.tetrahedra[t][2]);
      const MetricFunction field = test::front(0.3, 0.6);
      const Metric metric = by_function ? Metric(field) : Metric(test::sampled(mesh, field));
      const AdaptResult result = adapt(mesh, metric, {.surface = GetParam(), .max_rounds = 6});
      ASSERT_EQ(result.hosts.size(), result.mesh.points.size());
      for (std::size_t p = 0; p < result.hosts.size(); ++p) {
        const Host& host = result.hosts[p];
        ASSERT_LT(host.tetrahedron, mesh.tetrahedra.size());
        double sum = 0;
        for (const double w : host.weights) {
          sum += w;
          EXPECT_GE(w, 0);
        }
        EXPECT_NEAR(sum, 1, 1e-15);
        EXPECT_LT(norm(placed(mesh, host) - result.mesh.points[p]), tolerance(is_ball, host)) << "point " << p;
      }
    }
  }
}

TEST(MetricFunction, IsCheckedWhereItIsCalled) {
  const auto field = [](const Point& p) -> Tensor {
    const bool is_bad = p[0] > 0.52 && p[0] < 0.6 && p[1] > 0.1;  // between the points of the input
    return {is_bad ? std::nan("") : 400, 0, 0, 400, 0, 400};
  };
  for (const int threads : {1, 3}) {
    try {
      (void)adapt(test::cube(4), field, {.threads = threads, .block_size = 200});
      FAIL() << "the metric is nowhere checked";
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("metric: at (0.5")) << error.what();
    }
  }
}

}  // namespace
}  // namespace taut
