// A mesh under adaptation with all that belongs to it.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "geometry/carry.hpp"
#include "geometry/model.hpp"
#include "locate/background.hpp"
#include "mesh/tet_mesh.hpp"
#include "sizing/target.hpp"

namespace taut {

/// Outlives a call: after vertices have been moved from outside, it is refreshed, not built anew.
struct Session {
  TetMesh mesh;  ///< with metrics, hosts and qualities
  Model model;
  std::unique_ptr<const Background> background;  ///< the input
  std::unique_ptr<Target> target;
  std::vector<VertexId> vertex_of_point;   ///< in the background; `none` for a point that belongs to no tetrahedron
  std::vector<std::uint32_t> tet_of_cell;  ///< of the input

  /// Sets the quality of every tetrahedron.
  void measure_qualities();

  /// Brings up to date what depends on the places of vertices that were moved: their metrics and hosts, the patches and
  /// lines that they span, and the qualities of their tetrahedra. Where these change, at once or little by little,
  /// operations are worth trying again; all edges are measured again. The mesh must be without dead entities and stay
  /// valid.
  void refresh(std::span<const VertexId> moved);

  /// The same where some have moved rigidly, and the target has changed for more vertices than have moved.
  void refresh(std::span<const VertexId> moved, const RigidMoves& rigid, std::span<const VertexId> in_another_target);

  /// The same where only metrics have changed.
  void refresh_metrics(std::span<const VertexId> changed);
};

}  // namespace taut
