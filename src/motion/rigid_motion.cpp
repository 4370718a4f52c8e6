#include "taut/rigid_motion.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/vec3.hpp"

namespace taut {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

Vector3d vector_of(const Point& p) {
  return Vector3d(p[0], p[1], p[2]);
}

void require_finite(const char* what, const Point& p) {
  if (std::ranges::all_of(p, [](double x) { return std::isfinite(x); })) return;
  throw InputError(fmt::format("{}: ({}, {}, {}) found, expected three finite numbers", what, p[0], p[1], p[2]));
}

void require_finite(const char* what, double x) {
  if (!std::isfinite(x)) throw InputError(fmt::format("{}: {} found, expected a finite number", what, x));
}

/// The axis with length 1. Its largest number decides the scale, so that no square over- or underflows.
Vector3d unit_axis(const Point& axis) {
  const Vector3d v = vector_of(axis);
  const double largest = v.cwiseAbs().maxCoeff();
  if (largest == 0) throw InputError("rotation: axis: (0, 0, 0) found, expected a vector of any other length");
  return (v / largest).normalized();
}

/// The turn as a rotation by half a turn or less.
Quaterniond shorter(const Quaterniond& turn) {
  return turn.w() < 0 ? Quaterniond(-turn.coeffs()) : turn;
}

}  // namespace

struct RigidMotion::Parts {
  Quaterniond turn;
  Vector3d offset;
};

RigidMotion::RigidMotion(const Parts& parts) {
  const Quaterniond turn = parts.turn.normalized();
  const Eigen::Matrix3d matrix = turn.toRotationMatrix();
  for (int i = 0; i < 4; ++i) quaternion_[i] = turn.coeffs()[i];
  for (int i = 0; i < 3; ++i) matrix_[i] = {matrix(i, 0), matrix(i, 1), matrix(i, 2)};
  offset_ = {parts.offset[0], parts.offset[1], parts.offset[2]};
}

RigidMotion::Parts RigidMotion::parts() const {
  return {Quaterniond(quaternion_.data()), vector_of(offset_)};
}

RigidMotion RigidMotion::translation(const Point& by) {
  require_finite("translation", by);
  return RigidMotion({Quaterniond::Identity(), vector_of(by)});
}

RigidMotion RigidMotion::rotation(const Point& centre, const Point& axis, double degrees) {
  require_finite("rotation: centre", centre);
  require_finite("rotation: axis", axis);
  require_finite("rotation: degrees", degrees);
  const double angle = std::remainder(degrees, 360.0) * (std::numbers::pi / 180);
  const Quaterniond turn(AngleAxisd(angle, unit_axis(axis)));
  const Vector3d c = vector_of(centre);
  return RigidMotion({turn, c - turn.toRotationMatrix() * c});
}

Point RigidMotion::operator()(const Point& x) const {
  return Point{dot(matrix_[0], x), dot(matrix_[1], x), dot(matrix_[2], x)} + offset_;
}

Tensor RigidMotion::rotated(const Tensor& tensor) const {
  const auto& [xx, xy, xz, yy, yz, zz] = tensor;
  std::array<Point, 3> columns;  // of M R^T
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& [x, y, z] = matrix_[i];
    columns[i] = {xx * x + xy * y + xz * z, xy * x + yy * y + yz * z, xz * x + yz * y + zz * z};
  }
  return {dot(matrix_[0], columns[0]), dot(matrix_[0], columns[1]), dot(matrix_[0], columns[2]),
          dot(matrix_[1], columns[1]), dot(matrix_[1], columns[2]), dot(matrix_[2], columns[2])};
}

RigidMotion RigidMotion::operator*(const RigidMotion& first) const {
  return RigidMotion({parts().turn * first.parts().turn, vector_of((*this)(first.offset_))});
}

RigidMotion RigidMotion::inverse() const {
  const auto [turn, offset] = parts();
  const Quaterniond back = turn.conjugate();
  return RigidMotion({back, -(back.toRotationMatrix() * offset)});
}

struct RigidMotion::Screw {
  double half = 0;  // of the angle, which is half a turn or less
  double sine = 0;  // of `half`
  Vector3d axis = Vector3d::Zero(), along = Vector3d::Zero(), across = Vector3d::Zero();  // parts of the offset
};

RigidMotion::Screw RigidMotion::screw() const {
  const auto [given, offset] = parts();
  const Quaterniond turn = shorter(given);
  const double sine = turn.vec().stableNorm();
  if (sine == 0) return {.along = offset};
  const Vector3d axis = turn.vec() / sine;
  const Vector3d along = axis.dot(offset) * axis;
  return {std::atan2(sine, turn.w()), sine, axis, along, offset - along};
}

// Across the axis, where vectors are complex numbers, the offset of a rotation by the angle a is c (1 - exp(i a)) for
// the centre c. So that of the share is the whole offset times (1 - exp(i s a)) / (1 - exp(i a)), which is
// exp(i (s - 1) a / 2) sin(s a / 2) / sin(a / 2). Small angles, whose centre is far away, lose no digits.
RigidMotion RigidMotion::share(double s) const {
  require_finite("share", s);
  const auto [half, sine, axis, along, whole] = screw();
  if (sine == 0) return RigidMotion({Quaterniond::Identity(), s * along});
  const Vector3d across = AngleAxisd((s - 1) * half, axis) * whole;
  return RigidMotion({Quaterniond(AngleAxisd(2 * s * half, axis)), s * along + std::sin(s * half) / sine * across});
}

// The derivative of share(s) at 0.
Point RigidMotion::velocity(const Point& x) const {
  const auto [half, sine, axis, along, whole] = screw();
  Vector3d v = along;
  if (sine != 0) v += 2 * half * axis.cross(vector_of(x)) + half / sine * (AngleAxisd(-half, axis) * whole);
  return {v[0], v[1], v[2]};
}

}  // namespace taut
