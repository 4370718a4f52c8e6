// The files that `taut move` writes while it runs.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "move_job.hpp"
#include "step_names.hpp"
#include "taut/io.hpp"

namespace taut::program {

class MoveFiles {
public:
  /// `displacements` are read too. Throws InputError unless all files can be written, each to a name of its own that
  /// none of those has which are read.
  MoveFiles(const MoveJob& job, std::span<const std::string> displacements);

  /// Whether a step is among those to be written.
  [[nodiscard]] bool wants(std::size_t step) const;

  /// Writes the mesh, and what else is asked for, as it is after `step`.
  void write(const MovingMesh& mesh, std::size_t step);

  /// The name of the mesh file of a step.
  [[nodiscard]] std::string mesh_name(std::size_t step) const { return meshes_(step); }

  /// The name of the file that lists the others; empty if there is none.
  [[nodiscard]] const std::string& pvd() const { return pvd_; }

private:
  StepNames meshes_;
  std::optional<StepNames> fields_, metrics_;
  std::string pvd_;
  std::size_t steps_, every_;
  std::vector<TimedFile> written_;
};

}  // namespace taut::program
