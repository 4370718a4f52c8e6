// Triangles in space, of a tetrahedral mesh or of a surface alone.
#pragma once

#include <array>
#include <vector>

#include "base/buckets.hpp"
#include "surface/surface_edges.hpp"

namespace taut {

struct Facets {
  std::vector<Vec3> points;        ///< by vertex; a vertex may belong to no triangle
  std::vector<Corners> triangles;  ///< the sense of rotation gives the normal
};

/// The triangles of a mesh, with its ids. None of them is dead.
[[nodiscard]] Facets facets_of(const TetMesh& mesh);

/// How far a vertex may be from a plane or a line to which it belongs, as a share of the diagonal of the whole:
/// coordinates written with ten digits pass.
inline constexpr double flatness = 1e-9;

/// The same as a length.
[[nodiscard]] double flatness_tolerance(const Facets& facets);

[[nodiscard]] inline std::array<Vec3, 3> places_of(const Facets& facets, TriangleId t) {
  const auto& [a, b, c] = facets.triangles[t];
  return {facets.points[a], facets.points[b], facets.points[c]};
}

/// Its length is twice the area.
[[nodiscard]] Vec3 area_normal(const Facets& facets, TriangleId t);

/// Of unit length; zero for a triangle without area.
[[nodiscard]] std::vector<Vec3> unit_normals(const Facets& facets);

/// The vertices' triangles, ascending.
[[nodiscard]] Buckets<TriangleId> triangles_of_vertices(const Facets& facets);

/// Turns triangles so that those that meet at these edges have one sense of rotation, which is that of the first one of
/// each connected set. Returns the edges at which this is possible: a Moebius strip keeps one where it is not.
[[nodiscard]] std::vector<EdgePair> orient(std::vector<Corners>& triangles, std::vector<EdgePair> edges);

}  // namespace taut
