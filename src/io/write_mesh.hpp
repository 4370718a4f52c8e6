// From a mesh to the blocks of a file.
#pragma once

#include "io/atomic_file.hpp"
#include "taut/mesh.hpp"

namespace taut::gmf {

void write_text(AtomicFile& file, const Mesh& mesh);
void write_binary(AtomicFile& file, const Mesh& mesh, int version);

}  // namespace taut::gmf
