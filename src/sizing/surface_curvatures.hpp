// The curvature of the surface of a mesh, and the sizes that resolve it.
#pragma once

#include <vector>

#include "geometry/model.hpp"
#include "mesh/tet_mesh.hpp"
#include "metric/spectral.hpp"
#include "taut/sizing.hpp"

namespace taut {

/// The principal curvatures at the points of a surface: those of a point on a ridge come once for each smooth side.
struct SurfaceCurvatures {
  std::vector<Index> points;         ///< of the mesh
  std::vector<int> refs;             ///< of the triangles on that side
  std::vector<Spectrum> curvatures;  ///< ascending; the last vector is the normal
};

/// The metric, one tensor for each point of the mesh, intersected with those of the curvatures.
[[nodiscard]] Tensors with_curvatures(Tensors metric, const SurfaceCurvatures& found, const CurvatureOptions& options);

/// Of the given triangles and those that are missing, of reference 0. Throws InputError for a mesh that cannot be used.
[[nodiscard]] SurfaceCurvatures surface_curvatures(const Mesh& mesh, double ridge_angle);

/// Of the curved patches of a model, where they are closest to the vertices on them.
[[nodiscard]] SurfaceCurvatures surface_curvatures(const TetMesh& mesh, const Model& model);

/// Sizes along the surface by its curvatures, and the smaller of them across it. `deviation` is a length, and hmax is
/// finite.
[[nodiscard]] Sym3 metric_of_curvatures(const Spectrum& curvatures, const CurvatureOptions& options);

/// How far chords may be from the surface if its triangles may be 1 from it. A triangle of unit edges is a third
/// farther from a sphere than its edges' chords, and edges may be longer than 1.
inline constexpr double deviation_of_chords = 0.5;

}  // namespace taut
