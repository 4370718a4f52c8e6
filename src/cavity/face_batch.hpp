// Oriented triangles that are gathered once and then evaluated, as bases of tetrahedra, for one apex after another, in
// vector form.
#pragma once

#include <array>
#include <cstddef>

#include "mesh/tet_mesh.hpp"

namespace taut {

/// Structure of arrays: the compiler turns the loops over it into vector instructions.
class FaceBatch {
public:
  static constexpr int capacity = 192;

  void clear() { size_ = 0; }
  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] bool full() const { return size_ == capacity; }
  void push(const Vertex& a, const Vertex& b, const Vertex& c);

  /// For each face abc: `volume` = det(a-p, b-p, c-p), six times the volume of the tetrahedron pabc, and
  /// `quality` = 1/Q of it (Dobrzynski and Frey 2008, 2.3, with M_K the mean of the four metrics; negative if
  /// inverted).
  void evaluate(const Vertex& apex);

  /// Whether every face sees p, up to rounding: what evaluate() finds without the metric of p.
  [[nodiscard]] bool all_see(const Vec3& p) const;

  /// Whether every quality is above the bound.
  [[nodiscard]] bool all_above(double bound) const {
    for (int i = 0; i < size_; ++i)
      if (!(quality[i] > bound)) return false;
    return true;
  }

  alignas(64) std::array<double, capacity> volume{};
  alignas(64) std::array<double, capacity> quality{};
  alignas(64) std::array<double, capacity> doubtful_volume{};  ///< up to this size, the sign of `volume` is not certain

private:
  int size_ = 0;
  alignas(64) double x_[9][capacity]{};  // ax ay az bx by bz cx cy cz
  alignas(64) double m_[6][capacity]{};  // sum of the three metrics
};

}  // namespace taut
