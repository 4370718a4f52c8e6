// From the blocks of a file to a mesh.
#pragma once

#include "io/gmf_file.hpp"
#include "taut/mesh.hpp"

namespace taut::gmf {

[[nodiscard]] Mesh read_mesh(const GmfFile& file);

}  // namespace taut::gmf
