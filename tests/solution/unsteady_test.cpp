// The fixed point of an unsteady run.
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "base/with_threads.hpp"
#include "solution/moving_front.hpp"
#include "taut/quality.hpp"

namespace taut {
namespace {

using test::advance_front;
using test::front_options;
using test::refusal;
using test::state_at_zero;

class Unsteady : public testing::Test {
protected:
  const Mesh mesh = test::cube(8);
  UnsteadyOptions options = front_options();

  [[nodiscard]] UnsteadyResult result() const {
    return unsteady_fixed_point(mesh, state_at_zero, advance_front, options);
  }

  void expect_refused(const std::string& message) const {
    EXPECT_EQ(refusal(2, [&] { return result(); }), message);
  }

  /// `advance` is what a broken solver does after the first time step.
  void expect_solver_refused(const std::function<void(Interval&)>& advance, const std::string& message) const {
    const auto solver = [&](Interval& interval) {
      advance_front(interval);
      if (interval.index == 1) advance(interval);
    };
    EXPECT_EQ(refusal(2, [&] { return unsteady_fixed_point(mesh, state_at_zero, solver, options); }), message);
  }
};

/// Tetrahedra per volume where the front passes between two times, over that elsewhere: 1 for a uniform mesh.
double refinement(const Mesh& mesh, double begin, double end) {
  std::array<double, 2> count{}, volume{};
  for (const auto& t : mesh.tetrahedra) {
    const auto& x = mesh.points;
    const double r = norm(test::centre_of(mesh, t));
    const bool inside = r > test::radius_of_front(begin) - 0.1 && r < test::radius_of_front(end) + 0.1;
    ++count[inside];
    volume[inside] += six_volumes(x[t[0]], x[t[1]], x[t[2]], x[t[3]]);
  }
  return count[1] / volume[1] * volume[0] / count[0];
}

TEST_F(Unsteady, EveryMeshIsFineWhereTheFrontPasses) {
  const UnsteadyResult found = result();
  ASSERT_EQ(found.meshes.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(defects(*found.meshes[i]), std::vector<std::string>{});
    EXPECT_GT(refinement(*found.meshes[i], options.times[i], options.times[i + 1]), 1.7) << i;
  }
}

TEST_F(Unsteady, ReportsEveryIteration) {
  const UnsteadyResult found = result();
  ASSERT_EQ(found.iterations.size(), 2U);
  for (const IterationReport& report : found.iterations) {
    EXPECT_NEAR(report.complexity, options.sizing.complexity, 0.00201 * options.sizing.complexity);
    EXPECT_EQ(report.stopped_by, "");
    EXPECT_EQ(report.tetrahedra.size(), 3U);
  }
  EXPECT_EQ(found.iterations[0].tetrahedra[1], mesh.tetrahedra.size());
  EXPECT_EQ(found.iterations[1].tetrahedra[1], found.meshes[1]->tetrahedra.size());
}

TEST_F(Unsteady, TheStateIsTransferredFromMeshToMesh) {
  const UnsteadyResult found = result();
  const Mesh& last = *found.meshes.back();
  EXPECT_EQ(test::largest_error(last, found.state[0], [](const Point& p) { return test::moving_front(p, 1); }), 0);
  EXPECT_LT(test::largest_error(last, found.state[1], test::linear_function), 1e-12);
  EXPECT_GT(test::largest_error(last, found.state[2], test::smooth_function), 0);
  EXPECT_LT(test::error_norm(last, found.state[2], test::smooth_function), 0.08);
}

TEST_F(Unsteady, TheSolverSeesTimeInOrder) {
  std::vector<std::array<double, 4>> seen;
  const auto watching = [&](Interval& i) {
    seen.push_back({static_cast<double>(i.iteration), static_cast<double>(i.index), i.begin, i.end});
    advance_front(i);
  };
  (void)unsteady_fixed_point(mesh, state_at_zero, watching, options);
  EXPECT_EQ(seen,
            (std::vector<std::array<double, 4>>{
                {0, 0, 0, 0.3}, {0, 1, 0.3, 0.6}, {0, 2, 0.6, 1}, {1, 0, 0, 0.3}, {1, 1, 0.3, 0.6}, {1, 2, 0.6, 1}}));
}

TEST_F(Unsteady, OneSubIntervalHasOneMesh) {
  options.times = {0, 1};
  options.sizing.complexity = 4 * 300;
  const UnsteadyResult found = result();
  ASSERT_EQ(found.meshes.size(), 1U);
  EXPECT_GT(refinement(*found.meshes[0], 0, 1), 2);
}

TEST_F(Unsteady, OneIterationStaysOnTheMesh) {
  options.iterations = 1;
  for (const auto& m : result().meshes) test::expect_equal(*m, mesh);
}

TEST_F(Unsteady, HasTheSameBitsOnAnyNumberOfThreads) {
  const auto on = [&](int threads) { return test::with_threads(threads, [&] { return result(); }); };
  test::expect_same_result(on(1), on(3));
}

TEST_F(Unsteady, WhatTheSolverThrowsReachesTheCaller) {
  const auto failing = [](Interval&) { throw std::out_of_range("blown up"); };
  EXPECT_THROW((void)unsteady_fixed_point(mesh, state_at_zero, failing, options), std::out_of_range);
}

TEST_F(Unsteady, RefusesOptionsThatMakeNoSense) {
  options.times = {0};
  expect_refused("1 times found, expected two or more");
  options.times = {0, 0.5, 0.5};
  expect_refused("time 0.5 found after 0.5, expected a later one");
  options.times = {0, std::numeric_limits<double>::infinity()};
  expect_refused("time inf found, expected a finite number");
  options.times = {0, 1};
  options.iterations = 0;
  expect_refused("0 iterations found, expected 1 or more");
  options.iterations = 1;
  options.sizing.complexity = -1;
  expect_refused("complexity -1 found, expected a number above 0");
  options.sizing.complexity = 100;
  options.adapt.limits.hmin = 0.1;
  expect_refused("limits in the options of the adaptation found, expected them in those of the sizing");
}

TEST_F(Unsteady, RefusesAStateThatDoesNotFit) {
  const auto few = [](const Mesh&) { return std::vector<Field>{{Field::Kind::scalar, {1, 2}}}; };
  EXPECT_EQ(refusal(1, [&] { return unsteady_fixed_point(mesh, few, advance_front, options); }),
            "sub-interval 1: state at the begin: fields: field 1: 2 values found, expected 1 for each of 729 vertices");
  expect_solver_refused(
      [](Interval& i) { i.state[1].values[4] = std::nan(""); },
      "sub-interval 2: state at the end: fields: field 2: vertex 5, component 1: nan found, expected a "
      "finite number");
  expect_solver_refused([](Interval& i) { i.state.clear(); },
                        "sub-interval 2: state at the end: fields: none found, expected at least one");
}

TEST_F(Unsteady, RefusesSamplesThatCannotBeUsed) {
  expect_solver_refused([](Interval& i) { i.collected = HessianInTime(); },
                        "sub-interval 2: no sample found, expected one per time step");
  expect_solver_refused([](Interval& i) { i.sample(i.state[0].values, 0); }, "dt 0 found, expected a number above 0");
  expect_solver_refused([](Interval& i) { i.sample(std::vector<double>{1}, 1); },
                        "field: 1 values for 729 vertices, expected one per vertex");
}

}  // namespace
}  // namespace taut
