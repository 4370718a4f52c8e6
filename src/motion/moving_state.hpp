// What a MovingMesh is made of, and how it does a step.
#pragma once

#include <vector>

#include "adapt/session.hpp"
#include "motion/follow.hpp"
#include "taut/motion.hpp"

namespace taut {

class MovingMesh::State {
public:
  State(const Mesh& mesh, const Metric& metric, const MotionOptions& options);

  /// Does as much of the step as can be done.
  [[nodiscard]] Advance advance(const Goal& goal, std::span<const int> bodies);

  void set_metric(const Metric& metric);

  const MotionOptions options;
  Mesh mesh;
  Tensors metric;
  std::vector<Field> fields;
  std::vector<Point> displacements;  ///< of the mesh in the last step, by point

private:
  [[nodiscard]] Boundary boundary_for(const Goal& goal, std::span<const int> bodies) const;
  [[nodiscard]] bool do_part(const Goal& goal, std::span<const int> bodies, Advance& done);
  void move_to(const std::vector<Vec3>& places);
  [[nodiscard]] bool move_metric(const Goal& goal, std::span<const int> bodies, double share);
  void refresh(const std::vector<std::uint32_t>& changed);
  void refresh_all();
  void optimise(bool vertices_may_change, Advance& done);
  void renew_mesh(Advance& done);
  void transfer_to(const Mesh& next, Advance& done);
  [[nodiscard]] std::string place_of(TetId tet) const;

  Session session_;
  Follower follower_;
  RigidMotion metric_placement_;
};

}  // namespace taut
