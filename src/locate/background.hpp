// The mesh that an adaptation began with, as a place to look things up.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/ids.hpp"
#include "base/vec3.hpp"
#include "mesh/tet_mesh.hpp"

namespace taut {

/// Weights of the vertices of a cell, of sum 1; none negative, unless stated otherwise.
using Weights = std::array<double, 4>;

/// A copy of points and cells: whatever becomes of the mesh, vertex v and tetrahedron h of it stay vertex v and cell h
/// of this.
class Background {
public:
  explicit Background(const TetMesh& mesh);

  [[nodiscard]] std::size_t point_count() const { return points_.size(); }
  [[nodiscard]] std::size_t cell_count() const { return cells_.size(); }
  [[nodiscard]] const std::array<VertexId, 4>& vertices_of(CellId cell) const { return cells_[cell].v; }
  /// The cell behind each face; `none` at the boundary.
  [[nodiscard]] const std::array<CellId, 4>& neighbours_of(CellId cell) const { return cells_[cell].beyond; }
  [[nodiscard]] const Vec3& x(VertexId v) const { return points_[v]; }
  [[nodiscard]] std::array<Vec3, 4> corners_of(CellId cell) const {
    const auto& v = cells_[cell].v;
    return {points_[v[0]], points_[v[1]], points_[v[2]], points_[v[3]]};
  }
  [[nodiscard]] std::span<const Vec3> points() const { return points_; }

  /// Walks from `host` to the cell that x lies in, which becomes `host`, and returns where in it x lies. A point
  /// outside the domain, as rounding on an oblique face or a curved surface gives, is taken to a place nearby on the
  /// boundary of a cell: the best of several hundred around the end of the walk.
  [[nodiscard]] Weights locate(const Vec3& x, CellId& host) const;

  /// Walks from `host` towards x. True if x lies in the cell where the walk ends, up to rounding: no weight is below
  /// -1e-9. False if the boundary was in the way, which does not mean that x lies outside, or there was no end.
  [[nodiscard]] bool walk(const Vec3& x, CellId& host, Weights& weights) const;

  /// The weights that make up x; negative beyond a face.
  [[nodiscard]] Weights barycentric(CellId cell, const Vec3& x) const;

private:
  struct Cell {
    std::array<VertexId, 4> v;
    std::array<CellId, 4> beyond;  ///< cell behind each face; `none` at the boundary
  };

  [[nodiscard]] double miss(CellId cell, const Vec3& x, Weights weights) const;
  void search_around(const Vec3& x, CellId& host, Weights& weights) const;

  std::vector<Vec3> points_;
  std::vector<Cell> cells_;
};

}  // namespace taut
