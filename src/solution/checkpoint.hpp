// The progress of an unsteady run in a folder.
#pragma once

#include <filesystem>
#include <memory>
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

/// A folder that holds the progress, or nothing if its name is empty. Files are complete or absent, and one small file
/// that is written last says which of them count.
class Checkpoint {
public:
  explicit Checkpoint(std::filesystem::path folder) : folder_(std::move(folder)) {}

  [[nodiscard]] bool exists() const;

  /// Throws InputError if the folder cannot be read, or holds a run of another number of sub-intervals.
  [[nodiscard]] UnsteadyProgress read(std::size_t intervals) const;

  /// The meshes of a new iteration.
  void write_meshes(const UnsteadyProgress& progress) const;

  /// The last sub-interval that is done. Throws Failure.
  void write_last(const UnsteadyProgress& progress) const;

private:
  [[nodiscard]] std::filesystem::path file(const char* what, std::size_t iteration, std::size_t interval,
                                           const char* extension) const;
  void write_summary(const UnsteadyProgress& progress) const;

  std::filesystem::path folder_;
};

}  // namespace taut
