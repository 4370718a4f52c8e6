#include "surface/ridge_angle.hpp"

#include <fmt/format.h>

#include "taut/error.hpp"

namespace taut {

void require_ridge_angle(double degrees) {
  if (!(degrees > 0 && degrees < 180))
    throw InputError(fmt::format("ridge angle {} found, expected between 0 and 180 degrees", degrees));
}

}  // namespace taut
