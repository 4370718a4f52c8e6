#include "solution/sensors.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/sym3.hpp"
#include "taut/error.hpp"
#include "transfer/values.hpp"

namespace taut {
namespace {

/// A multiple of the rounding of a value, because the recovery amplifies it.
constexpr double noise = 1e-12;

/// Whether the change of the gradient along an edge changes the value by no more than rounding does.
bool is_linear_along(const Mesh& mesh, const Tensors& hessian, Index a, Index b, double largest_value) {
  const Vec3 edge = mesh.points[b] - mesh.points[a];
  return std::abs(quadratic_form(hessian[a], edge)) <= noise * largest_value &&
         std::abs(quadratic_form(hessian[b], edge)) <= noise * largest_value;
}

bool is_linear(const Mesh& mesh, std::span<const double> values, const Tensors& hessian) {
  double largest = 0;
  for (const double u : values) largest = std::max(largest, std::abs(u));
  return std::ranges::all_of(mesh.tetrahedra, [&](const std::array<Index, 4>& tet) {
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (!is_linear_along(mesh, hessian, tet[i], tet[j], largest)) return false;
    return true;
  });
}

/// Without this, a component that is linear would ask for elements shaped by rounding, as urgently as all others.
Tensors hessian_without_noise(const Mesh& mesh, std::span<const double> values, Recovery recovery) {
  Tensors hessian = recover_hessian(mesh, values, recovery);
  if (is_linear(mesh, values, hessian)) std::ranges::fill(hessian, Tensor{});
  return hessian;
}

}  // namespace

std::vector<Tensors> hessians_of(const Mesh& mesh, const std::vector<Field>& fields, Recovery recovery) {
  require_sound(fields, mesh.points.size());
  std::vector<Tensors> hessians;
  for (const Field& field : fields) {
    if (field.kind == Field::Kind::tensor) continue;
    for (std::size_t k = 0; k < field.size(); ++k)
      hessians.push_back(hessian_without_noise(mesh, field.component(k), recovery));
  }
  if (hessians.empty()) throw InputError("fields: only tensors found, expected a scalar or a vector");
  return hessians;
}

}  // namespace taut
