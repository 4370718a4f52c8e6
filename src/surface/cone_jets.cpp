#include "surface/cone_jets.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>

namespace taut {
namespace {

constexpr double least_sine = 1e-3;  ///< of the cone's angle, and of those between its three directions

struct Spoke {
  VertexId apex = none, before = none, after = none;  ///< in the sense of the triangles around the apex
  bool is_unique = true;
};

/// By sector of the neighbour.
std::map<std::uint32_t, Spoke> spokes_of(const Facets& facets, const Sectors& sectors,
                                         std::span<const std::uint8_t> is_apex) {
  std::map<std::uint32_t, Spoke> spokes;
  const auto add = [&](std::uint32_t sector, VertexId apex, VertexId Spoke::*side, VertexId neighbour) {
    Spoke& spoke = spokes[sector];
    spoke.is_unique &= (spoke.apex == none || spoke.apex == apex) && spoke.*side == none;
    spoke.apex = apex;
    spoke.*side = neighbour;
  };
  for (const TriangleId t : ids<TriangleId>(facets.triangles.size()))
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId apex = facets.triangles[t][k];
      if (is_apex[apex] == 0) continue;
      const std::size_t next = (k + 1) % 3, last = (k + 2) % 3;
      add(sectors.of_triangle[t][next], apex, &Spoke::after, facets.triangles[t][last]);
      add(sectors.of_triangle[t][last], apex, &Spoke::before, facets.triangles[t][next]);
    }
  return spokes;
}

std::optional<Vec3> unit(const Vec3& x, double least = 0) {
  const double length = norm(x);
  return length > least ? std::optional(1 / length * x) : std::nullopt;
}

/// Of the cone through the three neighbours, at the middle one; the normal looks to the side of `normal`.
std::optional<Derivatives> jet_of_cone(const Facets& facets, const Spoke& spoke, VertexId v, const Vec3& normal) {
  const Vec3& apex = facets.points[spoke.apex];
  const auto a = unit(facets.points[spoke.before] - apex), b = unit(facets.points[v] - apex),
             c = unit(facets.points[spoke.after] - apex);
  if (!a || !b || !c) return {};
  auto axis = unit(cross(*b - *a, *c - *b), least_sine * least_sine);
  if (!axis) return {};
  if (dot(*axis, *b) < 0) axis = -1 * *axis;
  const double cosine = dot(*axis, *b);
  const auto outward = unit(*b - cosine * *axis, least_sine);
  if (!outward) return {};
  const double sine = dot(*outward, *b);
  const Vec3 n = cosine * *outward - sine * *axis, around = cross(*axis, *outward);
  const double sign = dot(n, normal) < 0 ? -1 : 1;
  const double curvature = cosine / (sine * norm(facets.points[v] - apex));
  return Derivatives{sign * n, sign * curvature * outer(around)};
}

}  // namespace

void set_cone_jets(const Facets& facets, const Sectors& sectors, std::span<const std::uint8_t> is_apex,
                   std::vector<Derivatives>& jets) {
  for (const auto& [sector, spoke] : spokes_of(facets, sectors, is_apex)) {
    if (!spoke.is_unique || spoke.before == none || spoke.after == none) continue;
    const VertexId v = sectors.vertices[sector];
    if (const auto jet = jet_of_cone(facets, spoke, v, jets[sector].gradient)) jets[sector] = *jet;
  }
}

}  // namespace taut
