// The bodies of a motion file as a mesh's motion in each step.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "motion_file.hpp"
#include "taut/motion.hpp"

namespace taut::program {

class MovingBodies {
public:
  /// Reads the file. Throws InputError if it cannot be used, or asks for what the options exclude.
  MovingBodies(const std::string& file, const MotionOptions& options);

  /// The references of walls on which vertices slide.
  [[nodiscard]] const std::vector<int>& sliding() const { return motion_.sliding; }

  /// The files with displacements.
  [[nodiscard]] std::vector<std::string> files() const;

  /// Throws InputError unless the mesh has triangles with all references. Reads the displacements, if there are any.
  void fit(const Mesh& mesh, const std::string& mesh_file);

  /// Does step `step`, counted from 1.
  Advance advance(MovingMesh& mesh, std::size_t step) const;

private:
  [[nodiscard]] std::vector<BodyMotion> motions_in(std::size_t step) const;

  std::string file_;
  MotionFile motion_;
  std::vector<PointMotion> points_;  // of one step, if displacements are given
};

}  // namespace taut::program
