#include "surface/jump.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace taut {
namespace {

constexpr std::size_t fewest_points_of_side = 8;
constexpr std::size_t fewest_points_by_normal = 6;
constexpr int most_rings_of_side = 2;
constexpr double least_cosine_of_side = 0.2;          ///< to the triangle at the edge: the surface folds beyond
constexpr double least_cosine_of_near_side = 0.5;     ///< no parabola is like a circle beyond
constexpr double largest_cosine_of_fold = 0.8660254;  ///< 30 degrees: an edge that turns by less is no end of a side
constexpr double cosine_of_coarsest_circle = 0.64;    ///< 50 degrees: of eight edges, not quite regular
constexpr double smallest_eigenvalue_of_side = 2e-3;  ///< of scaled normal equations: what is smaller is not determined
constexpr double nearest_of_side = 0.04;  ///< squared, as a share of the farthest: nearer points do not weigh more

template <class Id>
bool holds(const std::vector<Id>& ids, Id id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

/// The slope, along e and f, of the quadratic height over the plane across the normal that fits the offsets best. Of
/// what they do not determine the least: two rows of points show no more than a share of the curvature across them.
std::array<double, 2> slope_at_origin(const Vec3& normal, const Vec3& e, const Vec3& f, std::span<const Vec3> offsets) {
  using Row = Eigen::Matrix<double, 6, 1>;
  double size = 0;
  for (const Vec3& d : offsets) size = std::max(size, norm(d));
  Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
  Row right = Row::Zero();
  for (const Vec3& d : offsets) {
    const double u = dot(e, d) / size, v = dot(f, d) / size, weight = 1 / std::max(u * u + v * v, nearest_of_side);
    const Row row = (Row() << 1, u, v, u * u, 1.4142135623730951 * u * v, v * v).finished();
    matrix += weight * row * row.transpose();
    right += weight * dot(normal, d) / size * row;
  }
  const Row scale = matrix.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(scale.asDiagonal() * matrix *
                                                                          scale.asDiagonal());
  Row along = solver.eigenvectors().transpose() * scale.cwiseProduct(right);
  for (int i = 0; i < 6; ++i)
    along[i] = solver.eigenvalues()[i] > smallest_eigenvalue_of_side ? along[i] / solver.eigenvalues()[i] : 0;
  const Row coefficients = scale.cwiseProduct(solver.eigenvectors() * along);
  return {coefficients[1], coefficients[2]};
}

}  // namespace

JumpFinder::JumpFinder(const Facets& facets, std::span<const EdgePair> pairs, std::span<const Vec3> normals)
    : facets_(facets), normals_(normals), beyond_(facets.triangles.size(), {none, none, none}) {
  for (const auto& [s, t] : pairs) {
    beyond_[s.triangle][s.corner] = t.triangle;
    beyond_[t.triangle][t.corner] = s.triangle;
  }
}

// Turning the other way than the triangles do is no ridge: a parabola turns by more than a circle does. On coarse
// meshes no choice of points is right everywhere: near ones may be too few, no parabola fits far ones, and where all
// edges of a triangle turn by more than this one, its side has to go on across them. An edge is a ridge if all show it.
double JumpFinder::jump_at(const EdgePair& pair) const {
  return std::min({jump_at(pair, Reach::near), jump_at(pair, Reach::far), jump_at(pair, Reach::across_edges)});
}

double JumpFinder::jump_at(const EdgePair& pair, Reach reach) const {
  const Vec3 a = normal_of_side(pair[0], pair[1], reach), b = normal_of_side(pair[1], pair[0], reach);
  const Vec3 &m = normals_[pair[0].triangle], &n = normals_[pair[1].triangle], axis = cross(m, n), turn = cross(a, b);
  const double size = dot(m, n) > 0 ? dot(turn, axis) / norm(axis) : norm(turn);  // a fold has no sense
  return std::atan2(size, dot(a, b));
}

// Triangles of a side have normals that are, seen along the edge, nearer to that of this side's triangle than to the
// other's: so a side does not go around the end of the edge, whether the ridge goes on there or not. Where the surface
// bends to and fro, this leaves too few; then those count that lie on this side of the edge.
std::vector<VertexId> JumpFinder::points_of_side(const EdgeUse& side, const EdgeUse& other, Reach reach) const {
  const Vec3 &own = normals_[side.triangle], &opposite = normals_[other.triangle];
  const Vec3& origin = facets_.points[side.edge[0]];
  const Vec3 along = facets_.points[side.edge[1]] - origin, middle = own + opposite;
  const Vec3 apart = own - opposite, to_own_normal = apart - dot(apart, along) / dot(along, along) * along,
             to_side = cross(along, middle);
  const auto place = [&](TriangleId t) {
    const auto [a, b, c] = places_of(facets_, t);
    return dot(to_side, a + b + c - 3 * origin);
  };
  const bool is_positive = place(side.triangle) > 0;
  const auto is_by_normal = [&](TriangleId t) { return dot(normals_[t], to_own_normal) >= 0; };
  const auto is_by_place = [&](TriangleId t) { return (place(t) > 0) == is_positive; };
  const double cosine = dot(own, opposite),
               clearly_sharper = std::min(cosine * std::abs(cosine), largest_cosine_of_fold);
  const Bounds bounds = {reach == Reach::near ? least_cosine_of_near_side : least_cosine_of_side, clearly_sharper};
  auto points = grown(side, other, bounds, is_by_normal);
  if (points.size() < fewest_points_by_normal) points = grown(side, other, bounds, is_by_place);
  if (points.size() >= fewest_points_by_normal || reach != Reach::across_edges) return points;
  return grown(side, other, {least_cosine_of_side, std::min(clearly_sharper, cosine_of_coarsest_circle)}, is_by_place);
}

// Ring by ring around the points so far, and not across edges that turn by clearly more than this one.
template <class IsOfSide>
std::vector<VertexId> JumpFinder::grown(const EdgeUse& side, const EdgeUse& other, const Bounds& bounds,
                                        IsOfSide is_of_side) const {
  const Vec3& own = normals_[side.triangle];
  const auto may_enter = [&](TriangleId from, TriangleId to) {
    return to != none && to != other.triangle && dot(normals_[to], own) >= bounds.to_first &&
           dot(normals_[to], normals_[from]) >= bounds.to_previous && is_of_side(to);
  };
  std::vector<TriangleId> triangles{side.triangle};
  std::vector<VertexId> points(facets_.triangles[side.triangle].begin(), facets_.triangles[side.triangle].end());
  for (int ring = 0; ring < most_rings_of_side && points.size() < fewest_points_of_side; ++ring) {
    const std::vector<VertexId> inner = points;
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for (const TriangleId t : beyond_[triangles[i]]) {
        if (!may_enter(triangles[i], t) || holds(triangles, t)) continue;
        const Corners& corners = facets_.triangles[t];
        if (std::none_of(corners.begin(), corners.end(), [&](VertexId v) { return holds(inner, v); })) continue;
        triangles.push_back(t);
        for (const VertexId v : corners)
          if (!holds(points, v)) points.push_back(v);
      }
  }
  return points;
}

Vec3 JumpFinder::normal_of_side(const EdgeUse& side, const EdgeUse& other, Reach reach) const {
  const Vec3 &a = facets_.points[side.edge[0]], &b = facets_.points[side.edge[1]], &normal = normals_[side.triangle];
  std::vector<Vec3> offsets;
  for (const VertexId v : points_of_side(side, other, reach)) offsets.push_back(facets_.points[v] - 0.5 * (a + b));
  const double length = norm(b - a);
  if (!(length > 0)) return normal;
  const Vec3 e = 1 / length * (b - a), f = cross(normal, e);
  const auto [along, across] = slope_at_origin(normal, e, f, offsets);
  return normal - along * e - across * f;
}

}  // namespace taut
