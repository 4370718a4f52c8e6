// From a solution on a mesh to the adapted mesh with the solution on it, in one call.
#pragma once

#include <vector>

#include "taut/adapt.hpp"
#include "taut/export.hpp"
#include "taut/field.hpp"
#include "taut/mesh.hpp"
#include "taut/sizing.hpp"
#include "taut/transfer.hpp"

namespace taut {

/// How a mesh is adapted to a solution. Only `sizing.complexity` has to be set.
struct SolutionOptions {
  LpOptions sizing{};                           ///< the wanted complexity, the norm, limits on the metric
  Recovery recovery = Recovery::least_squares;  ///< of the Hessians
  AdaptOptions adapt{};                         ///< without limits, which `sizing` holds
  TransferOptions transfer{};                   ///< of all fields to the adapted mesh
};

/// The adapted mesh and what belongs to it.
struct SolutionResult {
  AdaptResult adapted;         ///< the mesh, and the metric on it
  std::vector<Field> fields;   ///< at the points of the adapted mesh, in the order and of the kinds of the input
  double complexity = 0;       ///< of the metric on the input mesh
  std::string stopped_by;      ///< as in ScaledMetric
  TransferReport transferred;  ///< empty for Transfer::linear, which needs no search
};

/// Recovers the Hessians of all scalars and of all components of vectors in `fields`, makes the L^p metric of them
/// (lp_metric()), adapts the mesh to it and transfers all fields, tensors too. One call does not reach the fixed point:
/// solve on the new mesh and call again, a few times. Throws InputError, with messages that start with "field: " if
/// they are about a field.
[[nodiscard]] TAUT_EXPORT SolutionResult adapt_to_solution(const Mesh& mesh, const std::vector<Field>& fields,
                                                           const SolutionOptions& options);

}  // namespace taut
