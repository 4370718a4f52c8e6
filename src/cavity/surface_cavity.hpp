// The triangles and feature edges that a cavity removes and creates: the cavity operator one dimension lower.
#pragma once

#include <array>
#include <span>

#include "cavity/outcome.hpp"
#include "geometry/model.hpp"
#include "mesh/tet_mesh.hpp"

namespace taut {

/// The vertex to which a cavity is connected: a vertex of the mesh, or one that will be created.
struct Apex {
  VertexId id = none;
  Vertex vertex{};
  Tag tag{};
  CellId host = none;  ///< of one about to be made
  SeatId seat = none;  ///< on the reference surface: where to begin to search
};

/// A vertex of the mesh as apex.
[[nodiscard]] inline Apex apex_at(const TetMesh& mesh, VertexId v) {
  return {v, mesh.vertices[v], mesh.tag_of_vertex[v], mesh.host_of_vertex[v], mesh.seat_of_vertex[v]};
}

/// Within each patch, connects the border edges of the removed triangles to the apex; within each line, the end points
/// of the removed feature edges.
class SurfaceCavity {
public:
  static constexpr int capacity = 48;

  /// A new triangle (apex, a, b), oriented like those that it replaces.
  struct Border {
    VertexId a, b;
    PatchId patch;
    LineId line_ab, line_bp, line_pa;
    TriangleId made;
  };

  void clear() { removed_size_ = border_size_ = edge_size_ = end_size_ = 0; }
  [[nodiscard]] bool empty() const { return removed_size_ == 0; }
  [[nodiscard]] bool remove(TriangleId t);
  [[nodiscard]] Outcome rejoin(const TetMesh& mesh, const Model& model, const Apex& apex, VertexId gone);

  [[nodiscard]] int border_size() const { return border_size_; }
  [[nodiscard]] Border& border(int i) { return border_[i]; }
  [[nodiscard]] const Border& border(int i) const { return border_[i]; }
  /// The border with end points a and b in either order, or -1.
  [[nodiscard]] int find_border(VertexId a, VertexId b) const;
  [[nodiscard]] std::span<const TriangleId> removed() const {
    return {removed_.data(), static_cast<std::size_t>(removed_size_)};
  }

private:
  struct Edge {
    VertexId a, b;
    PatchId patch;
    LineId line;
    int count;
  };
  struct End {  // of feature edges removed from a patch
    VertexId v;
    PatchId patch;
    LineId line;
    bool open;
    bool stays;   // so does an edge there
    int missing;  // new triangles with an edge from there to the apex
  };

  [[nodiscard]] bool fits(const TetMesh& mesh, const Model& model, const Apex& apex) const;
  void add_edge(const Edge& edge);
  void toggle_end(VertexId v, const Edge& edge, bool stays);
  [[nodiscard]] bool take_feature(const Model& model, const Edge& edge, VertexId apex);
  [[nodiscard]] bool ends_agree(VertexId gone) const;
  [[nodiscard]] LineId line_to(VertexId v, PatchId patch);

  int removed_size_ = 0, border_size_ = 0, edge_size_ = 0, end_size_ = 0;
  std::array<TriangleId, capacity> removed_{};
  std::array<Border, capacity> border_{};
  std::array<Edge, 3 * capacity> edges_{};
  std::array<End, 6 * capacity> ends_{};
};

}  // namespace taut
