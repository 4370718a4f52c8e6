#include "surface/jet.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace taut {
namespace {

constexpr double points_per_coefficient = 1.5;
constexpr double most_turn_of_degree = 0.3;  ///< of the normal, as a slope, by a higher degree
constexpr double gain_of_degree = 0.8;  ///< the largest part of the error of prediction that a higher degree may leave
// Of the normal equations scaled to a unit diagonal: the square of the sine of the angle between a monomial and the
// span of those before it, as the points see them. What is smaller belongs to a polynomial that they do not see.
constexpr double smallest_pivot_of_jet = 1e-4;
constexpr double smallest_eigenvalue_of_jet = 1e-6;  ///< as a share of the largest: again a polynomial that is not seen

/// Without the constant term.
constexpr int coefficients_of(int degree) {
  return (degree + 1) * (degree + 2) / 2 - 1;
}

using Quadratic = Eigen::Matrix<double, coefficients_of(2), 1>;  ///< of u, v, u^2, sqrt(2) u v, v^2

/// Coordinates u, v along the plane in which the neighbours are about as far in all directions.
struct TangentFrame {
  Vec3 normal, of_u, of_v;  ///< u = of_u . x
};

Vec3 some_direction_across(const Vec3& normal) {
  std::size_t least = 0;
  for (std::size_t d = 1; d < 3; ++d)
    if (std::abs(normal[d]) < std::abs(normal[least])) least = d;
  Vec3 axis{};
  axis[least] = 1;
  const Vec3 across = cross(normal, axis);
  return 1 / norm(across) * across;
}

/// By the factor of the matrix of second moments. None if the neighbours lie on one line.
std::optional<TangentFrame> frame_around(const Vec3& normal, std::span<const Vec3> offsets) {
  const Vec3 e = some_direction_across(normal), f = cross(normal, e);
  double ee = 0, ef = 0, ff = 0;
  for (const Vec3& d : offsets) {
    const double x = dot(e, d), y = dot(f, d), share = 1 / static_cast<double>(offsets.size());
    ee += share * x * x, ef += share * x * y, ff += share * y * y;
  }
  const double rest = ff - ef * ef / ee;
  if (!(ee > 0) || !(rest > 1e-12 * ff)) return {};
  return TangentFrame{normal, 1 / std::sqrt(ee) * e, 1 / std::sqrt(rest) * (f - ef / ee * e)};
}

/// u^a v^b by ascending degree, times the square root of the binomial coefficient: then the size of a polynomial's
/// coefficients does not depend on the directions of u and v.
template <int degree>
Eigen::Matrix<double, coefficients_of(degree), 1> monomials(double u, double v) {
  static_assert(degree <= 4);
  constexpr double r2 = 1.4142135623730951, r3 = 1.7320508075688772, r6 = 2.449489742783178;
  constexpr std::array<double, 14> roots = {1, 1, 1, r2, 1, 1, r3, r3, 1, 1, 2, r6, 2, 1};
  Eigen::Matrix<double, coefficients_of(degree), 1> row;
  std::array<double, degree + 1> u_to = {1}, v_to = {1};
  int at = 0;
  for (int d = 1; d <= degree; ++d) {
    u_to[d] = u * u_to[d - 1];
    v_to[d] = v * v_to[d - 1];
    for (int b = 0; b <= d; ++b, ++at) row[at] = roots[at] * u_to[d - b] * v_to[b];
  }
  return row;
}

struct Sample {
  double u, v, height, weight;
};

std::vector<Sample> samples_of(const TangentFrame& frame, std::span<const Vec3> offsets, double tolerance) {
  std::vector<Sample> samples;
  samples.reserve(offsets.size());
  for (const Vec3& d : offsets) {
    const double u = dot(frame.of_u, d), v = dot(frame.of_v, d), height = dot(frame.normal, d);
    samples.push_back({u, v, std::abs(height) > tolerance ? height : 0, 1 / std::max(u * u + v * v, 0.25)});
  }
  return samples;
}

struct Fit {
  Quadratic lower_part;  ///< of the coefficients those of degree 1 and 2
  /// The sum of squares of what the fit to all other samples would miss each one by, weighted (Allen 1974).
  double prediction_error = 0;
};

/// Of a weighted least squares fit.
template <int degree>
class NormalEquations {
  static constexpr int size = coefficients_of(degree);
  using Square = Eigen::Matrix<double, size, size>;
  using Column = Eigen::Matrix<double, size, 1>;

public:
  explicit NormalEquations(std::span<const Sample> samples) : samples_(samples) {
    for (const Sample& s : samples) {
      const Column row = weighted_row(s);
      for (int i = 0; i < size; ++i) matrix_.col(i) += row[i] * row;
      right_ += s.weight * s.height * row;
    }
  }

