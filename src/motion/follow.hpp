// How the inside of a mesh follows its boundary.
#pragma once

#include <optional>
#include <vector>

#include "elasticity/vertex_system.hpp"
#include "motion/goal.hpp"
#include "motion/step.hpp"
#include "taut/motion.hpp"

namespace taut {

/// Solves for the motion of all vertices, and remembers what helps it to solve the next time.
class Follower {
public:
  explicit Follower(const MotionOptions& options) : options_(options) {}

  /// The places of the vertices after each share of the goal. Throws Failure if the solver does not converge. The
  /// result refers to the mesh, the boundary and the goal.
  [[nodiscard]] Places places(const TetMesh& mesh, const Boundary& boundary, const Goal& goal);

  /// Solver iterations so far.
  [[nodiscard]] int iterations() const { return iterations_; }

  /// Must be called when tetrahedra have changed.
  void forget_connectivity() { graph_.reset(); }

private:
  [[nodiscard]] Places elastic(const TetMesh& mesh, const Boundary& boundary, const Goal& goal);
  [[nodiscard]] Places by_shares(const TetMesh& mesh, const Boundary& boundary, const Goal& goal);
  [[nodiscard]] std::vector<double> share_of(const ShareSystem& system, const TetMesh& mesh, const Boundary& boundary,
                                             std::size_t body);
  template <class Value>
  [[nodiscard]] std::vector<Value> solved(const VertexSystem<Value>& system,
                                          const std::vector<Constraint<Value>>& constraints,
                                          const std::vector<Value>& start);

  const MotionOptions& options_;
  std::optional<VertexGraph> graph_;
  int iterations_ = 0;
  std::vector<Vec3> last_velocities_;             // by point
  std::vector<std::vector<double>> last_shares_;  // by body and point
};

}  // namespace taut
