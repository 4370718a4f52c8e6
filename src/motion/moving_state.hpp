// What a MovingMesh is made of, and how it does a step.
#pragma once

#include <optional>
#include <vector>

#include "adapt/session.hpp"
#include "motion/follow.hpp"
#include "taut/motion.hpp"

namespace taut {

class MovingState {
public:
  MovingState(const Mesh& input, const Metric& target, const MotionOptions& asked);

  /// Does as much of the step as can be done.
  [[nodiscard]] Advance advance(const Goal& goal, std::span<const int> bodies);

  void set_metric(const Metric& given);

  /// Of the points as they are now, in the last step.
  [[nodiscard]] std::vector<Point> displacements() const;

  const MotionOptions options;
  Mesh mesh;
  Tensors metric;
  std::vector<Field> fields;

private:
  [[nodiscard]] Boundary boundary_for(const Goal& goal, std::span<const int> bodies) const;
  [[nodiscard]] bool do_part(const Goal& goal, std::span<const int> bodies, Advance& done);
  [[nodiscard]] std::vector<VertexId> move_to(const std::vector<Vec3>& places);
  [[nodiscard]] bool move_metric(const Goal& goal, std::span<const int> bodies, double share);
  void take_metrics(std::span<const VertexId> changed);
  void optimise(bool vertices_may_change, Advance& done);
  void renew_mesh(Advance& done);
  void transfer_fields_to(const Mesh& next, Advance& done);

  Session session_;
  Follower follower_;
  RigidMotion metric_placement_;
  // In the last step. Transferred to the mesh as it is now only if somebody asks.
  std::vector<Point> displacements_;
  std::optional<Mesh> displaced_;  // whose points they are, if not those of `mesh`
};

}  // namespace taut
