// Rigid motions of space: how bodies that keep their shape move.
#pragma once

#include <array>

#include "taut/error.hpp"
#include "taut/export.hpp"
#include "taut/mesh.hpp"
#include "taut/metric.hpp"

namespace taut {

/// A rotation followed by a translation: x -> R x + t with det R = 1. Lengths are in the unit of the mesh, angles in
/// degrees.
///
/// R stays orthogonal to rounding however many motions are composed. If a composition or a share leaves the range of
/// double, its numbers are not finite.
class TAUT_EXPORT RigidMotion {
public:
  /// The motion that moves nothing.
  RigidMotion() = default;

  /// x -> x + by. Throws InputError if a number is not finite.
  [[nodiscard]] static RigidMotion translation(const Point& by);

  /// The rotation by `degrees` about the line through `centre` along `axis`, which may have any length but 0; by the
  /// right-hand rule, counterclockwise if the axis points to the viewer. Whole turns are left out. Throws InputError
  /// for an axis of length 0 and if a number is not finite.
  [[nodiscard]] static RigidMotion rotation(const Point& centre, const Point& axis, double degrees);

  /// R x + t: where the point x goes.
  [[nodiscard]] Point operator()(const Point& x) const;

  /// R M R^T: a tensor such as a metric, carried along.
  [[nodiscard]] Tensor rotated(const Tensor& tensor) const;

  /// First `first`, then this.
  [[nodiscard]] RigidMotion operator*(const RigidMotion& first) const;

  /// What undoes the motion.
  [[nodiscard]] RigidMotion inverse() const;

  /// The part s of the motion if it is done at constant velocity: as a screw, which turns about one line and slides
  /// along it, by at most half a turn. share(0) moves nothing, share(1) is the motion itself, share(2) does it twice,
  /// share(-1) undoes it; share(a) * share(b) is share(a + b), all to rounding. Throws InputError if s is not finite.
  [[nodiscard]] RigidMotion share(double s) const;

  /// The velocity with which the point x sets out if the motion is done in one unit of time as share() says, by which
  /// it has to be divided if it takes longer: w x x + c for a screw of angular velocity w.
  [[nodiscard]] Point velocity(const Point& x) const;

  /// The rows of R.
  [[nodiscard]] const std::array<Point, 3>& matrix() const { return matrix_; }

  /// The translation t.
  [[nodiscard]] const Point& offset() const { return offset_; }

private:
  struct Parts;  // the same as quaternion and vector
  explicit RigidMotion(const Parts& parts);
  [[nodiscard]] Parts parts() const;
  struct Screw;  // share() and velocity() see the motion as one
  [[nodiscard]] Screw screw() const;

  std::array<double, 4> quaternion_ = {0, 0, 0, 1};  // x, y, z, w; of length 1
  std::array<Point, 3> matrix_ = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Point offset_ = {0, 0, 0};
};

}  // namespace taut
