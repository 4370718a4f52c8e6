#include "levelset/surface_door.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/parallel.hpp"
#include "taut/error.hpp"

namespace taut {

void require_sound(const SurfaceMesh& surface, std::string_view name) {
  for_each_index(surface.points.size(), [&](std::size_t v) {
    for (const double x : surface.points[v])
      if (!std::isfinite(x))
        throw InputError(fmt::format("{}: vertex {}: coordinate {} is not finite", name, v + 1, x));
  });
  for_each_index(surface.triangles.size(), [&](std::size_t t) {
    for (const Index v : surface.triangles[t])
      if (v >= surface.points.size())
        throw InputError(fmt::format("{}: triangle {}: vertex {} found, expected 1..{}", name, t + 1,
                                     std::size_t{v} + 1, surface.points.size()));
  });
}

}  // namespace taut
