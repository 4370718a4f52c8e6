// What a reference surface is made from.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "surface/facets.hpp"
#include "surface/ridges.hpp"
#include "taut/mesh.hpp"

namespace taut {

struct SurfaceInput {
  Facets facets;                        ///< at least one triangle
  std::vector<int> refs;                ///< of each triangle
  std::vector<GivenEdge> edges;         ///< ascending, each once
  std::vector<std::uint8_t> is_corner;  ///< by vertex: given as a corner, or required
};

/// The surface of a mesh: its triangles, turned outward where they bound tetrahedra, and those that are missing on the
/// boundary of the tetrahedra and between regions, of reference 0, after them. A mesh without tetrahedra is a surface
/// as it is. Vertices are the points of the mesh. Throws InputError for a mesh that cannot be used, and for a
/// triangle of an edge without length.
[[nodiscard]] SurfaceInput surface_of(const Mesh& mesh);

/// Adds the edges and corners that are given in `mesh`, whose points may have other numbers here.
[[nodiscard]] SurfaceInput with_marks(SurfaceInput input, const Mesh& mesh, std::span<const VertexId> vertex_of_point);

}  // namespace taut
