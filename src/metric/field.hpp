// The metric a user gives, checked at the door.
#pragma once

#include <vector>

#include "base/sym3.hpp"
#include "taut/mesh.hpp"
#include "taut/metric.hpp"

namespace taut {

/// The tensors of `metric` at the points of `mesh`: those given, 1/h^2 for sizes, the values of a function.
/// Throws InputError naming the vertex if the numbers of points and values differ, a size is not positive or a tensor
/// is not positive definite, or one is not finite.
[[nodiscard]] std::vector<Sym3> tensors_at(const Mesh& mesh, const Metric& metric);

/// Throws InputError naming the position unless the value of a metric function there is finite and positive definite.
void require_metric(const Tensor& m, const Point& x);

}  // namespace taut
