#include <utility>

#include "base/parallel.hpp"
#include "solution/sensors.hpp"
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

}  // namespace

SolutionResult adapt_to_solution(const Mesh& mesh, const std::vector<Field>& fields, const SolutionOptions& options) {
  SolutionResult result;
  on_threads(options.adapt.threads, [&] {
    ScaledMetric scaled = lp_metric(mesh, hessians_of(mesh, fields, options.recovery), options.sizing);
    result.complexity = scaled.complexity;
    result.stopped_by = std::move(scaled.stopped_by);
    result.adapted = adapt(mesh, Metric{std::move(scaled.metric)}, options.adapt);
    transfer_fields(mesh, fields, options.transfer, result);
  });
  return result;
}

}  // namespace taut
