#include "metric/field.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>

#include "base/parallel.hpp"
#include "metric/spectral.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

void require_count(std::size_t values, std::size_t points) {
  if (values != points)
    throw InputError(fmt::format("metric: {} values for {} vertices, expected one per vertex", values, points));
}

[[noreturn]] void throw_no_metric(const std::string& place, const Tensor& m) {
  throw InputError(fmt::format("metric: {}: the tensor xx, xy, xz, yy, yz, zz = {} is not finite and positive definite",
                               place, fmt::join(m, ", ")));
}

void require_metric_at(std::size_t vertex, const Tensor& m) {
  if (!is_positive_definite(m)) throw_no_metric(fmt::format("vertex {}", vertex + 1), m);
}

/// Also refuses sizes so small or large that h^-2 is not a positive double.
Sym3 tensor_of_size(double h, std::size_t vertex) {
  const Sym3 m = metric_of_size(h);
  if (!(h > 0) || !is_positive_definite(m))
    throw InputError(fmt::format("metric: vertex {}: size {} found, expected a positive number", vertex + 1, h));
  return m;
}

std::vector<Sym3> evaluate(const Mesh& mesh, const Sizes& sizes) {
  require_count(sizes.size(), mesh.points.size());
  std::vector<Sym3> tensors(sizes.size());
  for_each_index(sizes.size(), [&](std::size_t i) { tensors[i] = tensor_of_size(sizes[i], i); });
  return tensors;
}

std::vector<Sym3> evaluate(const Mesh& mesh, const Tensors& tensors) {
  require_count(tensors.size(), mesh.points.size());
  require_metrics(tensors);
  return tensors;
}

std::vector<Sym3> evaluate(const Mesh& mesh, const MetricFunction& function) {
  if (!function) throw InputError("metric: empty function found, expected a callable one");
  std::vector<Sym3> tensors(mesh.points.size());
  for_each_index(tensors.size(), [&](std::size_t i) {
    tensors[i] = function(mesh.points[i]);
    if (!is_positive_definite(tensors[i]))
      throw_no_metric(fmt::format("vertex {} at ({})", i + 1, fmt::join(mesh.points[i], ", ")), tensors[i]);
  });
  return tensors;
}

}  // namespace

void require_metric(const Tensor& m, const Point& x) {
  if (!is_positive_definite(m)) throw_no_metric(fmt::format("at ({})", fmt::join(x, ", ")), m);
}

void require_metrics(const Tensors& tensors) {
  for_each_index(tensors.size(), [&](std::size_t i) { require_metric_at(i, tensors[i]); });
}

std::vector<Sym3> tensors_at(const Mesh& mesh, const Metric& metric) {
  return std::visit([&mesh](const auto& given) { return evaluate(mesh, given); }, metric);
}

}  // namespace taut
