// From the blocks of a file to a mesh.
#pragma once

#include "io/gmf_file.hpp"
#include "io/mesh_blocks.hpp"
#include "taut/mesh.hpp"

namespace taut::gmf {

[[nodiscard]] Mesh read_mesh(const GmfFile& file, Needs needs = Needs::tetrahedra);

}  // namespace taut::gmf
