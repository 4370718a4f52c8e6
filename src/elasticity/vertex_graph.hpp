// Which entries the matrices of linear elements have on a mesh, and which tetrahedra contribute to each.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/buckets.hpp"
#include "mesh/tet_mesh.hpp"

namespace taut {

/// Depends on the connectivity only, so it outlives moves of the vertices. Rows and columns are vertex ids; the row of
/// a dead vertex contains nothing but its diagonal.
class VertexGraph {
public:
  /// A tetrahedron of a vertex. place[k] is where in the vertex' row the column of the tetrahedron's vertex k is.
  struct Use {
    TetId tet;
    std::uint32_t corner;  ///< the vertex itself, whose place is 0
    std::array<std::uint32_t, 4> place;
  };

  explicit VertexGraph(const TetMesh& mesh);

  [[nodiscard]] std::size_t size() const { return first_.size() - 1; }
  [[nodiscard]] std::size_t entry_count() const { return columns_.size(); }
  /// The entries of row i among all entries: first(i) to first(i + 1).
  [[nodiscard]] std::size_t first(std::size_t i) const { return first_[i]; }
  /// The diagonal, then the neighbours of the vertex in the order in which its tetrahedra name them.
  [[nodiscard]] std::span<const std::uint32_t> columns(std::size_t i) const {
    return {columns_.data() + first_[i], first_[i + 1] - first_[i]};
  }
  /// Ascending by tetrahedron.
  [[nodiscard]] std::span<const Use> uses(std::size_t i) const { return uses_[i]; }

private:
  Buckets<Use> uses_;
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> columns_;
};

}  // namespace taut
