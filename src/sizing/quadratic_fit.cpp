#include "sizing/quadratic_fit.hpp"

#include <algorithm>
#include <cmath>

namespace taut {
namespace {

// Of the normal equations scaled to a unit diagonal: the square of the sine of the angle between a monomial and the
// span of those before it, as the points see them. Below it, a fit through the points is free to wave between them.
constexpr double smallest_pivot = 4e-4;

}  // namespace

QuadraticFit::QuadraticFit(const Vec3& centre, double value, const Sym3& moment)
    : centre_(centre), value_(value), frame_(cholesky(3 * moment)) {}

QuadraticFit::Row QuadraticFit::monomials(const Vec3& xi) const {
  const auto& [x, y, z] = xi;
  return {1, x, y, z, x * x, x * y, x * z, y * y, y * z, z * z};
}

void QuadraticFit::add(const Vec3& x, double value) {
  const Vec3 xi = solve(frame_, x - centre_);
  const double weight = 1 / std::max(dot(xi, xi), 0.25);
  const Row row = monomials(xi);
  for (std::size_t i = 0; i < unknowns; ++i) {
    const double weighted = weight * row[i];
    right_[i] += weighted * (value - value_);
    for (std::size_t j = 0; j <= i; ++j) matrix_[i][j] += weighted * row[j];
  }
}

// L D L^T, with the right-hand side reduced alongside.
std::optional<QuadraticFit::Row> QuadraticFit::coefficients() const {
  std::array<Row, unknowns> a = matrix_;
  Row c = right_;
  for (std::size_t k = 0; k < unknowns; ++k) {
    if (!(a[k][k] > smallest_pivot * matrix_[k][k])) return {};
    const double inverse = 1 / a[k][k];
    for (std::size_t i = k + 1; i < unknowns; ++i) {
      const double factor = a[i][k] * inverse;
      for (std::size_t j = k + 1; j <= i; ++j) a[i][j] -= factor * a[j][k];
      c[i] -= factor * c[k];
    }
  }
  for (std::size_t i = unknowns; i-- > 0;) {
    for (std::size_t j = i + 1; j < unknowns; ++j) c[i] -= a[j][i] * c[j];
    c[i] /= a[i][i];
  }
  return c;
}

// The place in the frame is C^-1 d, so the gradient is C^-T g and the Hessian C^-T H C^-1.
std::optional<Derivatives> QuadraticFit::derivatives() const {
  const auto found = coefficients();
  if (!found) return {};
  const Row& c = *found;
  const auto from_frame = [&](const Vec3& b) { return solve_transposed(frame_, b); };
  return Derivatives{from_frame({c[1], c[2], c[3]}),
                     congruent({2 * c[4], c[5], c[6], 2 * c[7], c[8], 2 * c[9]}, from_frame)};
}

}  // namespace taut
