// Conjugate gradients for the mass matrix.
#include <cmath>
#include <vector>

#include "base/parallel.hpp"
#include "transfer/system.hpp"

namespace taut {
namespace {

// A condition number of 5 needs 36 steps for 16 digits. Where the source covers only a corner of a support it is worse.
constexpr int most_iterations = 100;
constexpr double tolerance = 1e-16;  // of the residual relative to the right-hand side, in the norm of the diagonal

using Vector = std::vector<double>;

template <class Term>
double sum_over(const Vector& x, const Term& term) {
  return sum_in_order<double>(x.size(), [&](double& sum, std::size_t i) { sum += term(i); });
}

class Solver {
public:
  explicit Solver(const System& system) : system_(system), inverse_diagonal_(system.size(), 0) {
    for_each_index(system.size(), [&](std::size_t i) {
      if (const auto row = system_.row(i); !row.empty()) inverse_diagonal_[i] = 1 / row[0].value;
    });
  }

  // Improves x until the residual is rounding.
  void run(const Vector& right, Vector& x) const {
    const std::size_t n = x.size();
    Vector residual(n), direction(n), image(n);
    multiply(x, residual);
    for_each_index(n, [&](std::size_t i) {
      residual[i] = right[i] - residual[i];
      direction[i] = inverse_diagonal_[i] * residual[i];
    });
    double square = sum_over(x, [&](std::size_t i) { return residual[i] * direction[i]; });
    const double scale = sum_over(x, [&](std::size_t i) { return right[i] * right[i] * inverse_diagonal_[i]; });
    for (int step = 0; step < most_iterations && square > tolerance * tolerance * scale; ++step) {
      multiply(direction, image);
      const double curvature = sum_over(x, [&](std::size_t i) { return direction[i] * image[i]; });
      if (!(curvature > 0)) return;
      const double length = square / curvature;
      const double next = sum_in_order<double>(n, [&](double& sum, std::size_t i) {
        x[i] += length * direction[i];
        residual[i] -= length * image[i];
        sum += residual[i] * residual[i] * inverse_diagonal_[i];
      });
      const double keep = next / square;
      square = next;
      for_each_index(n,
                     [&](std::size_t i) { direction[i] = inverse_diagonal_[i] * residual[i] + keep * direction[i]; });
    }
  }

private:
  void multiply(const Vector& x, Vector& result) const {
    for_each_index(x.size(), [&](std::size_t i) {
      double sum = 0;
      for (const auto& [column, value] : system_.row(i)) sum += value * x[column];
      result[i] = sum;
    });
  }

  const System& system_;
  Vector inverse_diagonal_;
};

}  // namespace

Values solve(const System& system, const Values& start) {
  const Solver solver(system);
  Values result = start;
  Vector right(system.size()), x(system.size());
  for (std::size_t c = 0; c < start.size; ++c) {
    for_each_index(x.size(), [&](std::size_t i) {
      right[i] = system.row(i).empty() ? 0 : system.moments[i][c];
      x[i] = start[i][c];
    });
    solver.run(right, x);
    for_each_index(x.size(), [&](std::size_t i) { result[i][c] = x[i]; });
  }
  return result;
}

}  // namespace taut
