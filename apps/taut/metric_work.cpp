#include "metric_work.hpp"

#include <fmt/format.h>

#include "files.hpp"
#include "solution.hpp"
#include "taut/taut.hpp"

namespace taut::program {
namespace {

std::vector<Tensors> hessians_of(const MetricJob& job, const Mesh& mesh) {
  std::vector<Tensors> hessians;
  for (const auto& values : read_scalars(job.inputs, mesh.points.size()))
    hessians.push_back(
        with_files(job.mesh, job.inputs.front(), [&] { return recover_hessian(mesh, values, job.recovery); }));
  return hessians;
}

Tensors intersection_of(std::span<const Tensors> metrics) {
  Tensors all = metrics.front();
  for (const Tensors& other : metrics.subspan(1)) all = intersection(all, other);
  return all;
}

/// A file with sizes or tensors, as tensors.
Tensors tensors_in(const std::string& file, const Mesh& mesh, const std::string& mesh_file) {
  return with_files(mesh_file, file, [&] { return tensors_of(mesh, read_metric(file)); });
}

void write_metric(const MetricJob& job, const Mesh& mesh, const Tensors& metric) {
  write_solution(job.output, {field_of(metric)});
  if (job.quiet) return;
  const double c = complexity(mesh, metric);
  fmt::print("{}: complexity {:.6g}, about {:.3g} vertices and {:.3g} tetrahedra in a unit mesh\n", job.output, c,
             vertices_per_complexity * c, tetrahedra_per_complexity * c);
}

void note_bound(const MetricJob& job, const ScaledMetric& scaled) {
  if (scaled.stopped_by.empty()) return;
  fmt::print(stderr, "taut: note: {}: complexity {:.4g} instead of {:.4g}, because of {}\n", job.output,
             scaled.complexity, job.lp.complexity, scaled.stopped_by);
}

}  // namespace

void run_lp(const MetricJob& job, const Mesh& mesh) {
  LpOptions options = job.lp;
  options.limits = limits_of(job.limits);
  const auto hessians = hessians_of(job, mesh);
  const ScaledMetric scaled =
      with_files(job.mesh, job.inputs.front(), [&] { return lp_metric(mesh, hessians, options); });
  write_metric(job, mesh, scaled.metric);
  note_bound(job, scaled);
}

void run_error(const MetricJob& job, const Mesh& mesh) {
  std::vector<Tensors> metrics;
  for (const Tensors& hessian : hessians_of(job, mesh))
    metrics.push_back(error_metric(mesh, hessian, job.error, limits_of(job.limits)));
  write_metric(job, mesh, limited(mesh, intersection_of(metrics), limits_of(job.limits)));
}

void run_level_set(const MetricJob& job, const Mesh& mesh) {
  LevelSetOptions options = job.level_set;
  options.limits = limits_of(job.limits);
  const auto fields = read_scalars(job.inputs, mesh.points.size());
  std::vector<Tensors> metrics;
  for (std::vector<double> values : fields) {
    for (double& u : values) u -= job.level;
    metrics.push_back(
        with_files(job.mesh, job.inputs.front(), [&] { return level_set_metric(mesh, values, options); }));
  }
  write_metric(job, mesh, limited(mesh, intersection_of(metrics), limits_of(job.limits)));
}

void run_curvature(const MetricJob& job, const Mesh& mesh) {
  CurvatureOptions options = job.curvature;
  options.limits = limits_of(job.limits);
  write_metric(job, mesh, with_files(job.mesh, "", [&] { return curvature_metric(mesh, options); }));
}

void run_hessian(const MetricJob& job, const Mesh& mesh) {
  std::vector<Field> fields;
  for (const Tensors& hessian : hessians_of(job, mesh)) fields.push_back(field_of(hessian));
  write_solution(job.output, fields);
}

void run_implied(const MetricJob& job, const Mesh& mesh) {
  const Tensors metric = with_files(job.mesh, "", [&] { return implied_metric(mesh); });
  write_metric(job, mesh, limited(mesh, metric, limits_of(job.limits)));
}

void run_size(const MetricJob& job, const Mesh& mesh) {
  if (job.inputs.empty() == !job.size)
    throw InputError("expected either a file of sizes or --size; see 'taut metric size --help'");
  const Tensors metric = job.size ? tensors_of(mesh, Sizes(mesh.points.size(), *job.size))
                                  : tensors_in(job.inputs.front(), mesh, job.mesh);
  write_metric(job, mesh, limited(mesh, metric, limits_of(job.limits)));
}

void run_intersect(const MetricJob& job, const Mesh& mesh) {
  std::vector<Tensors> metrics;
  for (const std::string& file : job.inputs) metrics.push_back(tensors_in(file, mesh, job.mesh));
  write_metric(job, mesh, limited(mesh, intersection_of(metrics), limits_of(job.limits)));
}

}  // namespace taut::program
