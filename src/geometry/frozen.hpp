// What has to stay as it is besides frozen patches: regions, and single vertices.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/features.hpp"
#include "geometry/model.hpp"
#include "mesh/build.hpp"
#include "taut/mesh.hpp"

namespace taut {

/// The regions of the mesh, with the tetrahedra round each edge of `inner_edges` moved to frozen twins of theirs.
/// Throws InputError for an edge that is no edge of a tetrahedron.
[[nodiscard]] std::vector<Region> find_regions(Built& built, std::span<const Feature> inner_edges);

/// Whether the vertices of a feature edge stay: it is required, or no operation could keep it.
[[nodiscard]] bool stays(const TetMesh& mesh, const Feature& feature);

/// For each vertex whether it has to stay where it is. `model` holds the patches and the regions.
[[nodiscard]] std::vector<std::uint8_t> find_fixed_vertices(const Mesh& input, const Built& built, const Model& model,
                                                            const Features& features);

}  // namespace taut
