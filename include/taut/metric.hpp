// Metric fields as users hold them: sizes, tensors at the vertices, or a function of the position.
#pragma once

#include <array>
#include <functional>
#include <variant>
#include <vector>

#include "taut/mesh.hpp"

namespace taut {

/// A symmetric tensor, entries in the order xx, xy, xz, yy, yz, zz (GMF files hold xx, xy, yy, xz, yz, zz).
///
/// The eigenvalues of a metric are 1/h^2, where h is the wanted edge size along the eigenvector (Dobrzynski and Frey
/// 2008, 2.2).
using Tensor = std::array<double, 6>;

using Sizes = std::vector<double>;    ///< wanted isotropic edge size at each point of a mesh
using Tensors = std::vector<Tensor>;  ///< metric tensor at each point of a mesh

/// The metric tensor at a point. It is called from several threads at once, in any order and more than once for the
/// same point. It must return the same tensor for the same point, and must not change anything that another call reads.
using MetricFunction = std::function<Tensor(const Point&)>;

/// The target of an adaptation.
using Metric = std::variant<Sizes, Tensors, MetricFunction>;

}  // namespace taut
