#include "taut/adapt.hpp"

#include <utility>

#include "adapt/result.hpp"
#include "adapt/rounds.hpp"
#include "adapt/setup.hpp"
#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "taut/threads.hpp"

namespace taut {
namespace {

AdaptResult adapt_here(const Mesh& mesh, const Metric& metric, const AdaptOptions& options) {
  AdaptResult result;
  result.report.threads = worker_count();
  Session session = set_up(mesh, metric, options, result.report);
  const bool go_on = !options.expecting || options.expecting(result.report.expected_tetrahedra);
  result.report.cancelled = !go_on;
  run_rounds(session, {.most = options.max_rounds, .block_size = options.block_size}, options.progress, result.report);
  const Stopwatch watch;
  assemble(std::move(session), mesh, result);
  result.report.seconds.emplace_back("result", watch.seconds());
  return result;
}

}  // namespace

AdaptResult adapt(const Mesh& mesh, const Metric& metric, const AdaptOptions& options) {
  require_options(options);
  AdaptResult result;
  on_threads(options.threads, [&] { result = adapt_here(mesh, metric, options); });
  return result;
}

}  // namespace taut
