#include "geometry/fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "metric/length.hpp"

namespace taut {
namespace {

constexpr double flattest = 0.05, steepest = 0.7;  // angles that are always fair, and above which none is
constexpr double most_turned = 1;                  // angle by which the surface may turn along an edge
constexpr double sags = 2.5;                       // by which a harmless swap multiplies the sag
constexpr double least_sag = 1e-3;                 // of the longest edge: always fair

struct Extent {
  double length = 0;  ///< of the longest edge
  double turn = 0;    ///< the largest angle by which the surface turns along an edge
  double sag = 0;     ///< the largest distance of an edge's chord from the surface, about
};

// With a metric, the sag of an edge is at most that of one that is not split.
Extent extent_of(const std::array<Vec3, 3>& t, const Sym3& shape, const Sym3* metric) {
  Extent extent;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 edge = t[(k + 1) % 3] - t[k];
    const double length = norm(edge), turn = norm(shape * edge);
    extent.length = std::max(extent.length, length);
    extent.turn = std::max(extent.turn, turn);
    const double unit = metric != nullptr ? std::min(1.0, longest_unit / length_in(*metric, edge)) : 1;
    extent.sag = std::max(extent.sag, unit * unit * turn * length / 8);
  }
  return extent;
}

// Cosine of the angle between the triangle and the surface.
double alignment(const Curved& curved, const std::array<Vec3, 3>& t, const Vec3& surface_normal) {
  const Vec3 n = cross(t[1] - t[0], t[2] - t[0]);
  const double cosine = curved.sign * dot(n, surface_normal) / norm(n);
  return curved.two_sided ? std::abs(cosine) : cosine;
}

}  // namespace

double misfit(const Model& model, PatchId patch, const std::array<Vec3, 3>& triangle, const Sym3& metric,
              SeatId& near) {
  const Curved* const curved = model.patches[patch].curved();
  if (curved == nullptr) return 0;
  const Vec3 centre = (1.0 / 3) * (triangle[0] + triangle[1] + triangle[2]);
  const OnPatch at = model.surface.closest_on(*curved, centre, near);
  const double cosine = alignment(*curved, triangle, at.normal);
  if (!(cosine > 0)) return std::numeric_limits<double>::infinity();
  const Extent extent =
      extent_of(triangle, model.surface.shape_operator(*curved, at), model.has_contacts ? &metric : nullptr);
  const double fair_angle = std::clamp(extent.turn, flattest, steepest);
  const double fair_sag = std::min(std::max(sags * extent.sag, least_sag * extent.length), model.deviation);
  return std::max({std::acos(std::min(cosine, 1.0)) / fair_angle, at.distance / fair_sag, extent.turn / most_turned});
}

}  // namespace taut
