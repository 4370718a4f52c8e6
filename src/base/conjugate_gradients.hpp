// Conjugate gradients on several threads, for one number or one vector at each vertex.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "base/parallel.hpp"
#include "base/vec3.hpp"

namespace taut {

/// So that one text fits numbers and vectors.
constexpr double dot(double a, double b) {
  return a * b;
}

/// Rows of a sparse matrix in one task: as few as pay for the start of the task, so that the last ones end together.
[[nodiscard]] inline Chunks chunks_of_rows(std::size_t rows) {
  return Chunks(rows, std::size_t{1} << 10);
}

struct StopAt {
  double residual = 1e-8;  ///< relative
  int iterations = 1000;
};

struct Convergence {
  int iterations = 0;
  double residual = 0;  ///< relative; not a number if the matrix or the start is not finite
};

/// Adds to x the solution of A d = residual. row(i, d) is row i of A d; precondition(r, z) sets z = M^-1 r and returns
/// r.z, the square of the norm in which residuals are measured, here relative to the square root of `scale`.
/// Both A and M are symmetric and positive definite, at least on the space of the residuals.
template <class Value, class Row, class Precondition>
Convergence conjugate_gradients(std::vector<Value>& x, std::vector<Value> residual, double scale, const Row& row,
                                const Precondition& precondition, const StopAt& stop) {
  const Chunks rows = chunks_of_rows(x.size());
  std::vector<Value> scaled(x.size()), image(x.size());
  double square = precondition(std::span<const Value>(residual), std::span<Value>(scaled));
  std::vector<Value> direction = scaled;
  int step = 0;
  for (; step < stop.iterations && square > stop.residual * stop.residual * scale; ++step) {
    const double curvature = sum_in_order<double>(rows, [&](double& sum, std::size_t i) {
      image[i] = row(i, direction);
      sum += dot(direction[i], image[i]);
    });
    if (!(curvature > 0)) break;
    const double length = square / curvature;
    for_each_index(rows, [&](std::size_t i) {
      x[i] = x[i] + length * direction[i];
      residual[i] = residual[i] - length * image[i];
    });
    const double next = precondition(std::span<const Value>(residual), std::span<Value>(scaled));
    const double keep = next / square;
    square = next;
    for_each_index(rows, [&](std::size_t i) { direction[i] = scaled[i] + keep * direction[i]; });
  }
  return {step, square == 0 ? 0 : std::sqrt(square / scale)};
}

}  // namespace taut
