// What a function does near a point.
#pragma once

#include "base/sym3.hpp"

namespace taut {

/// First and second derivatives at a point.
struct Derivatives {
  Vec3 gradient;
  Sym3 hessian;
};

}  // namespace taut
