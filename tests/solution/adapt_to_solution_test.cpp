// From a solution to the adapted mesh with the solution on it.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/with_threads.hpp"
#include "metric/spectral.hpp"
#include "taut/quality.hpp"
#include "taut/solution.hpp"
#include "transfer/meshes.hpp"

namespace taut {
namespace {

using test::linear_function;
using test::sampled_field;

double tanh_front(const Point& p) {
  return 2 + std::tanh(20 * (p[0] - 0.5 + 0.2 * p[1]));
}

Field of_components(const Mesh& mesh, Field::Kind kind) {
  Field field{.kind = kind, .values = {}};
  for (const Point& p : mesh.points)
    for (std::size_t k = 0; k < field.size(); ++k) field.values.push_back(linear_function(p) + static_cast<double>(k));
  return field;
}

/// A front, and linear fields of every kind, which are transferred but do not count.
class AdaptToSolution : public testing::Test {
protected:
  const Mesh mesh = test::shaken_cube(8, 1);
  std::vector<Field> fields = {sampled_field(mesh, tanh_front), sampled_field(mesh, linear_function),
                               of_components(mesh, Field::Kind::vector), of_components(mesh, Field::Kind::tensor)};
  SolutionOptions options{.sizing = {.complexity = 300, .limits = {.gradation = Gradation{}}}};

  [[nodiscard]] SolutionResult adapted() const { return adapt_to_solution(mesh, fields, options); }

  void expect_refused(const std::string& message) {
    EXPECT_EQ(test::refusal(2, [&] { return adapted(); }), message);
  }

  void expect_linear_fields_kept(const SolutionResult& result) const {
    const Mesh& to = result.adapted.mesh;
    ASSERT_EQ(result.fields.size(), fields.size());
    for (std::size_t f = 1; f < fields.size(); ++f) {
      const Field& field = result.fields[f];
      EXPECT_EQ(field.kind, fields[f].kind);
      ASSERT_EQ(field.values.size(), to.points.size() * field.size());
      for (std::size_t i = 0; i < field.values.size(); ++i) {
        const std::size_t v = i / field.size(), k = i % field.size();
        ASSERT_NEAR(field.values[i], linear_function(to.points[v]) + static_cast<double>(k), 1e-12) << f;
      }
    }
  }
};

TEST_F(AdaptToSolution, TakesLocalSizesAndGradesThem) {
  const SolutionResult before = adapted();
  options.local.tetrahedra = {{0, {.max = 0.12}}};
  const SolutionResult after = adapted();
  EXPECT_GT(after.complexity, 1.2 * before.complexity);
  EXPECT_GT(after.adapted.mesh.points.size(), before.adapted.mesh.points.size());
  for (const Tensor& m : after.adapted.metric) EXPECT_GT(spectrum(m).values[0], std::pow(0.12, -2) * (1 - 1e-6));
  expect_linear_fields_kept(after);
  options.local.tetrahedra = {{5, {.max = 0.12}}};
  expect_refused("local sizes: tetrahedra.5: none of the mesh's 3072 tetrahedra has this reference");
}

TEST_F(AdaptToSolution, HasTheComplexity) {
  const SolutionResult result = adapted();
  EXPECT_NEAR(result.complexity, 300, 0.002 * 300 * 1.01);
  EXPECT_EQ(result.stopped_by, "");
  EXPECT_NEAR(complexity(result.adapted.mesh, result.adapted.metric), 300, 60);
  EXPECT_NEAR(static_cast<double>(result.adapted.mesh.tetrahedra.size()), 300 * tetrahedra_per_complexity, 800);
  EXPECT_EQ(defects(result.adapted.mesh), std::vector<std::string>{});
  std::vector<std::string> steps;
  for (const auto& [step, seconds] : result.seconds) steps.push_back(step);
  EXPECT_EQ(steps, (std::vector<std::string>{"sizing", "adapt", "transfer"}));
}

TEST_F(AdaptToSolution, KeepsIntegralsAndLinearFields) {
  const SolutionResult result = adapted();
  expect_linear_fields_kept(result);
  ASSERT_EQ(result.transferred.fields.size(), 4U);
  for (const auto& components : result.transferred.fields)
    for (const ComponentReport& c : components)
      EXPECT_NEAR(c.mass_after, c.mass_before, 1e-12 * std::abs(c.mass_before));
}

TEST_F(AdaptToSolution, InterpolatesIfAsked) {
  options.transfer.method = Transfer::linear;
  const SolutionResult result = adapted();
  expect_linear_fields_kept(result);
  EXPECT_TRUE(result.transferred.fields.empty());
}

TEST_F(AdaptToSolution, WhatIsLinearDoesNotCount) {
  const std::uint64_t all = adapted().adapted.report.hash;
  fields.resize(1);
  EXPECT_EQ(adapted().adapted.report.hash, all);
}

TEST_F(AdaptToSolution, IsUniformIfEverythingIsLinear) {
  fields.erase(fields.begin());
  const SolutionResult result = adapted();
  for (const Tensor& m : result.adapted.metric)
    EXPECT_LT(test::distance(m, metric_of_size(std::cbrt(1.0 / 300))), 5e-3);
}

TEST_F(AdaptToSolution, SaysWhatStopsIt) {
  options.sizing.limits = {.hmin = 0.2};
  const SolutionResult result = adapted();
  EXPECT_EQ(result.stopped_by, "hmin");
  EXPECT_NEAR(result.complexity, 125, 1);
}

TEST_F(AdaptToSolution, GivesTheSameBitsOnAnyNumberOfThreads) {
  options.adapt.threads = 1;
  const SolutionResult one = adapted();
  options.adapt.threads = 3;
  const SolutionResult three = adapted();
  EXPECT_EQ(one.adapted.report.hash, three.adapted.report.hash);
  for (std::size_t f = 0; f < fields.size(); ++f) EXPECT_EQ(one.fields[f].values, three.fields[f].values);
}

TEST_F(AdaptToSolution, TransfersToTheMeshOfACancelledAdaptation) {
  int passes = 0;
  options.adapt.progress = [&](const Progress&) { return ++passes < 3; };
  const SolutionResult result = adapted();
  EXPECT_TRUE(result.adapted.report.cancelled);
  EXPECT_EQ(defects(result.adapted.mesh), std::vector<std::string>{});
  expect_linear_fields_kept(result);
}

TEST_F(AdaptToSolution, RefusesFieldsThatCannotBeUsed) {
  fields[2].values.pop_back();
  expect_refused("fields: field 3: 2186 values found, expected 3 for each of 729 vertices");
  fields[2] = of_components(mesh, Field::Kind::vector);
  fields[3].values[6 * 7 + 1] = std::nan("");
  expect_refused("fields: field 4: vertex 8, component 2: nan found, expected a finite number");
  fields = {of_components(mesh, Field::Kind::tensor)};
  expect_refused("fields: only tensors found, expected a scalar or a vector");
  fields.clear();
  expect_refused("fields: none found, expected at least one");
}

TEST_F(AdaptToSolution, RefusesOptionsThatMakeNoSense) {
  options.sizing.complexity = 0;
  expect_refused("complexity 0 found, expected a number above 0");
  options.sizing.complexity = 300;
  options.adapt.limits.hmax = 0.5;
  expect_refused("limits in the options of the adaptation found, expected them in those of the sizing");
  options.adapt.limits = {};
  options.adapt.max_rounds = -1;
  expect_refused("-1 rounds found, expected 0 or more");
}

}  // namespace
}  // namespace taut
