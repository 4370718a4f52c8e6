#include "solution/sensors.hpp"

#include <fmt/format.h>

#include "taut/error.hpp"

namespace taut {
namespace {

void require_size(const Mesh& mesh, const Field& field, std::size_t number) {
  if (field.values.size() != mesh.points.size() * field.size())
    throw InputError(fmt::format("field: number {} has {} values, expected {} for each of the {} vertices", number + 1,
                                 field.values.size(), field.size(), mesh.points.size()));
}

}  // namespace

std::vector<Tensors> hessians_of(const Mesh& mesh, const std::vector<Field>& fields, Recovery recovery) {
  std::vector<Tensors> hessians;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    require_size(mesh, fields[i], i);
    if (fields[i].kind == Field::Kind::tensor) continue;
    for (std::size_t k = 0; k < fields[i].size(); ++k)
      hessians.push_back(recover_hessian(mesh, fields[i].component(k), recovery));
  }
  if (hessians.empty()) throw InputError("field: no scalar or vector found, expected one or more");
  return hessians;
}

}  // namespace taut
