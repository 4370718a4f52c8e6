// The arithmetic of unknowns at vertices: one number, or one vector.
#pragma once

#include <array>
#include <cstddef>

#include "base/conjugate_gradients.hpp"
#include "base/sym3.hpp"

namespace taut {

/// -div(w grad a) = 0.
struct Diffusion {};

/// -div sigma(u) = 0, sigma = 2 mu e(u) + lambda tr e(u) I, for Young's modulus 1. A common factor of the moduli makes
/// no difference to displacements.
struct LinearElastic {
  double poisson_ratio = 0.3;  ///< above -1, below 1/2

  [[nodiscard]] double lambda() const { return poisson_ratio / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio)); }
  [[nodiscard]] double mu() const { return 0.5 / (1 + poisson_ratio); }
};

/// For unknowns of type Value: the entries of a matrix, and orthogonal projectors on the directions in which an unknown
/// is free.
template <class Value>
struct Algebra;

template <>
struct Algebra<double> {
  using Block = double;
  using Projector = double;
  using Law = Diffusion;
  static constexpr int components = 1;
  static constexpr Projector all = 1;

  /// Adds the entry of an element for two of its vertices.
  static void add(Block& block, const Law& /*law*/, double weight, const Vec3& row, const Vec3& column) {
    block += weight * dot(row, column);
  }
  static void add(Block& block, const Block& other) { block += other; }
  static void add_product(double& sum, const Block& block, double x) { sum += block * x; }
  static double component(double value, int /*i*/) { return value; }
  static double entry(const Block& block, int /*i*/, int /*j*/) { return block; }
  static Block projected(const Projector& left, const Block& block, const Projector& right) {
    return left * block * right;
  }
  static Block regular(const Block& block, const Projector& free) { return free == 0 ? 1 : block; }
  static Projector inverse(const Block& block, const Projector& free) { return free == 0 ? 0 : 1 / block; }
};

template <>
struct Algebra<Vec3> {
  using Block = std::array<double, 9>;  // by rows
  using Projector = Sym3;
  using Law = LinearElastic;
  static constexpr int components = 3;
  static constexpr Projector all = identity3;

  // Transposing the pair of vertices transposes the result to the bit, so matrices are exactly symmetric.
  static void add(Block& block, const Law& law, double weight, const Vec3& row, const Vec3& column) {
    const double lambda = law.lambda() * weight, mu = law.mu() * weight;
    const double trace = mu * dot(row, column);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) block[3 * i + j] += lambda * (row[i] * column[j]) + mu * (row[j] * column[i]);
      block[4 * i] += trace;
    }
  }
  static void add(Block& block, const Block& other) {
    for (std::size_t k = 0; k < block.size(); ++k) block[k] += other[k];
  }
  static void add_product(Vec3& sum, const Block& b, const Vec3& x) {
    for (std::size_t i = 0; i < 3; ++i) sum[i] += b[3 * i] * x[0] + b[3 * i + 1] * x[1] + b[3 * i + 2] * x[2];
  }
  static double component(const Vec3& value, int i) { return value[static_cast<std::size_t>(i)]; }
  static double entry(const Block& block, int i, int j) {
    return block[3 * static_cast<std::size_t>(i) + static_cast<std::size_t>(j)];
  }
  /// P B P' for the projectors of a row and of a column.
  static Block projected(const Projector& left, const Block& block, const Projector& right);
  /// Of a diagonal block: P D P where the unknown is free, and something of the same size where it is not.
  static Block regular(const Block& block, const Projector& free);
  /// Of a diagonal block: the inverse of P D P where the unknown is free, and zero where it is not.
  static Projector inverse(const Block& block, const Projector& free);

private:
  static double size_of(const Block& diagonal) {
    const double trace = diagonal[0] + diagonal[4] + diagonal[8];
    return trace == 0 ? 1 : trace;
  }
};

inline Algebra<Vec3>::Block Algebra<Vec3>::projected(const Projector& left, const Block& block,
                                                     const Projector& right) {
  Block result;
  for (std::size_t j = 0; j < 3; ++j) {
    Vec3 unit{}, image{};
    unit[j] = 1;
    add_product(image, block, right * unit);
    image = left * image;
    for (std::size_t i = 0; i < 3; ++i) result[3 * i + j] = image[i];
  }
  return result;
}

inline Algebra<Vec3>::Block Algebra<Vec3>::regular(const Block& block, const Projector& free) {
  Block result = projected(free, block, free);
  const Sym3 rest = size_of(block) * (identity3 + (-1.0) * free);
  const Block fixed = {rest[0], rest[1], rest[2], rest[1], rest[3], rest[4], rest[2], rest[4], rest[5]};
  for (std::size_t k = 0; k < fixed.size(); ++k) result[k] += fixed[k];
  return result;
}

// In the unit of the block, so that the determinant neither overflows nor vanishes.
inline Algebra<Vec3>::Projector Algebra<Vec3>::inverse(const Block& block, const Projector& free) {
  const double size = size_of(block);
  const Block r = regular(block, free);
  const Sym3 unit = (1 / size) * Sym3{r[0], r[1], r[2], r[4], r[5], r[8]};
  return (1 / size) * ((1 / determinant(unit)) * adjugate(unit) + free + (-1.0) * identity3);
}

}  // namespace taut
