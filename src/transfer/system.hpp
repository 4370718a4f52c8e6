// The equations of the projection at the vertices of the target mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "transfer/integrals.hpp"

namespace taut {

/// By target vertex: the rows of the mass matrix, its sums, the right-hand sides and the bounds. All are integrals over
/// what the source covers; a vertex around which nothing is covered has an empty row and volume 0.
struct System {
  struct Entry {
    std::uint32_t column;
    double value;
  };

  std::vector<std::size_t> first;  ///< row i has the entries first[i] to first[i + 1], the diagonal first
  std::vector<Entry> entries;      ///< m_ij and m_ji have the same bits
  std::vector<double> volume;      ///< integral of each vertex's weight: the sum of its row, but for rounding
  Values moments;                  ///< integral of the weight times the field
  Values least, greatest;          ///< of the source's values around the vertex

  [[nodiscard]] std::size_t size() const { return volume.size(); }
  [[nodiscard]] std::span<const Entry> row(std::size_t i) const {
    return {entries.data() + first[i], first[i + 1] - first[i]};
  }
};

[[nodiscard]] System assemble(const Integrals& integrals, const Background& target);

/// The solution of the mass matrix for each component of the moments, from `start` on: conjugate gradients, scaled by
/// the diagonal (Wathen 1987: the condition number is at most 5 where all is covered). Rows of volume 0 keep `start`.
[[nodiscard]] Values solve(const System& system, const Values& start);

}  // namespace taut
