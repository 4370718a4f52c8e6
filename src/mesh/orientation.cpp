#include "mesh/orientation.hpp"

#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <tuple>

namespace taut {
namespace {

using boost::multiprecision::cpp_int;
using boost::multiprecision::int512_t;

/// x = mantissa 2^exponent, mantissa odd or zero.
struct Scaled {
  std::int64_t mantissa;
  int exponent;
};

Scaled scaled(double x) {
  int exponent = 0;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
  if (mantissa == 0) return {0, 0};
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
  return {mantissa / (std::int64_t{1} << zeros), exponent - 53 + zeros};
}

using ScaledPoints = std::array<std::array<Scaled, 3>, 4>;

/// The lowest exponent, and the number of bits of the largest coordinate above it.
struct Range {
  int lowest = std::numeric_limits<int>::max();
  int highest = std::numeric_limits<int>::min();
};

Range range_of(const ScaledPoints& points) {
  Range r;
  for (const auto& point : points) {
    for (const auto& [mantissa, exponent] : point) {
      if (mantissa == 0) continue;
      r.lowest = std::min(r.lowest, exponent);
      const auto magnitude = static_cast<std::uint64_t>(mantissa < 0 ? -mantissa : mantissa);
      r.highest = std::max(r.highest, exponent + static_cast<int>(std::bit_width(magnitude)));
    }
  }
  return r;
}

template <class Integer>
int sign_of_determinant(const ScaledPoints& points, int lowest) {
  std::array<std::array<Integer, 3>, 4> x;
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 3; ++k) {
      const auto& [mantissa, exponent] = points[i][k];
      if (mantissa != 0) x[i][k] = Integer(mantissa) * (Integer(1) << static_cast<unsigned>(exponent - lowest));
    }
  }
  for (int i = 1; i < 4; ++i)
    for (int k = 0; k < 3; ++k) x[i][k] -= x[0][k];
  const auto& [u, v, w] = std::tie(x[1], x[2], x[3]);
  const Integer det =
      u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
  return det.sign();
}

}  // namespace

int exact_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  ScaledPoints points{};
  for (int k = 0; k < 3; ++k) {
    points[0][k] = scaled(a[k]), points[1][k] = scaled(b[k]);
    points[2][k] = scaled(c[k]), points[3][k] = scaled(d[k]);
  }
  const Range range = range_of(points);
  if (range.lowest > range.highest) return 0;  // all coordinates are zero
  // Six products of three differences need 3 (bits + 1) + 3 bits, which almost always fit into a type without
  // allocation.
  const bool fits = 3 * (range.highest - range.lowest + 1) + 3 < 512;
  return fits ? sign_of_determinant<int512_t>(points, range.lowest)
              : sign_of_determinant<cpp_int>(points, range.lowest);
}

}  // namespace taut
