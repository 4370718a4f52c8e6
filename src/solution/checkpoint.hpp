// The progress of an unsteady run in a folder.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "taut/field.hpp"
#include "taut/mesh.hpp"
#include "taut/space_time.hpp"

namespace taut {

/// What an unsteady run knows between two sub-intervals.
struct UnsteadyProgress {
  std::size_t iteration = 0;
  std::vector<std::shared_ptr<const Mesh>> meshes;  ///< of this iteration, by sub-interval
  std::vector<SubInterval> done;                    ///< the sub-intervals that have been computed
  std::vector<Field> state;                         ///< on the mesh of the last of them; empty before the first
};

/// A folder that holds the progress of a run over given times, or nothing if its name is empty. Files are complete or
/// absent, and one small file that is written last says which of them count.
class Checkpoint {
public:
  Checkpoint(std::filesystem::path folder, std::vector<double> times)
      : folder_(std::move(folder)), times_(std::move(times)) {}

  [[nodiscard]] bool exists() const;

  /// `mesh` is the one that all sub-intervals of the first iteration have in common. Throws InputError, naming the file
  /// that is damaged, or does not belong to a run from this mesh over these times.
  [[nodiscard]] UnsteadyProgress read(const std::shared_ptr<const Mesh>& mesh) const;

  /// The meshes of a new iteration; of the first one, only that it has begun. Throws Failure.
  void write_meshes(const UnsteadyProgress& progress) const;

  /// The last sub-interval that is done. Throws Failure.
  void write_last(const UnsteadyProgress& progress) const;

private:
  [[nodiscard]] std::filesystem::path file(const char* what, std::size_t iteration, std::size_t interval,
                                           const char* extension) const;
  void write_summary(const UnsteadyProgress& progress) const;

  std::filesystem::path folder_;
  std::vector<double> times_;
};

}  // namespace taut
