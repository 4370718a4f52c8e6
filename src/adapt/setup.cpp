#include "adapt/setup.hpp"

#include <fmt/format.h>

#include <cmath>

#include "adapt/tally.hpp"
#include "base/parallel.hpp"
#include "geometry/classify.hpp"
#include "mesh/build.hpp"
#include "mesh/edges.hpp"
#include "metric/field.hpp"
#include "metric/quality.hpp"
#include "sizing/gradation.hpp"
#include "sizing/truncation.hpp"

namespace taut {
void require_options(const AdaptOptions& o) {
  if (!(o.hmin >= 0) || !(o.hmax > 0) || !(o.hmin <= o.hmax))
    throw InputError(fmt::format("hmin {}, hmax {} found, expected 0 <= hmin <= hmax, hmax > 0", o.hmin, o.hmax));
  if (o.gradation && !(*o.gradation > 1 && std::isfinite(*o.gradation)))
    throw InputError(fmt::format("gradation {} found, expected a number above 1", *o.gradation));
  if (!(o.ridge_angle > 0 && o.ridge_angle < 180))
    throw InputError(fmt::format("ridge angle {} found, expected between 0 and 180 degrees", o.ridge_angle));
  if (o.passes < 0) throw InputError(fmt::format("{} passes found, expected 0 or more", o.passes));
}

namespace {

std::vector<Sym3> limited_metric(const Mesh& mesh, const Metric& metric, const AdaptOptions& options) {
  std::vector<Sym3> metrics = tensors_at(mesh, metric);
  const auto truncate_all = [&] {
    for_each_index(metrics.size(),
                   [&](std::size_t v) { metrics[v] = truncate(metrics[v], options.hmin, options.hmax); });
  };
  truncate_all();
  if (!options.gradation) return metrics;
  metrics = gradate(mesh.points, edges_of(mesh.tetrahedra), std::move(metrics), *options.gradation);
  truncate_all();  // intersecting metrics that are askew asks for smaller sizes than either
  return metrics;
}

void set_qualities(TetMesh& mesh) {
  for_each_index(mesh.tets.size(), [&](std::size_t t) {
    Tet& tet = mesh.tets[t];
    const Vertex* p[4];
    for (int k = 0; k < 4; ++k) p[k] = &mesh.vertices[tet.v[k]];
    tet.quality =
        static_cast<float>(shape_quality(p[0]->x, p[1]->x, p[2]->x, p[3]->x, p[0]->m, p[1]->m, p[2]->m, p[3]->m));
  });
}

void count_mended(const Built& built, const Model& model, Report& report) {
  report.reoriented = built.reoriented;
  report.triangles_built = built.triangles_built;
  for (const Triangle& t : built.mesh.triangles) report.triangles_frozen += model.patches[t.patch].frozen ? 1 : 0;
}

}  // namespace

Problem set_up(const Mesh& mesh, const Metric& metric, const AdaptOptions& options, Report& report) {
  const Stopwatch build_watch;
  Built built = build(mesh);
  report.seconds.emplace_back("build", build_watch.seconds());

  const Stopwatch geometry_watch;
  Model model = classify(mesh, built, options.surface, options.ridge_angle);
  count_mended(built, model, report);
  report.seconds.emplace_back("geometry", geometry_watch.seconds());

  const Stopwatch metric_watch;
  const std::vector<Sym3> metrics = limited_metric(mesh, metric, options);
  TetMesh& work = built.mesh;
  for_each_index(work.vertices.size(), [&](std::size_t v) {
    work.vertices[v].m = metrics[work.origin_of_vertex[v]];
    work.host_of_vertex[v] = work.tet_of_vertex[v];
    work.restless[v] = 1;
  });
  set_qualities(work);
  const auto* function = std::get_if<MetricFunction>(&metric);
  auto target = function != nullptr && !options.gradation
                    ? std::make_unique<Target>(*function, options.hmin, options.hmax)
                    : std::make_unique<Target>(work);
  report.seconds.emplace_back("metric", metric_watch.seconds());
  return {std::move(work), std::move(model), std::move(target)};
}

}  // namespace taut
