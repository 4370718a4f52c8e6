// Metrics for a solution that changes in time: one per sub-interval, under one space-time complexity.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "taut/export.hpp"
#include "taut/mesh.hpp"
#include "taut/metric.hpp"
#include "taut/sizing.hpp"

namespace taut {

/// What stands for the Hessians of all times of a sub-interval.
enum class InTime {
  average,       ///< the mean of |H| over time, weighted by the length of the steps: for the L^p norm in time
  intersection,  ///< the intersection of |H| over all samples: the largest error counts, as long as it may last
};

/// Collects the Hessians that a solution has on one mesh during a sub-interval.
class TAUT_EXPORT HessianInTime {
public:
  /// Nothing is collected yet.
  explicit HessianInTime(InTime kind = InTime::average) : kind_(kind) {}

  /// Adds the Hessian of a time step of length `dt` > 0. Throws InputError if there are not as many tensors as before,
  /// one is not finite, or dt is not positive.
  void add(const Tensors& hessian, double dt);

  /// The mean or the intersection of |H|; empty if nothing was added.
  [[nodiscard]] Tensors hessian() const;

  /// How many time steps were added.
  [[nodiscard]] std::size_t steps() const { return steps_; }

  /// The sum of their lengths.
  [[nodiscard]] double duration() const { return duration_; }

private:
  InTime kind_;
  std::size_t steps_ = 0;
  double duration_ = 0;
  Tensors sum_;
};

/// The mesh that serves one sub-interval of time, and what the solution needs there.
struct SubInterval {
  const Mesh* mesh = nullptr;  ///< not null
  Tensors hessian;             ///< at the points of the mesh, as HessianInTime collects it
  double steps = 1;            ///< time steps that the solver takes, above 0
  double duration = 1;         ///< above 0
};

/// What space_time_metrics() found.
struct SpaceTimeMetrics {
  std::vector<ScaledMetric> metrics;  ///< by sub-interval
  double complexity = 0;              ///< the sum over the sub-intervals of complexity times steps
  std::string stopped_by;             ///< as in ScaledMetric
};

/// For all sub-intervals together, the metrics that minimise the L^p norm in space and time of the interpolation error
/// for the space-time complexity `options.complexity`: the sum over the sub-intervals of complexity times number of
/// steps. With n_i steps and the mean Hessian H_i over a duration of d_i, the metric of a sub-interval is
/// n_i^(-2/(2p+3)) det|d_i H_i|^(-1/(2p+3)) |d_i H_i| times one constant for all (Alauzet and Olivier 2011; Belme,
/// Dervieux and Alauzet 2012), within 0.2 % of the complexity after all limits are applied. Throws InputError.
[[nodiscard]] TAUT_EXPORT SpaceTimeMetrics space_time_metrics(std::span<const SubInterval> intervals,
                                                              const LpOptions& options);

}  // namespace taut
