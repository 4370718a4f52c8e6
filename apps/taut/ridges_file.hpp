// The file of `taut adapt --ridges`: edges that are ridges.
#pragma once

#include <string>

#include "taut/mesh.hpp"

namespace taut::program {

/// The mesh, which was read from `mesh_file`, with the ridges of the file: of a mesh (.mesh, .meshb), found by their
/// places, or of a text with two vertex numbers in each line, counted from 1, and comments from '#' to the end of the
/// line. Throws InputError that names the file, or `mesh_file`, and the line, edge or vertex that cannot be used.
[[nodiscard]] Mesh with_ridges_of(const std::string& file, Mesh mesh, const std::string& mesh_file);

}  // namespace taut::program
