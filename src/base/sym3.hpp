// Symmetric 3x3 tensors, with entries in the order of taut::Tensor: xx, xy, xz, yy, yz, zz.
#pragma once

#include <array>

#include "base/vec3.hpp"

namespace taut {

using Sym3 = std::array<double, 6>;

inline constexpr Sym3 identity3 = {1, 0, 0, 1, 0, 1};

constexpr Sym3 operator+(const Sym3& a, const Sym3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3], a[4] + b[4], a[5] + b[5]};
}
constexpr Sym3 operator*(double s, const Sym3& a) {
  return {s * a[0], s * a[1], s * a[2], s * a[3], s * a[4], s * a[5]};
}

/// d d^T.
constexpr Sym3 outer(const Vec3& d) {
  return {d[0] * d[0], d[0] * d[1], d[0] * d[2], d[1] * d[1], d[1] * d[2], d[2] * d[2]};
}

/// e^T M e, by Horner's rule; from single numbers, for loops over arrays that the compiler vectorises.
constexpr double quadratic_form(double m0, double m1, double m2, double m3, double m4, double m5, double x, double y,
                                double z) {
  return (m0 * x + 2 * (m1 * y + m2 * z)) * x + (m3 * y + 2 * (m4 * z)) * y + m5 * z * z;
}
constexpr double quadratic_form(const Sym3& m, const Vec3& e) {
  return quadratic_form(m[0], m[1], m[2], m[3], m[4], m[5], e[0], e[1], e[2]);
}

constexpr Vec3 operator*(const Sym3& m, const Vec3& e) {
  return {m[0] * e[0] + m[1] * e[1] + m[2] * e[2], m[1] * e[0] + m[3] * e[1] + m[4] * e[2],
          m[2] * e[0] + m[4] * e[1] + m[5] * e[2]};
}

/// det(M) M^-1.
constexpr Sym3 adjugate(const Sym3& m) {
  return {m[3] * m[5] - m[4] * m[4], m[2] * m[4] - m[1] * m[5], m[1] * m[4] - m[2] * m[3],
          m[0] * m[5] - m[2] * m[2], m[1] * m[2] - m[0] * m[4], m[0] * m[3] - m[1] * m[1]};
}

constexpr double determinant(const Sym3& m) {
  return m[0] * (m[3] * m[5] - m[4] * m[4]) - m[1] * (m[1] * m[5] - m[4] * m[2]) + m[2] * (m[1] * m[4] - m[3] * m[2]);
}

}  // namespace taut
