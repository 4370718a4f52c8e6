// The metric that a user gives, with its checks.
#pragma once

#include <vector>

#include "base/sym3.hpp"
#include "taut/mesh.hpp"
#include "taut/metric.hpp"

namespace taut {

/// The tensors of `metric` at the points of `mesh`: the given tensors, 1/h^2 for sizes, or the values of the function.
/// Throws InputError if the numbers of points and values differ; also, naming the vertex, if a size is not positive, a
/// tensor is not positive definite, or either is not finite.
[[nodiscard]] std::vector<Sym3> tensors_at(const Mesh& mesh, const Metric& metric);

/// Throws InputError naming the position unless the value of a metric function there is finite and positive definite.
void require_metric(const Tensor& m, const Point& x);

/// Throws InputError naming the vertex unless all tensors are finite and positive definite.
void require_metrics(const Tensors& tensors);

}  // namespace taut
