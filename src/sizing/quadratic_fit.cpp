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

// L D L^T, with the right-hand side reduced alongside. Only the last six unknowns are solved for.
std::optional<Sym3> QuadraticFit::hessian() const {
  std::array<Row, unknowns> a = matrix_;
  Row b = right_, scale;
  for (std::size_t i = 0; i < unknowns; ++i) scale[i] = 1 / matrix_[i][i];
  for (std::size_t k = 0; k < unknowns; ++k) {
    if (!(a[k][k] * scale[k] > smallest_pivot)) return {};
    const double inverse = 1 / a[k][k];
    for (std::size_t i = k + 1; i < unknowns; ++i) {
      const double factor = a[i][k] * inverse;
      for (std::size_t j = k + 1; j <= i; ++j) a[i][j] -= factor * a[j][k];
      b[i] -= factor * b[k];
    }
  }
  Row c{};
  for (std::size_t i = unknowns; i-- > 4;) {
    double rest = b[i];
    for (std::size_t j = i + 1; j < unknowns; ++j) rest -= a[j][i] * c[j];
    c[i] = rest / a[i][i];
  }
  return from_frame({2 * c[4], c[5], c[6], 2 * c[7], c[8], 2 * c[9]});
}

// xi = C^-1 d, so the Hessian is C^-T H C^-1.
Sym3 QuadraticFit::from_frame(const Sym3& h) const {
  return congruent(h, [&](const Vec3& b) { return solve_transposed(frame_, b); });
}

}  // namespace taut
