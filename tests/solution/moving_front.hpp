// An unsteady run whose solver knows the solution: a spherical front that runs from a corner of a cube.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "mesh/expect_equal.hpp"
#include "taut/unsteady.hpp"
#include "transfer/meshes.hpp"

namespace taut::test {

inline double radius_of_front(double time) {
  return 0.3 + 0.6 * time;
}

inline double moving_front(const Point& p, double time) {
  return std::tanh(10 * (norm(p) - radius_of_front(time)));
}

/// The front, and two fields that only transfers change: a linear and a smooth one.
inline std::vector<Field> state_at_zero(const Mesh& mesh) {
  return {sampled_field(mesh, [](const Point& p) { return moving_front(p, 0); }), sampled_field(mesh, linear_function),
          sampled_field(mesh, smooth_function)};
}

/// Four steps, which sample the front as it moves.
inline void advance_front(Interval& interval) {
  constexpr int steps = 4;
  const double dt = (interval.end - interval.begin) / steps;
  for (int step = 1; step <= steps; ++step) {
    const double time = interval.begin + step * dt;
    interval.state[0] = sampled_field(*interval.mesh, [&](const Point& p) { return moving_front(p, time); });
    interval.sample(interval.state[0].values, dt);
  }
}

inline UnsteadyOptions front_options() {
  return {.times = {0, 0.3, 0.6, 1}, .iterations = 2, .sizing = {.complexity = 12 * 200, .limits = {.hmax = 0.5}}};
}

inline void expect_same_result(const UnsteadyResult& a, const UnsteadyResult& b) {
  ASSERT_EQ(a.meshes.size(), b.meshes.size());
  for (std::size_t i = 0; i < a.meshes.size(); ++i) expect_equal(*a.meshes[i], *b.meshes[i]);
  ASSERT_EQ(a.state.size(), b.state.size());
  for (std::size_t f = 0; f < a.state.size(); ++f) EXPECT_EQ(a.state[f].values, b.state[f].values);
  EXPECT_EQ(a.iterations.back().complexity, b.iterations.back().complexity);
}

}  // namespace taut::test