  /// None if the samples do not determine it.
  [[nodiscard]] std::optional<Fit> fit() const {
    const Eigen::LLT<Square> factor(matrix_);
    if (factor.info() != Eigen::Success) return {};
    for (int i = 0; i < size; ++i)
      if (!(std::pow(factor.matrixLLT()(i, i), 2) > smallest_pivot_of_jet * matrix_(i, i))) return {};
    const Column coefficients = factor.solve(right_);
    return Fit{coefficients.template head<coefficients_of(2)>(), prediction_error(factor, coefficients)};
  }

  /// The least coefficients that fit: without the eigenvectors that the samples do not see.
  [[nodiscard]] Column least_coefficients() const {
    const Eigen::SelfAdjointEigenSolver<Square> solver(matrix_);
    const double least = smallest_eigenvalue_of_jet * solver.eigenvalues()[size - 1];
    Column along = solver.eigenvectors().transpose() * right_;
    for (int i = 0; i < size; ++i) along[i] = solver.eigenvalues()[i] > least ? along[i] / solver.eigenvalues()[i] : 0;
    return solver.eigenvectors() * along;
  }

private:
  static Column weighted_row(const Sample& s) { return s.weight * monomials<degree>(s.u, s.v); }

  [[nodiscard]] double prediction_error(const Eigen::LLT<Square>& factor, const Column& coefficients) const {
    double sum = 0;
    for (const Sample& s : samples_) {
      const Column row = weighted_row(s), seen = factor.matrixL().solve(row);
      const double leverage = std::min(seen.squaredNorm(), 1 - 1e-12);
      sum += std::pow((s.weight * s.height - row.dot(coefficients)) / (1 - leverage), 2);
    }
    return sum;
  }

  std::span<const Sample> samples_;
  Square matrix_ = Square::Zero();
  Column right_ = Column::Zero();
};

/// How much the normals of two fits differ, as a slope.
double turn_between(const TangentFrame& frame, const Quadratic& a, const Quadratic& b) {
  return norm((a[0] - b[0]) * frame.of_u + (a[1] - b[1]) * frame.of_v);
}

/// The fit of this degree, if there are points enough and it predicts clearly better. On rows of points that are almost
/// straight one can predict all points and still have any slope between the rows: no smooth surface turns so much more
/// than a fit of lower degree.
template <int degree>
Fit better(const Fit& best, const TangentFrame& frame, std::span<const Sample> samples) {
  if (static_cast<double>(samples.size()) < points_per_coefficient * coefficients_of(degree)) return best;
  const auto higher = NormalEquations<degree>(samples).fit();
  const bool is_better = higher && higher->prediction_error < gain_of_degree * gain_of_degree * best.prediction_error &&
                         turn_between(frame, higher->lower_part, best.lower_part) < most_turn_of_degree;
  return is_better ? *higher : best;
}

/// Of all coefficients those of degree 1 and 2.
Quadratic best_coefficients(const TangentFrame& frame, std::span<const Sample> samples) {
  const NormalEquations<2> quadratic(samples);
  const auto fit = quadratic.fit();
  if (!fit) return quadratic.least_coefficients();
  return better<4>(better<3>(*fit, frame, samples), frame, samples).lower_part;
}

}  // namespace

Derivatives jet(const Vec3& normal, std::span<const Vec3> offsets, double tolerance) {
  const auto frame = frame_around(normal, offsets);
  if (!frame) return {normal, {}};
  const Quadratic c = best_coefficients(*frame, samples_of(*frame, offsets, tolerance));
  const Vec3 &a = frame->of_u, &b = frame->of_v;
  const double uv = std::sqrt(2.0) * c[3];
  const Sym3 mixed = outer(a + b) + -1 * outer(a) + -1 * outer(b);
  return {normal - c[0] * a - c[1] * b, -2 * c[2] * outer(a) + -uv * mixed + -2 * c[4] * outer(b)};
}

}  // namespace taut
