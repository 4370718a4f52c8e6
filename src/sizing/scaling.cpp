#include "sizing/scaling.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "sizing/root.hpp"

namespace taut {
namespace {

constexpr double tolerance = 2e-3;  // relative, of the complexity
constexpr int most_evaluations = 40;

/// The sum of weight(i) value(i).
template <class Value>
double weighted_sum(std::span<const double> weights, Value&& value) {
  double sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * value(i);
  return sum;
}

double cube(double x) {
  return x * x * x;
}

/// What the bounds leave of the wanted complexity, and the bound that takes the rest.
std::pair<double, const char*> reachable(double wanted, double volume, const Limits& limits) {
  const double most = limits.hmin > 0 ? volume / cube(limits.hmin) : std::numeric_limits<double>::infinity();
  const double least = volume / cube(limits.hmax);
  if (wanted > most) return {most, "hmin"};
  if (wanted < least) return {least, "hmax"};
  return {wanted, ""};
}

/// Gradation only adds, and it takes most of the time: the search begins where the ungraded metric would do.
double first_factor(double goal, std::span<const Shape> shapes, std::span<const double> weights) {
  RootSearch search(tolerance, most_evaluations);
  while (!search.done()) {
    const auto complexity = [&](std::size_t i) { return shapes[i].ungraded_complexity(search.next()); };
    search.add(std::log(weighted_sum(weights, complexity) / goal));
  }
  return search.next();
}

void evaluate(double log_factor, std::span<const Shape> shapes, std::span<const double> weights, Scaled& result) {
  result.metrics.clear();
  result.complexities.clear();
  for (const Shape& shape : shapes) {
    result.metrics.push_back(shape.metric(log_factor));
    result.complexities.push_back(shape.complexity_of(result.metrics.back()));
  }
  result.total = weighted_sum(weights, [&](std::size_t i) { return result.complexities[i]; });
  ++result.evaluations;
}

}  // namespace

Scaled scaled_to(double wanted, std::span<const Shape> shapes, std::span<const double> weights) {
  Scaled result;
  const double volume = weighted_sum(weights, [&](std::size_t i) { return shapes[i].volume(); });
  const auto [goal, bound] = reachable(wanted, volume, shapes.front().limits());
  result.stopped_by = bound;
  RootSearch search(tolerance, most_evaluations, first_factor(goal, shapes, weights));
  while (!search.done()) {
    evaluate(search.next(), shapes, weights, result);
    search.add(std::log(result.total / goal));
  }
  return result;
}

ScaledMetric scaled_to(double wanted, const Shape& shape) {
  const std::array<double, 1> weights = {1};
  Scaled scaled = scaled_to(wanted, {&shape, 1}, weights);
  return {std::move(scaled.metrics[0]), scaled.total, scaled.evaluations, std::move(scaled.stopped_by)};
}

}  // namespace taut
