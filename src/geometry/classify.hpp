// Finds the patches, lines and corners of a surface mesh.
#pragma once

#include <memory>
#include <optional>

#include "geometry/model.hpp"
#include "mesh/build.hpp"
#include "taut/mesh.hpp"
#include "taut/surface.hpp"

namespace taut {

/// The geometry of a freshly built mesh. Sets the patch and the lines of its triangles and the tags of its vertices.
///
/// Patches are what the feature edges (geometry/features.hpp) part. With `Surface::planar` a patch that is not planar
/// is frozen, and with `Surface::fixed` every one. Only a mesh with patches that are not planar needs a reference
/// surface. A vertex where two feature edges of one kind meet smoothly lies on a line, any other vertex of a feature
/// edge is a corner. Throws InputError for an edge of the input that is not an edge of the mesh.
///
/// With Surface::adapt a surface of another mesh may be given. It then takes the place of that of this mesh, whose
/// vertices may be off it. Planes of the mesh that are not part of it stay planes. Throws InputError, which begins with
/// "geometry: ", if the mesh does not match it.
[[nodiscard]] Model classify(const Mesh& input, Built& built, Surface surface, std::optional<double> ridge_angle,
                             const std::shared_ptr<const ReferenceSurface>& given = nullptr);

}  // namespace taut
