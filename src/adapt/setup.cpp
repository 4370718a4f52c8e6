#include "adapt/setup.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "geometry/classify.hpp"
#include "geometry/features.hpp"
#include "geometry/off_surface.hpp"
#include "mesh/build.hpp"
#include "metric/field.hpp"
#include "sizing/complexity.hpp"
#include "sizing/limits.hpp"
#include "sizing/surface_curvatures.hpp"
#include "surface/ridge_angle.hpp"
#include "taut/sizing.hpp"

namespace taut {
void require_options(const AdaptOptions& o) {
  require_limits(o.limits);
  if (o.ridge_angle) require_ridge_angle(*o.ridge_angle);
  if (!(o.deviation >= 0 && std::isfinite(o.deviation)))
    throw InputError(fmt::format("deviation {} found, expected 0 or more", o.deviation));
  if (o.deviation > 0 && o.surface != Surface::adapt)
    throw InputError("deviation: curved patches are kept, expected Surface::adapt");
  if (o.geometry && o.surface != Surface::adapt)
    throw InputError("a geometry found with a surface that is kept, expected Surface::adapt");
  if (o.max_rounds < 0) throw InputError(fmt::format("{} rounds found, expected 0 or more", o.max_rounds));
}

namespace {

// Curvatures are those of the surface that the vertices have to lie on, which may be known better than by this mesh.
Tensors wanted_at(const Session& session, const Mesh& input, const Metric& metric, const AdaptOptions& options) {
  Tensors tensors = tensors_at(input, metric);
  if (options.deviation == 0) return tensors;
  return with_curvatures(std::move(tensors), surface_curvatures(session.mesh, session.model),
                         {.deviation = deviation_of_chords * options.deviation, .limits = within_domain(input, {})});
}

// The metrics of the input's points go to the vertices. Returns them by vertex.
std::vector<Sym3> place_metrics(TetMesh& mesh, const std::vector<Sym3>& metrics) {
  std::vector<Sym3> of_vertex(mesh.vertices.size());
  for_each_index(mesh.vertices.size(), [&](std::size_t v) {
    mesh.vertices[v].m = of_vertex[v] = metrics[mesh.origin_of_vertex[v]];
    mesh.host_of_vertex[v] = static_cast<CellId>(mesh.tet_of_vertex[v]);
  });
  return of_vertex;
}

std::unique_ptr<Target> make_target(const Metric& metric, const AdaptOptions& options, const Background& background,
                                    const std::vector<Sym3>& metrics) {
  const auto* function = std::get_if<MetricFunction>(&metric);
  if (function == nullptr || options.limits.gradation || options.deviation > 0)
    return std::make_unique<Target>(background, metrics);
  return std::make_unique<Target>(*function, options.limits);
}

std::vector<std::uint32_t> inverse(const std::vector<TetId>& tet_of_input) {
  std::vector<std::uint32_t> input_of_tet(tet_of_input.size());
  for_each_index(tet_of_input.size(),
                 [&](std::size_t i) { input_of_tet[tet_of_input[i]] = static_cast<std::uint32_t>(i); });
  return input_of_tet;
}

void count_mended(const Mesh& input, const Built& built, const Model& model, Report& report) {
  report.reoriented = built.reoriented;
  report.triangles_built = built.triangles_built;
  for (std::size_t e = 0; e < input.edges.size(); ++e) report.edges_dropped += is_in_volume(input, built, e) ? 0 : 1;
  for (const Triangle& t : built.mesh.triangles) report.triangles_frozen += model.patches[t.patch].frozen() ? 1 : 0;
}

// The estimate may be too low, never far too high: beyond the ids, no memory would do either.
double require_ids_for(double tetrahedra) {
  if (tetrahedra < static_cast<double>(TetMesh::most_tets)) return tetrahedra;
  throw InputError(
      fmt::format("metric: about {:.2g} tetrahedra needed, expected fewer than {}: 32-bit ids cannot number them",
                  tetrahedra, TetMesh::most_tets));
}

}  // namespace

void set_target(Session& session, const Mesh& input, const Metric& metric, const AdaptOptions& options) {
  const std::vector<Sym3> metrics =
      place_metrics(session.mesh, apply_limits(input, wanted_at(session, input, metric, options), options.limits));
  session.background = std::make_unique<const Background>(session.mesh);
  session.target = make_target(metric, options, *session.background, metrics);
}

Session set_up(const Mesh& mesh, const Metric& metric, const AdaptOptions& options, Report& report) {
  const Stopwatch build_watch;
  Built built = build(mesh);
  report.seconds.emplace_back("build", build_watch.seconds());

  const Stopwatch geometry_watch;
  Model model = classify(mesh, built, options.surface, options.ridge_angle,
                         options.geometry ? options.geometry->shared_surface() : nullptr);
  require_near_surface(built.mesh, model);
  if (options.deviation > 0) model.deviation = options.deviation;
  count_mended(mesh, built, model, report);
  report.seconds.emplace_back("geometry", geometry_watch.seconds());

  const Stopwatch metric_watch;
  Session session{std::move(built.mesh),      std::move(model), nullptr, nullptr, std::move(built.vertex_of_point),
                  inverse(built.tet_of_input)};
  set_target(session, mesh, metric, options);
  session.measure_qualities();
  report.expected_tetrahedra = require_ids_for(expected_tetrahedra(session.mesh));
  report.seconds.emplace_back("metric", metric_watch.seconds());
  return session;
}

}  // namespace taut
