// The scalars that decide on a metric.
#pragma once

#include <vector>

#include "taut/field.hpp"
#include "taut/mesh.hpp"
#include "taut/sizing.hpp"

namespace taut {

/// The Hessians of all scalars and of all components of vectors. Throws InputError naming the field (counted from 1) if
/// it does not fit the mesh or a value is not finite, and if there is nothing but tensors.
[[nodiscard]] std::vector<Tensors> hessians_of(const Mesh& mesh, const std::vector<Field>& fields, Recovery recovery);

}  // namespace taut
