// The fixed point of meshes and solution of an unsteady run.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "taut/adapt.hpp"
#include "taut/export.hpp"
#include "taut/field.hpp"
#include "taut/mesh.hpp"
#include "taut/sizing.hpp"
#include "taut/space_time.hpp"
#include "taut/transfer.hpp"

namespace taut {

/// What a solver has to do: to advance the solution over one sub-interval of time, on one mesh.
class TAUT_EXPORT Interval {
public:
  std::size_t iteration = 0;         ///< counted from 0
  std::size_t index = 0;             ///< of the sub-interval, counted from 0
  double begin = 0;                  ///< time at which the solver starts
  double end = 0;                    ///< time that it has to reach
  std::shared_ptr<const Mesh> mesh;  ///< on which it works; not null
  std::vector<Field> state;          ///< at the points of the mesh: at `begin`; the solver leaves that at `end`

  /// The solver calls this once in each of its time steps, with the scalar that decides on the mesh, at the points of
  /// the mesh, and the length of the step. The scalar stands for the whole step, so that from its middle is best: if
  /// all are from the ends, nothing tells of the beginning of the sub-interval. Throws InputError as recover_hessian()
  /// does.
  void sample(std::span<const double> values, double dt);

  HessianInTime collected;                      ///< what sample() collects
  Recovery recovery = Recovery::least_squares;  ///< how sample() recovers Hessians
};

/// How unsteady_fixed_point() works.
struct UnsteadyOptions {
  std::vector<double> times;                    ///< bounds of the sub-intervals, ascending, two or more
  std::size_t iterations = 3;                   ///< of the fixed point, 1 or more: so often the whole time is computed
  LpOptions sizing{};                           ///< `complexity` is that in space and time: summed over all time steps
  InTime in_time = InTime::average;             ///< what stands for all times of a sub-interval
  Recovery recovery = Recovery::least_squares;  ///< of the Hessians
  /// Without limits, which `sizing` holds. A callback that returns false only ends the adaptation of one mesh: to end
  /// the run, throw.
  AdaptOptions adapt{};
  TransferOptions transfer{};  ///< of the state from one sub-interval to the next
  /// Folder that holds the progress after each sub-interval; empty: none is kept. If it holds any when the run starts,
  /// the run goes on from there. With the same mesh, functions and options, its bits are those of a run that was never
  /// interrupted. Only `iterations` may grow: then a finished run goes on.
  std::filesystem::path checkpoint{};
};

/// What one iteration did.
struct IterationReport {
  double complexity = 0;                ///< of the metrics that its solution asks for, in space and time
  std::string stopped_by;               ///< as in ScaledMetric
  std::vector<std::size_t> tetrahedra;  ///< of the meshes it worked on, by sub-interval
};

/// The last iteration.
struct UnsteadyResult {
  std::vector<std::shared_ptr<const Mesh>> meshes;  ///< by sub-interval, those that the last iteration worked on
  std::vector<Field> state;                         ///< at the end of time, on the last mesh
  std::vector<IterationReport> iterations;          ///< without those before a checkpoint from which the run went on
};

/// Computes the whole time again and again, each time on meshes that are adapted to the solution of the time before:
/// one mesh per sub-interval, for all its steps, so that the mesh does not lag behind what moves (transient fixed
/// point, Alauzet, Frey, George and Mohammadi 2007; space_time_metrics()). `initial` gives the state at the first time
/// on any mesh, one field or more, `advance` the solver. What they throw reaches the caller, and the checkpoint stays.
/// Throws InputError for options that make no sense, a state that does not fit the mesh or is not finite, a
/// sub-interval without a sample, and a checkpoint that is damaged or does not fit; Failure if the checkpoint cannot be
/// written.
[[nodiscard]] TAUT_EXPORT UnsteadyResult
unsteady_fixed_point(const Mesh& mesh, const std::function<std::vector<Field>(const Mesh&)>& initial,
                     const std::function<void(Interval&)>& advance, const UnsteadyOptions& options);

}  // namespace taut
