// From a solution to a metric: Hessians, error-driven metrics, and what they are made from.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "taut/export.hpp"
#include "taut/limits.hpp"
#include "taut/mesh.hpp"
#include "taut/metric.hpp"

namespace taut {

/// How the Hessian of a field is recovered from its values at the points of a mesh.
enum class Recovery {
  /// A quadratic function is fitted to the values within two edges of each point, more if they do not determine it, in
  /// a frame scaled by the mesh there. Exact for quadratic fields, also on the boundary.
  least_squares,
  /// The gradients of the tetrahedra are averaged by volume, twice. It smooths noise, but it does not converge as the
  /// mesh is refined.
  double_projection,
};

/// The Hessian at each point of the field with the given value at each point of `mesh`; zero at points that belong to
/// no tetrahedron. Throws InputError for a mesh that cannot be used or that is too small, for a wrong number of values
/// and for one that is not finite, naming its index.
[[nodiscard]] TAUT_EXPORT Tensors recover_hessian(const Mesh& mesh, std::span<const double> values,
                                                  Recovery recovery = Recovery::least_squares);

inline constexpr double vertices_per_complexity = 2.6;     ///< of a unit mesh with thousands of vertices (measured)
inline constexpr double tetrahedra_per_complexity = 10.5;  ///< of a unit mesh (measured)

/// What lp_metric() aims at.
struct LpOptions {
  /// Above 0. A unit mesh has `vertices_per_complexity` times as many vertices and `tetrahedra_per_complexity` times as
  /// many tetrahedra.
  double complexity = 0;
  double norm = 2;  ///< p of the L^p norm of the interpolation error, in [1, infinity]
  Limits limits{};  ///< on the metric, which has the complexity all the same
};

/// A metric that was scaled to a complexity.
struct ScaledMetric {
  Tensors metric;         ///< at the points of the mesh
  double complexity = 0;  ///< of the metric, with all limits applied
  int evaluations = 0;    ///< how often limits were applied and the complexity computed
  /// What keeps the complexity from the one that was asked for: "hmin", "hmax", or empty if nothing does.
  std::string stopped_by;
};

/// The metric that minimises the L^p norm of the interpolation error for a given complexity,
/// det|H|^(-1/(2p+3)) |H| times a constant (Alauzet and Loseille 2010); the constant is such that the complexity is
/// within 0.2 % of the one that was asked for after all limits are applied. The metrics of several fields, one array of
/// Hessians each, are scaled to the same complexity, then intersected; those whose Hessian is zero everywhere are left
/// out. Throws InputError for arrays of wrong length, a tensor that is not finite (naming its index), and options that
/// make no sense.
[[nodiscard]] TAUT_EXPORT ScaledMetric lp_metric(const Mesh& mesh, std::span<const Tensors> hessians,
                                                 const LpOptions& options);

/// The metric in which a unit mesh has an interpolation error of about `error` (above 0, in the unit of the field)
/// everywhere: the eigenvalues are 9/32 |l_i| / error (Dobrzynski and Frey 2008, 2.4).
[[nodiscard]] TAUT_EXPORT Tensors error_metric(const Mesh& mesh, const Tensors& hessian, double error,
                                               const Limits& limits = {});

/// How finely the surface u = 0 is resolved.
struct LevelSetOptions {
  /// Size across the surface, above 0. The piecewise linear surface is then within about 0.3 times it (measured).
  double error = 0;
  double across = 0;  ///< as a share of the smaller size along the surface, that across it is at least this, 0 or more
  double growth = 0.6;    ///< of the size across the surface per distance from it, 0 or more
  double refinement = 2;  ///< above 1: sizes shrink at most by this factor from those of the mesh
  Limits limits{};        ///< hmax is the size far from the surface
};

/// The metric that resolves the surface u = 0 of the field with the given values: at the vertices of the elements that
/// it crosses the size is `error` along the normal and sqrt(error / |k|) in the two directions of principal curvature k
/// (Dobrzynski and Frey 2008, 5.2). Away from them, all sizes grow by the same factor, so that the size along the
/// normal grows by `growth` times the distance |u| / |grad u|. On a coarse mesh the elements that are crossed are
/// thick, and would all ask for the finest size: therefore sizes are bounded from below by those of the mesh over
/// `refinement`, and a few adaptations lead to the metric.
[[nodiscard]] TAUT_EXPORT Tensors level_set_metric(const Mesh& mesh, std::span<const double> values,
                                                   const LevelSetOptions& options);

/// How finely the surface of a mesh is resolved.
struct CurvatureOptions {
  /// Above 0: how far an edge of the wanted size may be from the circle of curvature in its direction.
  double deviation = 0;
  bool relative = false;  ///< whether `deviation` is a share of the diagonal of the bounding box
  double turn = 60;  ///< degrees, above 0 and at most 90: by which the surface turns at most along an edge, whatever
                     ///< the deviation
  double ridge_angle = 45;  ///< degrees, as in AdaptOptions: the surface is not smooth there
  Limits limits{};  ///< hmax is the size where nothing is curved, gradation says how sizes grow from the surface
};

/// The metric that resolves the curvature of the surface of `mesh`: of its boundary and of the triangles inside, given
/// or missing. At a vertex of the surface the size in a direction of principal curvature k = 1 / R is the chord that is
/// `deviation` from a circle of radius R, 2 sqrt(deviation (2 R - deviation)) or about sqrt(8 deviation R); a triangle
/// with such edges on a sphere is a third farther away. Across the surface the size is the smaller of the two. Where
/// the surface is planar, and at vertices inside, it is hmax.
///
/// The larger size is at most 1.2 sqrt(R h), h the smaller one: otherwise the long edges would leave the surface by as
/// much as the short ones are long, and triangles would stand across it (Schwarz's lantern).
///
/// Curvatures are those of polynomials fitted to the vertices within three edges. They are one-sided at edges where the
/// normals differ by `ridge_angle` or more or references differ, that are ridges of `mesh`, or that do not belong to
/// two triangles: there the metric is the intersection of those on all sides. Other given edges part nothing.
///
/// Throws InputError for a mesh that cannot be used and for options that make no sense.
[[nodiscard]] TAUT_EXPORT Tensors curvature_metric(const Mesh& mesh, const CurvatureOptions& options);

/// The metric in which the edges of `mesh` have about unit length: that of each tetrahedron, in which its six edges
/// have length 1, averaged at the points, log-Euclidean, weighted by volume. A point that belongs to no tetrahedron
/// takes the size of the bounding box. It is what adapt() needs to mend a mesh without changing its sizes: the result
/// has about as many tetrahedra, within 15 % also for bad meshes, because the averages of logarithms are geometric
/// means of volumes.
[[nodiscard]] TAUT_EXPORT Tensors implied_metric(const Mesh& mesh);

/// The tensors at the points of `mesh`: the given ones, h^-2 times the identity for sizes h, or the values of the
/// function. Throws InputError naming the point where the metric is not finite and positive definite.
[[nodiscard]] TAUT_EXPORT Tensors tensors_of(const Mesh& mesh, const Metric& metric);

/// The intersection of both metrics at each point: the largest sizes that neither of them forbids (Dobrzynski and Frey
/// 2008, 2.2). Throws InputError if the lengths differ, or for a tensor that is not positive definite.
[[nodiscard]] TAUT_EXPORT Tensors intersection(const Tensors& a, const Tensors& b);

/// The integral of sqrt(det M) over the mesh, which is proportional to the number of elements of a unit mesh:
/// sqrt(det M) is interpolated between the points.
[[nodiscard]] TAUT_EXPORT double complexity(const Mesh& mesh, const Tensors& metric);

}  // namespace taut
