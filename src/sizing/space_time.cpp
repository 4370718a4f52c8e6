#include "taut/space_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"
#include "mesh/door.hpp"
#include "metric/intersection.hpp"
#include "sizing/absolute.hpp"
#include "sizing/limits.hpp"
#include "sizing/nodal.hpp"
#include "sizing/optimal.hpp"
#include "sizing/scaling.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

/// Stands for the largest eigenvalue of a field that is linear everywhere: its powers in the metric do not underflow.
constexpr double smallest_scale = 1e-60;

void require_positive(const char* what, double value) {
  if (!(value > 0 && std::isfinite(value)))
    throw InputError(fmt::format("{} {} found, expected a number above 0", what, value));
}

void require_sound(const SubInterval& interval) {
  if (interval.mesh == nullptr) throw InputError("no mesh found");
  require_sound_arrays(*interval.mesh);
  require_tensors(interval.hessian, interval.mesh->points.size());
  require_positive("steps", interval.steps);
  require_positive("duration", interval.duration);
}

void require_sound(std::span<const SubInterval> intervals) {
  if (intervals.empty()) throw InputError("no sub-interval found, expected one or more");
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    try {
      require_sound(intervals[i]);
    } catch (const InputError& error) {
      throw InputError(fmt::format("sub-interval {}: {}", i + 1, error.what()));
    }
  }
}

std::vector<std::vector<Spectrum>> absolute_by_interval(std::span<const SubInterval> intervals) {
  std::vector<std::vector<Spectrum>> all;
  double largest = 0;
  for (const SubInterval& interval : intervals) {
    all.push_back(absolute_spectra(interval.hessian));
    largest = std::max(largest, largest_eigenvalue(all.back()));
  }
  for (auto& spectra : all)
    if (largest > 0)
      divide(spectra, largest);
    else
      raise_flat(spectra, 0);
  return all;
}

/// A duration counts as a factor of the Hessian, a time step as the price of an element.
Shape shape_of(const SubInterval& interval, std::vector<Spectrum> absolute, double norm, const Limits& limits) {
  for_each_index(absolute.size(), [&](std::size_t v) { absolute[v].values = interval.duration * absolute[v].values; });
  return {*interval.mesh, std::move(absolute), {.norm = norm, .price = interval.steps}, limits};
}

/// Where a field is flat the eigenvalues are tiny, not zero, because only positive definite tensors can be intersected.
std::vector<Spectrum> positive_spectra(const Tensors& hessian) {
  std::vector<Spectrum> absolute = absolute_spectra(hessian);
  raise_flat(absolute, std::max(largest_eigenvalue(absolute), smallest_scale));
  return absolute;
}

}  // namespace

void HessianInTime::add(const Tensors& hessian, double dt) {
  require_positive("dt", dt);
  require_tensors(hessian, steps_ > 0 ? sum_.size() : hessian.size());
  const std::vector<Spectrum> absolute =
      kind_ == InTime::average ? absolute_spectra(hessian) : positive_spectra(hessian);
  sum_.resize(hessian.size());
  for_each_index(sum_.size(), [&](std::size_t v) {
    const Sym3 h = assemble(absolute[v]);
    if (kind_ == InTime::average) {
      sum_[v] = sum_[v] + dt * h;
    } else {
      sum_[v] = steps_ > 0 ? intersect(sum_[v], h) : h;
    }
  });
  ++steps_;
  duration_ += dt;
}

Tensors HessianInTime::hessian() const {
  Tensors result = sum_;
  if (kind_ == InTime::average)
    for (Tensor& h : result) h = 1 / duration_ * h;
  return result;
}

SpaceTimeMetrics space_time_metrics(std::span<const SubInterval> intervals, const LpOptions& options) {
  require_options(options);
  require_sound(intervals);
  Limits limits = options.limits;
  for (const SubInterval& interval : intervals) limits.hmax = within_domain(*interval.mesh, limits).hmax;
  auto absolute = absolute_by_interval(intervals);
  std::vector<Shape> shapes;
  std::vector<double> weights;
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    shapes.push_back(shape_of(intervals[i], std::move(absolute[i]), options.norm, limits));
    weights.push_back(intervals[i].steps);
  }
  Scaled scaled = scaled_to(options.complexity, shapes, weights);
  SpaceTimeMetrics result{.metrics = {}, .complexity = scaled.total, .stopped_by = scaled.stopped_by};
  for (std::size_t i = 0; i < intervals.size(); ++i)
    result.metrics.push_back(
        {std::move(scaled.metrics[i]), scaled.complexities[i], scaled.evaluations, scaled.stopped_by});
  return result;
}

}  // namespace taut
