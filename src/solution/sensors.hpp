// The scalars that decide on a metric.
#pragma once

#include <vector>

#include "taut/field.hpp"
#include "taut/mesh.hpp"
#include "taut/sizing.hpp"

namespace taut {

/// The Hessians of all scalars and of all components of vectors. Those of fields that are linear but for rounding are
/// zero. Throws InputError, with a message that starts with "fields: ", if a field, tensors included, does not fit the
/// mesh or is not finite, and if there are only tensors.
[[nodiscard]] std::vector<Tensors> hessians_of(const Mesh& mesh, const std::vector<Field>& fields, Recovery recovery);

}  // namespace taut
