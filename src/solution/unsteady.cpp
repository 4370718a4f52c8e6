#include "taut/unsteady.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "solution/checkpoint.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

using Initial = std::function<std::vector<Field>(const Mesh&)>;
using Advance = std::function<void(Interval&)>;

void require(const UnsteadyOptions& o) {
  if (o.times.size() < 2) throw InputError(fmt::format("{} times found, expected two or more", o.times.size()));
  for (std::size_t i = 0; i + 1 < o.times.size(); ++i)
    if (!(o.times[i] < o.times[i + 1] && std::isfinite(o.times[i]) && std::isfinite(o.times[i + 1])))
      throw InputError(fmt::format("time {} found after {}, expected a later one", o.times[i + 1], o.times[i]));
  if (o.iterations == 0) throw InputError("0 iterations found, expected 1 or more");
}

void require_fit(const std::vector<Field>& state, const Mesh& mesh, const char* whose) {
  for (const Field& field : state)
    if (field.values.size() != field.size() * mesh.points.size())
      throw InputError(fmt::format("field: {} has {} values, expected {} for each of the {} vertices", whose,
                                   field.values.size(), field.size(), mesh.points.size()));
}

class FixedPoint {
public:
  FixedPoint(const Initial& initial, const Advance& advance, const UnsteadyOptions& options)
      : initial_(initial), advance_(advance), options_(options), checkpoint_(options.checkpoint) {}

  UnsteadyResult run(const Mesh& mesh) {
    begin(mesh);
    for (; true; next_iteration()) {
      while (progress_.done.size() < progress_.meshes.size()) compute_interval(progress_.done.size());
      report();
      if (progress_.iteration + 1 >= options_.iterations) break;
    }
    return {std::move(progress_.meshes), std::move(progress_.state), std::move(iterations_)};
  }

private:
  void begin(const Mesh& mesh) {
    const std::size_t intervals = options_.times.size() - 1;
    if (checkpoint_.exists()) {
      progress_ = checkpoint_.read(intervals);
      return;
    }
    progress_.meshes.assign(intervals, std::make_shared<const Mesh>(mesh));
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
    require_fit(interval.state, *interval.mesh, "the state at the begin of a sub-interval");
    advance_(interval);
    require_fit(interval.state, *progress_.meshes[index], "the state that the solver left");
    if (interval.collected.steps() == 0)
      throw InputError(fmt::format("sub-interval {}: no sample found, expected one per time step", index + 1));
    progress_.state = std::move(interval.state);
    progress_.done.push_back({.mesh = progress_.meshes[index].get(),
                              .hessian = interval.collected.hessian(),
                              .steps = static_cast<double>(interval.collected.steps()),
                              .duration = interval.collected.duration()});
    checkpoint_.write_last(progress_);
  }

  void report() {
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
  require(options);
  return FixedPoint(initial, advance, options).run(mesh);
}

}  // namespace taut
