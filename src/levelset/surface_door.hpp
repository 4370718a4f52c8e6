// Checks of a public surface.
#pragma once

#include <string_view>

#include "taut/surface_mesh.hpp"

namespace taut {

/// Indices in range and finite coordinates. Throws InputError, which begins with `name`.
void require_sound(const SurfaceMesh& surface, std::string_view name);

}  // namespace taut
