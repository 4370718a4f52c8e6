// The mesh that an adaptation began with, as a place to look things up.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/ids.hpp"
#include "base/vec3.hpp"
#include "mesh/tet_mesh.hpp"

namespace taut {

/// Weights of the vertices of a cell: none negative, of sum 1.
using Weights = std::array<double, 4>;

/// A copy of points and cells: whatever becomes of the mesh, vertex v and tetrahedron h of it stay vertex v and cell h
/// of this.
class Background {
public:
  explicit Background(const TetMesh& mesh);

  [[nodiscard]] std::size_t point_count() const { return points_.size(); }
  [[nodiscard]] std::size_t cell_count() const { return cells_.size(); }
  [[nodiscard]] const std::array<VertexId, 4>& vertices_of(CellId cell) const { return cells_[cell].v; }

  /// Walks from `host` to the cell that x lies in, which becomes `host`, and returns where in it x lies. A point
  /// outside the domain, as rounding on an oblique face gives, is taken to the nearest place of the cell where the
  /// search ends.
  [[nodiscard]] Weights locate(const Vec3& x, CellId& host) const;

private:
  struct Cell {
    std::array<VertexId, 4> v;
    std::array<CellId, 4> beyond;  ///< cell behind each face; `none` at the boundary
  };

  [[nodiscard]] Weights barycentric(CellId cell, const Vec3& x) const;
  [[nodiscard]] bool walk(const Vec3& x, CellId& host, Weights& weights) const;
  void search_around(const Vec3& x, CellId& host, Weights& weights) const;

  std::vector<Vec3> points_;
  std::vector<Cell> cells_;
};

}  // namespace taut
