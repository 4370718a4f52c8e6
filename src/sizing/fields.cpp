#include <fmt/format.h>

#include "base/parallel.hpp"
#include "metric/field.hpp"
#include "metric/intersection.hpp"
#include "taut/error.hpp"
#include "taut/sizing.hpp"

namespace taut {

Tensors intersection(const Tensors& a, const Tensors& b) {
  if (a.size() != b.size())
    throw InputError(fmt::format("metrics of {} and {} vertices found, expected as many", a.size(), b.size()));
  require_metrics(a);
  require_metrics(b);
  Tensors result(a.size());
  for_each_index(result.size(), [&](std::size_t v) { result[v] = intersect(a[v], b[v]); });
  return result;
}

Tensors tensors_of(const Mesh& mesh, const Metric& metric) {
  return tensors_at(mesh, metric);
}

}  // namespace taut
