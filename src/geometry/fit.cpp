#include "geometry/fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace taut {
namespace {

constexpr double flattest = 0.05, steepest = 0.7;  // angles that are always, and never, fair
constexpr double sags = 2.5;                       // by which a harmless swap multiplies the sag
constexpr double least_sag = 1e-3;                 // of the longest edge: always fair

double longest_edge(const std::array<Vec3, 3>& t) {
  return std::max({norm(t[1] - t[0]), norm(t[2] - t[1]), norm(t[0] - t[2])});
}

double largest_curvature(const Sym3& shape) {
  const auto& [xx, xy, xz, yy, yz, zz] = shape;
  return std::sqrt(xx * xx + yy * yy + zz * zz + 2 * (xy * xy + xz * xz + yz * yz));
}

// Cosine of the angle between the triangle and the surface.
double alignment(const Curved& curved, const std::array<Vec3, 3>& t, const Vec3& surface_normal) {
  const Vec3 n = cross(t[1] - t[0], t[2] - t[0]);
  const double cosine = curved.sign * dot(n, surface_normal) / norm(n);
  return curved.two_sided ? std::abs(cosine) : cosine;
}

}  // namespace

double misfit(const Model& model, PatchId patch, const std::array<Vec3, 3>& triangle) {
  const Curved* const curved = model.patches[patch].curved();
  if (curved == nullptr) return 0;
  const Vec3 centre = (1.0 / 3) * (triangle[0] + triangle[1] + triangle[2]);
  const OnPatch at = model.surface->closest_on(curved->patch, centre);
  const double cosine = alignment(*curved, triangle, at.normal);
  if (!(cosine > 0)) return std::numeric_limits<double>::infinity();
  const double length = longest_edge(triangle);
  const double turn = largest_curvature(model.surface->shape_operator(at)) * length;
  const double fair_angle = std::clamp(turn, flattest, steepest);
  const double fair_sag = std::max(sags * turn / 8, least_sag) * length;
  return std::max(std::acos(std::min(cosine, 1.0)) / fair_angle, at.distance / fair_sag);
}

}  // namespace taut
