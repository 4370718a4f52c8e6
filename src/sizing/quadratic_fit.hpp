// A quadratic function fitted to values at scattered points.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "base/sym3.hpp"
#include "metric/cholesky.hpp"
#include "surface/derivatives.hpp"

namespace taut {

/// Weighted least squares with 10 unknowns, in a frame in which the points around the centre are about as far in all
/// directions: without the frame the problem would be singular on stretched meshes.
class QuadraticFit {
public:
  /// `moment` is the mean of d d^T over the neighbours of the centre, d their distances from it.
  QuadraticFit(const Vec3& centre, double value, const Sym3& moment);

  /// Adds a point with the weight 1 / max(|xi|^2, 1/4), xi its place in the frame.
  void add(const Vec3& x, double value);

  /// Of the function at the centre, unless the points determine it badly: if they lie close to a quadric.
  [[nodiscard]] std::optional<Derivatives> derivatives() const;

private:
  static constexpr std::size_t unknowns = 10;  // 1, the place, its products xx, xy, xz, yy, yz, zz
  using Row = std::array<double, unknowns>;

  [[nodiscard]] Row monomials(const Vec3& xi) const;
  [[nodiscard]] std::optional<Row> coefficients() const;

  Vec3 centre_;
  double value_;
  Cholesky frame_;
  std::array<Row, unknowns> matrix_{};  ///< normal equations, lower triangle
  Row right_{};
};

}  // namespace taut
