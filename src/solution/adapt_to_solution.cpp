#include <utility>

#include "base/stopwatch.hpp"
#include "solution/options.hpp"
#include "solution/sensors.hpp"
#include "taut/local_sizes.hpp"
#include "taut/solution.hpp"
#include "taut/threads.hpp"

namespace taut {
namespace {

void transfer_fields(const Mesh& mesh, const std::vector<Field>& fields, const TransferOptions& options,
                     SolutionResult& result) {
  if (options.method == Transfer::linear) {
    result.fields = interpolate(mesh, fields, result.adapted.hosts);
    return;
  }
  Transferred transferred = transfer(mesh, fields, result.adapted.mesh, options);
  result.fields = std::move(transferred.fields);
  result.transferred = std::move(transferred.report);
}

template <class Step>
void timed_step(SolutionResult& result, const char* name, Step step) {
  const Stopwatch watch;
  step();
  result.seconds.emplace_back(name, watch.seconds());
}

ScaledMetric metric_of(const Mesh& mesh, const std::vector<Field>& fields, const SolutionOptions& options) {
  ScaledMetric scaled = lp_metric(mesh, hessians_of(mesh, fields, options.recovery), options.sizing);
  if (options.local.empty()) return scaled;
  const Tensors local = with_local_sizes(mesh, std::move(scaled.metric), options.local);
  scaled.metric = limited(mesh, local, options.sizing.limits);
  scaled.complexity = complexity(mesh, scaled.metric);
  return scaled;
}

void run_steps(const Mesh& mesh, const std::vector<Field>& fields, const SolutionOptions& options,
               SolutionResult& result) {
  ScaledMetric scaled;
  timed_step(result, "sizing", [&] { scaled = metric_of(mesh, fields, options); });
  result.complexity = scaled.complexity;
  result.stopped_by = std::move(scaled.stopped_by);
  timed_step(result, "adapt", [&] { result.adapted = adapt(mesh, Metric{std::move(scaled.metric)}, options.adapt); });
  timed_step(result, "transfer", [&] { transfer_fields(mesh, fields, options.transfer, result); });
}

}  // namespace

SolutionResult adapt_to_solution(const Mesh& mesh, const std::vector<Field>& fields, const SolutionOptions& options) {
  require_sound(options.sizing, options.adapt);
  SolutionResult result;
  on_threads(options.adapt.threads, [&] { run_steps(mesh, fields, options, result); });
  return result;
}

}  // namespace taut
