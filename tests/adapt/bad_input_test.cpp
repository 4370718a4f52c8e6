// Input that cannot be used is refused, with a message that names the place.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mesh/shapes.hpp"
#include "metric/random_metrics.hpp"
#include "taut/adapt.hpp"

namespace taut {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

void expect_refused(const Mesh& mesh, const Metric& metric, const AdaptOptions& options,
                    const std::vector<std::string>& words) {
  try {
    (void)adapt(mesh, metric, options);
    ADD_FAILURE() << "not refused: " << words[0];
  } catch (const InputError& error) {
    const std::string message = error.what();
    for (const std::string& word : words)
      EXPECT_NE(message.find(word), std::string::npos) << message << "\nlacks " << word;
    EXPECT_EQ(message.find('\n'), std::string::npos) << "one line";
  }
}

template <class Damage>
void expect_mesh_refused(Damage damage, const std::vector<std::string>& words) {
  Mesh mesh = test::cube(2);
  damage(mesh);
  expect_refused(mesh, Sizes(mesh.points.size(), 0.3), {}, words);
}

TEST(BadInput, Meshes) {
  expect_mesh_refused([](Mesh& m) { m.tetrahedra.clear(); }, {"no tetrahedra"});
  expect_mesh_refused([](Mesh& m) { m.tetrahedra[3][0] = 27; }, {"tetrahedron 4", "28", "1..27"});
  expect_mesh_refused([](Mesh& m) { m.triangles[3][0] = 27; }, {"triangle 4", "28", "1..27"});
  expect_mesh_refused([](Mesh& m) { m.points[13][0] = nan; }, {"vertex 14", "not finite"});
  expect_mesh_refused([](Mesh& m) { m.points[13][2] = -infinity; }, {"vertex 14", "not finite"});
  expect_mesh_refused([](Mesh& m) { m.points[13] = m.points[0]; }, {"tetrahedron", "flat"});
  expect_mesh_refused([](Mesh& m) { m.tetrahedra[3][0] = m.tetrahedra[3][1]; }, {"tetrahedron 4", "repeats vertex"});
  expect_mesh_refused([](Mesh& m) { m.tetrahedra.push_back(m.tetrahedra[9]); }, {"face", "more than two tetrahedra"});
  expect_mesh_refused([](Mesh& m) { m.triangles[5] = {0, 13, 26}; }, {"triangle 6", "not a face"});
  expect_mesh_refused([](Mesh& m) { m.edges = {{0, 26}, {8, 18}}; }, {"edge", "not an edge"});
  expect_mesh_refused([](Mesh& m) { m.required_tetrahedra = {48}; }, {"required tetrahedron 1", "49", "1..48"});
  expect_mesh_refused([](Mesh& m) { m.tetrahedron_refs = {1}; }, {"references", "48"});
}

void expect_metric_refused(const Metric& metric, const std::vector<std::string>& words) {
  expect_refused(test::cube(2), metric, {}, words);
}

Sizes sizes_with(double h) {
  Sizes sizes(27, 0.3);
  sizes[11] = h;
  return sizes;
}

Tensors tensors_with(const Tensor& m) {
  Tensors tensors(27, metric_of_size(0.3));
  tensors[11] = m;
  return tensors;
}

TEST(BadInput, Metrics) {
  expect_metric_refused(Sizes(26, 0.3), {"26", "27"});
  expect_metric_refused(Tensors(28, metric_of_size(0.3)), {"28", "27"});
  expect_metric_refused(Sizes{}, {"0", "27"});
  for (const double h : {0.0, -0.3, nan, infinity}) expect_metric_refused(sizes_with(h), {"metric", "vertex 12:"});
  expect_metric_refused(tensors_with({1, 0, 0, 1, 0, -1}), {"metric", "vertex 12:", "positive definite"});
  expect_metric_refused(tensors_with({1, 2, 0, 1, 0, 1}), {"metric", "vertex 12:", "positive definite"});
  expect_metric_refused(tensors_with({0, 0, 0, 0, 0, 0}), {"metric", "vertex 12:", "positive definite"});
  expect_metric_refused(tensors_with({1, 0, nan, 1, 0, 1}), {"metric", "vertex 12:"});
  expect_metric_refused(tensors_with({infinity, 0, 0, 1, 0, 1}), {"metric", "vertex 12:"});
  expect_metric_refused(MetricFunction{}, {"metric"});
  expect_metric_refused(
      MetricFunction([](const Point& x) { return x[0] > 0.4 ? Tensor{-1, 0, 0, 1, 0, 1} : identity3; }),
      {"metric", "positive definite"});
}

TEST(BadInput, AFunctionThatFailsBetweenTheVerticesIsRefusedToo) {
  // Valid only at the vertices of the input, which are at multiples of 1/2.
  const MetricFunction function = [](const Point& x) {
    for (const double c : x)
      if (c != 0 && c != 0.5 && c != 1) return Tensor{nan, 0, 0, 1, 0, 1};
    return metric_of_size(0.1);
  };
  expect_metric_refused(function, {"metric"});
}

TEST(BadInput, Options) {
  const Mesh mesh = test::cube(2);
  const Metric metric = Sizes(27, 0.3);
  const auto expect_option_refused = [&](auto set, const std::string& word) {
    AdaptOptions options;
    set(options);
    expect_refused(mesh, metric, options, {word});
  };
  expect_option_refused([](AdaptOptions& o) { o.limits.hmin = -1; }, "hmin");
  expect_option_refused([](AdaptOptions& o) { o.limits.hmin = nan; }, "hmin");
  expect_option_refused([](AdaptOptions& o) { o.limits.hmax = 0; }, "hmax");
  expect_option_refused([](AdaptOptions& o) { o.limits.hmin = 2, o.limits.hmax = 1; }, "hmax");
  expect_option_refused([](AdaptOptions& o) { o.limits.hmax = nan; }, "hmax");
  for (const double beta : {1.0, nan, infinity})
    expect_option_refused([beta](AdaptOptions& o) { o.limits.gradation = Gradation{.beta = beta}; }, "gradation: beta");
  for (const double mix : {-0.1, nan, 1.1})
    expect_option_refused([mix](AdaptOptions& o) { o.limits.gradation = Gradation{.mix = mix}; }, "gradation: mix");
  expect_option_refused([](AdaptOptions& o) { o.ridge_angle = 0; }, "angle");
  expect_option_refused([](AdaptOptions& o) { o.ridge_angle = 180; }, "angle");
  expect_option_refused([](AdaptOptions& o) { o.max_rounds = -1; }, "-1 rounds");
}

}  // namespace
}  // namespace taut
