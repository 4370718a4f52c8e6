#include "surface/apexes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "surface/sector_jets.hpp"

namespace taut {
namespace {

constexpr double least_tilt_at_apex = 15 * std::numbers::pi / 180;  ///< of each triangle from the axis
constexpr double least_share_of_tilt = 0.8;                         ///< of that of the neighbours' normals
constexpr double most_bend = 1.4;  ///< of the second ring, relative to the first: 1 on a cone, 2 on a sphere

/// Sums over the triangles at a vertex.
struct Tilts {
  double of_triangles = 0, of_neighbours = 0;  ///< each triangle leads to two neighbours
  double least = std::numbers::pi;             ///< of the triangles
  int triangles = 0;
};

double tilt_between(const Vec3& a, const Vec3& b) {
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

std::vector<Tilts> tilts_of(const Facets& facets, const Sectors& sectors, std::span<const Vec3> normals) {
  const std::vector<Vec3> flat = unit_normals(facets);
  std::vector<Tilts> tilts(sectors.vertices.size());
  for (const TriangleId t : ids<TriangleId>(facets.triangles.size())) {
    const auto& of = sectors.of_triangle[t];
    for (std::size_t k = 0; k < 3; ++k) {
      Tilts& at = tilts[of[k]];
      const double tilt = tilt_between(normals[of[k]], flat[t]);
      at.of_triangles += tilt;
      ++at.triangles;
      at.least = std::min(at.least, tilt);
      for (const std::size_t other : {(k + 1) % 3, (k + 2) % 3})
        at.of_neighbours += 0.5 * tilt_between(normals[of[k]], normals[of[other]]);
    }
  }
  return tilts;
}

/// Whether the vertices two edges away are seen from a sector about as steeply as those one edge away.
class ConeTest {
public:
  ConeTest(const Facets& facets, const Sectors& sectors, std::span<const Vec3> normals)
      : facets_(facets), sectors_(sectors), normals_(normals), triangles_at_(triangles_of_vertices(facets)) {}

  [[nodiscard]] bool holds_at(std::uint32_t sector) const {
    std::vector<std::uint32_t> seen{sector};
    grow(seen, 0);
    const std::size_t first = seen.size();
    grow(seen, 1);
    if (seen.size() == first) return true;
    const std::span all(seen);
    const double near = mean_slope(sector, all.subspan(1, first - 1)), far = mean_slope(sector, all.subspan(first));
    return std::abs(far) < most_bend * std::abs(near);
  }

private:
  /// Adds the neighbours of those from `begin` on.
  void grow(std::vector<std::uint32_t>& seen, std::size_t begin) const {
    for (std::size_t i = begin, end = seen.size(); i < end; ++i)
      for (const TriangleId t : triangles_at_[sectors_.vertices[seen[i]]]) {
        const auto& of = sectors_.of_triangle[t];
        if (std::ranges::find(of, seen[i]) == of.end()) continue;
        for (const std::uint32_t s : of)
          if (std::ranges::find(seen, s) == seen.end()) seen.push_back(s);
      }
  }

  /// Angle of the directions from the sector's vertex below its tangent plane.
  [[nodiscard]] double mean_slope(std::uint32_t from, std::span<const std::uint32_t> to) const {
    double sum = 0;
    for (const std::uint32_t s : to) {
      const Vec3 d = facets_.points[sectors_.vertices[s]] - facets_.points[sectors_.vertices[from]];
      sum += std::atan2(-dot(normals_[from], d), norm(cross(normals_[from], d)));
    }
    return sum / static_cast<double>(to.size());
  }

  const Facets& facets_;
  const Sectors& sectors_;
  std::span<const Vec3> normals_;
  Buckets<TriangleId> triangles_at_;
};

/// Of adjacent apexes the one whose triangles are tilted most: those next to a tip look like tips.
void keep_sharpest(const Facets& facets, const Sectors& sectors, std::span<const Tilts> tilts,
                   std::vector<std::uint8_t>& is_apex) {
  std::vector<double> sharpness(facets.points.size(), 0);
  for (std::size_t s = 0; s < tilts.size(); ++s)
    if (is_apex[sectors.vertices[s]] != 0) sharpness[sectors.vertices[s]] = tilts[s].of_triangles / tilts[s].triangles;
  for (const Corners& t : facets.triangles)
    for (const VertexId v : t)
      for (const VertexId w : t)
        if (sharpness[w] > sharpness[v]) is_apex[v] = 0;
}

}  // namespace

std::vector<std::uint8_t> find_apexes(const Facets& facets, const Sectors& sectors, std::span<const RidgeEdge> ridges) {
  const std::vector<Vec3> normals = max_normals(facets, sectors);
  const std::vector<Tilts> tilts = tilts_of(facets, sectors, normals);
  std::vector<std::uint8_t> is_apex(facets.points.size(), 0);
  const ConeTest is_cone(facets, sectors, normals);
  for (std::uint32_t s = 0; s < tilts.size(); ++s)
    if (tilts[s].least > least_tilt_at_apex && tilts[s].of_triangles > least_share_of_tilt * tilts[s].of_neighbours &&
        is_cone.holds_at(s))
      is_apex[sectors.vertices[s]] = 1;
  keep_sharpest(facets, sectors, tilts, is_apex);
  for (const RidgeEdge& ridge : ridges)
    for (const VertexId v : ridge.edge) is_apex[v] = 0;  // has one-sided normals as it is
  return is_apex;
}

}  // namespace taut
