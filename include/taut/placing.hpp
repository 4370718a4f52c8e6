// A mesh with vertices on a level set.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "taut/adapt.hpp"
#include "taut/export.hpp"
#include "taut/geometry.hpp"
#include "taut/mesh.hpp"
#include "taut/metric.hpp"

namespace taut {

/// A scalar at a point. Called from one thread; the same point gives the same value.
using ScalarFunction = std::function<double(const Point&)>;

/// How vertices are placed.
struct PlaceOptions {
  /// Largest Q that an inserted vertex may leave around it, above 1; a moved one a quarter of it. Where it was larger
  /// before, it may grow by a ninth. The last edges that deviate are split even if Q becomes ten times as large.
  double Q_max = 20;
  double deviation = 0;                 ///< edges and faces on the surface farther than this from it are split; 0: none
  Surface surface = Surface::adapt;     ///< what may change on the boundary and between regions
  std::optional<double> ridge_angle{};  ///< degrees, as in AdaptOptions
  std::optional<Geometry> geometry{};   ///< as in AdaptOptions, but vertices that are off it are only counted
};

/// A mesh, and what was done to it.
struct Placed {
  AdaptResult adapted;         ///< the mesh, the metric on it, where its points lie in the input
  std::vector<double> values;  ///< of the function at its points; exactly 0 at those on the surface
  std::size_t moved = 0;       ///< vertices that were moved onto the surface
  std::size_t inserted = 0;    ///< vertices that were inserted on it
  std::size_t crossed = 0;     ///< edges that the surface still crosses between their ends
};

/// Moves vertices of the edges that the surface u = 0 crosses onto it, the nearer end of each first, where the
/// tetrahedra around stay good in the metric; then inserts vertices on the edges that it still crosses, and in the
/// middle of those that deviate from it. The piecewise linear surface of the result then has its vertices on u = 0 but
/// for few, so that it is as close with far fewer elements across it. Call it last, after adaptation: adapt() would
/// move the vertices away. Throws InputError as adapt() does.
[[nodiscard]] TAUT_EXPORT Placed place_on_level_set(const Mesh& mesh, const Metric& metric, const ScalarFunction& u,
                                                    const PlaceOptions& options = {});

/// The same for a field that is known at the points of `mesh` only: between them the quadratic functions that fit it
/// are taken, blended linearly.
[[nodiscard]] TAUT_EXPORT Placed place_on_level_set(const Mesh& mesh, const Metric& metric,
                                                    std::span<const double> values, const PlaceOptions& options = {});

}  // namespace taut
