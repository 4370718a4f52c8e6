// Places all over a surface at which something is measured.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/vec3.hpp"
#include "taut/surface_mesh.hpp"

namespace taut {

/// The nodes of a regular subdivision of each triangle, row by row.
class Samples {
public:
  /// Edges are divided into parts no longer than `spacing`, and into at least `divisions` of them.
  Samples(const SurfaceMesh& surface, double spacing, int divisions);

  /// Of all triangles together.
  [[nodiscard]] std::size_t rows() const { return first_row_.back(); }

  /// Calls visit(place, share) for the nodes of a row. The shares of all nodes of a triangle add up to its area; with
  /// them, sums are integrals by the rule of the vertices on each part.
  template <class Visitor>
  void for_each_in_row(std::size_t row, const Visitor& visit) const {
    const Row at = locate(row);
    const auto n = static_cast<double>(at.divisions);
    for (std::size_t k = 0; k <= at.divisions - at.row; ++k) {
      const Vec3 x = at.origin + (static_cast<double>(at.row) / n) * at.up + (static_cast<double>(k) / n) * at.along;
      visit(x, at.area / (n * n) * static_cast<double>(parts_at(at, k)) / 3);
    }
  }

private:
  struct Row {
    Vec3 origin, along, up;
    double area;
    std::size_t row, divisions;
  };

  /// The number of parts of the subdivision that meet at a node.
  static std::size_t parts_at(const Row& at, std::size_t k) {
    const int sides = (at.row == 0) + (k == 0) + (at.row + k == at.divisions);
    return sides == 0 ? 6 : sides == 1 ? 3 : 1;
  }
  [[nodiscard]] Row locate(std::size_t row) const;

  const SurfaceMesh& surface_;
  std::vector<std::size_t> first_row_;  ///< of each triangle, and the number of all rows
};

}  // namespace taut
