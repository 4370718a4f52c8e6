// What every operation needs: the mesh, its constraints, and the scratch data of a worker.
#pragma once

#include "cavity/cavity.hpp"
#include "cavity/collect.hpp"
#include "cavity/face_batch.hpp"
#include "geometry/model.hpp"
#include "mesh/tet_mesh.hpp"
#include "metric/length.hpp"
#include "partition/block.hpp"
#include "sizing/target.hpp"

namespace taut {

inline void note_length(Tet& tet, int edge, double length) {
  tet.state.tried.set_length(edge, length > longest_unit, length < shortest_unit);
}

/// Each worker has its own; what it refers to is shared.
struct Kernel {
  TetMesh& mesh;
  const Model& model;
  const Target& target;
  Block* block = nullptr;  ///< all that may be changed, and all that may be read of what others may change

  Cavity cavity{};
  Shell shell{};
  FaceBatch batch{};           ///< of the candidates of a swap, or the ball of a relocation
  VertexBatch neighbours{};    ///< of a vertex to be relocated
  double efficiency_gain = 0;  ///< sum, over the edges of moved vertices, of what they add to the mean of eq. (2)
  SmallMap<256> spared{};      ///< tetrahedra found not to be in conflict with a new vertex

  [[nodiscard]] double length(VertexId a, VertexId b) const {
    const Vertex &p = mesh.vertices[a], &q = mesh.vertices[b];
    return edge_length_fast(p.x, q.x, p.m, q.m);
  }

  [[nodiscard]] Apex apex_at(VertexId v) const { return taut::apex_at(mesh, v); }

  /// Re-joins what was collected in `cavity.tets` to the apex; see Cavity::rejoin.
  template <class Judge>
  Outcome rejoin(const Apex& apex, VertexId gone, Judge judge) {
    return cavity.rejoin(mesh, model, *block, apex, gone, judge);
  }

  /// Whether one of the tetrahedra must be kept as it is.
  [[nodiscard]] bool any_frozen(std::span<const TetId> tets) const {
    if (!model.has_frozen_region) return false;
    for (TetId t : tets)
      if (model.regions[mesh.region_of_tet[t]].frozen) return true;
    return false;
  }

  /// Records on every tetrahedron of the shell that its edge was tried and refused.
  Outcome mark_shell(Trial kind, Outcome outcome) {
    if (outcome == Outcome::accepted || outcome == Outcome::put_off) return outcome;
    for (int i = 0; i < shell.size; ++i) mesh.tets[shell.tets[i]].state.tried.set(kind, shell.edges[i]);
    return outcome;
  }

  [[nodiscard]] std::span<const TetId> shell_tets() const {
    return {shell.tets.data(), static_cast<std::size_t>(shell.size)};
  }
};

}  // namespace taut
