#include "taut/unsteady.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "solution/checkpoint.hpp"
#include "solution/options.hpp"
#include "taut/error.hpp"
#include "transfer/values.hpp"

namespace taut {
namespace {

using Initial = std::function<std::vector<Field>(const Mesh&)>;
using Advance = std::function<void(Interval&)>;

void require_times(std::span<const double> times) {
  if (times.size() < 2) throw InputError(fmt::format("{} times found, expected two or more", times.size()));
  for (const double time : times)
    if (!std::isfinite(time)) throw InputError(fmt::format("time {} found, expected a finite number", time));
  for (std::size_t i = 0; i + 1 < times.size(); ++i)
    if (times[i] >= times[i + 1])
      throw InputError(fmt::format("time {} found after {}, expected a later one", times[i + 1], times[i]));
}

void require_unsteady(const UnsteadyOptions& options) {
  require_times(options.times);
  if (options.iterations == 0) throw InputError("0 iterations found, expected 1 or more");
  require_sound(options.sizing, options.adapt);
}

/// `when` is "begin" or "end".
void require_state(const Interval& interval, const Mesh& mesh, const char* when) {
  try {
    require_sound(interval.state, mesh.points.size());
  } catch (const InputError& error) {
    throw InputError(fmt::format("sub-interval {}: state at the {}: {}", interval.index + 1, when, error.what()));
  }
}

class FixedPoint {
public:
  FixedPoint(const Initial& initial, const Advance& advance, const UnsteadyOptions& options)
      : initial_(initial), advance_(advance), options_(options), checkpoint_(options.checkpoint, options.times) {}

  UnsteadyResult run(const Mesh& mesh) {
    begin(mesh);
    compute_iteration();
    while (progress_.iteration + 1 < options_.iterations) {
      next_iteration();
      compute_iteration();
    }
    return {std::move(progress_.meshes), std::move(progress_.state), std::move(iterations_)};
  }

private:
  void begin(const Mesh& mesh) {
    const auto first = std::make_shared<const Mesh>(mesh);
    if (checkpoint_.exists()) {
      progress_ = checkpoint_.read(first);
      if (progress_.iteration >= options_.iterations)
        throw InputError(fmt::format("{}: iteration {} found, expected at most the {} that are asked for",
                                     options_.checkpoint.string(), progress_.iteration + 1, options_.iterations));
      return;
    }
    progress_.meshes.assign(options_.times.size() - 1, first);
    checkpoint_.write_meshes(progress_);
  }

  /// The state at the end of the sub-interval before, on the mesh of this one.
  [[nodiscard]] std::vector<Field> state_at_begin(std::size_t index) const {
    const Mesh& mesh = *progress_.meshes[index];
    if (index == 0) return initial_(mesh);
    if (progress_.meshes[index] == progress_.meshes[index - 1]) return progress_.state;
    return transfer(*progress_.meshes[index - 1], progress_.state, mesh, options_.transfer).fields;
  }

  void compute_interval(std::size_t index) {
    Interval interval{.iteration = progress_.iteration,
                      .index = index,
                      .begin = options_.times[index],
                      .end = options_.times[index + 1],
                      .mesh = progress_.meshes[index],
                      .state = state_at_begin(index),
                      .collected = HessianInTime(options_.in_time),
                      .recovery = options_.recovery};
    require_state(interval, *progress_.meshes[index], "begin");
    advance_(interval);
    require_state(interval, *progress_.meshes[index], "end");
    if (interval.collected.steps() == 0)
      throw InputError(fmt::format("sub-interval {}: no sample found, expected one per time step", index + 1));
    progress_.state = std::move(interval.state);
    progress_.done.push_back({.mesh = progress_.meshes[index].get(),
                              .hessian = interval.collected.hessian(),
                              .steps = static_cast<double>(interval.collected.steps()),
                              .duration = interval.collected.duration()});
    checkpoint_.write_last(progress_);
  }

  /// The sub-intervals that are left, and what metrics their solution asks for.
  void compute_iteration() {
    while (progress_.done.size() < progress_.meshes.size()) compute_interval(progress_.done.size());
    metrics_ = space_time_metrics(progress_.done, options_.sizing);
    IterationReport report{.complexity = metrics_.complexity, .stopped_by = metrics_.stopped_by, .tetrahedra = {}};
    for (const auto& mesh : progress_.meshes) report.tetrahedra.push_back(mesh->tetrahedra.size());
    iterations_.push_back(std::move(report));
  }

  void next_iteration() {
    UnsteadyProgress next{.iteration = progress_.iteration + 1, .meshes = {}, .done = {}, .state = {}};
    for (std::size_t i = 0; i < progress_.meshes.size(); ++i) {
      const Metric metric = std::move(metrics_.metrics[i].metric);
      next.meshes.push_back(std::make_shared<const Mesh>(adapt(*progress_.meshes[i], metric, options_.adapt).mesh));
    }
    progress_ = std::move(next);
    checkpoint_.write_meshes(progress_);
  }

  const Initial& initial_;
  const Advance& advance_;
  const UnsteadyOptions& options_;
  Checkpoint checkpoint_;
  UnsteadyProgress progress_;
  SpaceTimeMetrics metrics_;
  std::vector<IterationReport> iterations_;
};

}  // namespace

void Interval::sample(std::span<const double> values, double dt) {
  collected.add(recover_hessian(*mesh, values, recovery), dt);
}

UnsteadyResult unsteady_fixed_point(const Mesh& mesh, const Initial& initial, const Advance& advance,
                                    const UnsteadyOptions& options) {
  require_unsteady(options);
  return FixedPoint(initial, advance, options).run(mesh);
}

}  // namespace taut
