#include "solution/options.hpp"

#include <cmath>

#include "adapt/setup.hpp"
#include "sizing/optimal.hpp"
#include "taut/error.hpp"
#include "taut/threads.hpp"

namespace taut {
namespace {

bool is_unlimited(const Limits& l) {
  return l.hmin == 0 && std::isinf(l.hmax) && std::isinf(l.anisotropy) && !l.gradation;
}

}  // namespace

void require_sound(const LpOptions& sizing, const AdaptOptions& adapt) {
  require_options(sizing);
  require_options(adapt);
  on_threads(adapt.threads, [] {});  // refuses a number out of range
  if (!is_unlimited(adapt.limits))
    throw InputError("limits in the options of the adaptation found, expected them in those of the sizing");
}

}  // namespace taut
