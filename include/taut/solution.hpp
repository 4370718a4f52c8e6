// From a solution on a mesh to the adapted mesh with the solution on it, in one call.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "taut/adapt.hpp"
#include "taut/export.hpp"
#include "taut/field.hpp"
#include "taut/local_sizes.hpp"
#include "taut/mesh.hpp"
#include "taut/sizing.hpp"
#include "taut/transfer.hpp"

namespace taut {

/// How a mesh is adapted to a solution. Only `sizing.complexity` has to be set.
struct SolutionOptions {
  LpOptions sizing{};  ///< the wanted complexity, the norm, limits on the metric
  LocalSizes local{};  ///< added to the metric that has the complexity; then limits apply again
  Recovery recovery = Recovery::least_squares;  ///< of the Hessians
  AdaptOptions adapt{};                         ///< without limits, which `sizing` holds; its threads serve all steps
  TransferOptions transfer{};                   ///< of all fields to the adapted mesh
};

/// The adapted mesh and what belongs to it.
struct SolutionResult {
  AdaptResult adapted;         ///< the mesh, and the metric on it
  std::vector<Field> fields;   ///< at the points of the adapted mesh, in the order and of the kinds of the input
  double complexity = 0;       ///< of the metric on the input mesh
  std::string stopped_by;      ///< as in ScaledMetric
  TransferReport transferred;  ///< empty for Transfer::linear, which needs no search
  std::vector<std::pair<std::string, double>> seconds;  ///< elapsed time: "sizing", "adapt", "transfer"
};

/// Recovers the Hessians of all scalars and of all components of vectors in `fields`, makes the L^p metric of them
/// (lp_metric(); what is linear does not count beside others), adapts the mesh to it and transfers all fields, tensors
/// too. Local sizes make the complexity differ from the one that was asked for. One call does not reach the fixed
/// point: solve on the new mesh and call again, a few times. If a callback of `adapt` asks to stop, the fields are
/// still transferred, to the mesh as it is then. Throws InputError for input that cannot be used, with a message that
/// starts with "fields: " or "local sizes: " if it is about these, and for limits in `adapt`.
[[nodiscard]] TAUT_EXPORT SolutionResult adapt_to_solution(const Mesh& mesh, const std::vector<Field>& fields,
                                                           const SolutionOptions& options);

}  // namespace taut
