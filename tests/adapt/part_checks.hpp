// What must hold for a part from CAD, whose surfaces are known by formulas.
#pragma once

#include <optional>

#include "adapt/curved_checks.hpp"
#include "adapt/parts.hpp"

namespace taut::test {

constexpr double rounding = 1e-9;  // relative to the size of the part

inline double diagonal_of(const Mesh& mesh) {
  Point low = mesh.points[0], high = low;
  for (const Point& p : mesh.points)
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  return norm(high - low);
}

using EdgeKey = std::array<Index, 2>;

inline EdgeKey ascending(Index a, Index b) {
  return {std::min(a, b), std::max(a, b)};
}

/// For each edge of a triangle the references of its triangles.
inline std::map<EdgeKey, std::multiset<int>> refs_at_edges(const Mesh& mesh) {
  std::map<EdgeKey, std::multiset<int>> refs;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      refs[ascending(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3])].insert(ref_of(mesh.triangle_refs, t));
  return refs;
}

/// The edges at which other than two triangles meet, or two of different reference.
inline std::map<EdgeKey, std::multiset<int>> border_edges(const Mesh& mesh) {
  std::map<EdgeKey, std::multiset<int>> refs = refs_at_edges(mesh);
  std::erase_if(
      refs, [](const auto& edge) { return edge.second.size() == 2 && *edge.second.begin() == *edge.second.rbegin(); });
  return refs;
}

/// The edges of each given reference that lie where patches end, or on no triangle: not the seams of the mesher.
inline std::map<int, std::vector<EdgeKey>> lines_of(const Mesh& mesh) {
  const auto all = refs_at_edges(mesh);
  const auto borders = border_edges(mesh);
  std::map<int, std::vector<EdgeKey>> lines;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const EdgeKey edge = ascending(mesh.edges[e][0], mesh.edges[e][1]);
    if (borders.contains(edge) || !all.contains(edge)) lines[ref_of(mesh.edge_refs, e)].push_back(edge);
  }
  return lines;
}

struct Straight {
  Point from;
  Vec3 along;  ///< of unit length
};

inline double distance_from(const Straight& line, const Point& x) {
  return norm(cross(x - line.from, line.along));
}

/// The straight line through the ends of these edges, if there is one.
inline std::optional<Straight> straight(const Mesh& mesh, const std::vector<EdgeKey>& edges, double tolerance) {
  const Point from = mesh.points[edges[0][0]];
  Point to = from;
  for (const auto& edge : edges)
    for (const Index p : edge)
      if (norm(mesh.points[p] - from) > norm(to - from)) to = mesh.points[p];
  const Straight line = {from, (1 / norm(to - from)) * (to - from)};
  for (const auto& edge : edges)
    for (const Index p : edge)
      if (distance_from(line, mesh.points[p]) > tolerance) return {};
  return line;
}

inline double length_of(const Mesh& mesh, const std::vector<EdgeKey>& edges) {
  double sum = 0;
  for (const auto& [a, b] : edges) sum += norm(mesh.points[a] - mesh.points[b]);
  return sum;
}

/// The points of each patch, by reference.
inline std::map<int, std::set<Index>> points_of_patches(const Mesh& mesh) {
  std::map<int, std::set<Index>> points;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    points[ref_of(mesh.triangle_refs, t)].insert(mesh.triangles[t].begin(), mesh.triangles[t].end());
  return points;
}

/// The exact surface of each curved patch, by reference: the one on which all points of the mesher lie.
inline std::map<int, Shape> shapes_of(const Part& part, const Mesh& in) {
  std::map<int, Shape> shapes;
  for (const auto& [ref, points] : points_of_patches(in))
    for (const Shape& shape : part.shapes)
      if (std::ranges::all_of(points, [&](Index p) { return std::abs(shape.distance(in.points[p])) < rounding; }))
        shapes.emplace(ref, shape);
  return shapes;
}

/// The points where lines of the boundary end, meet, or change their reference.
inline std::multiset<Point> corners_of(const Mesh& mesh) {
  std::map<Index, std::multiset<int>> refs;
  for (const auto& [ref, edges] : lines_of(mesh))
    for (const auto& edge : edges)
      for (const Index p : edge) refs[p].insert(ref);
  std::multiset<Point> corners;
  for (const auto& [p, of] : refs)
    if (of.size() != 2 || *of.begin() != *of.rbegin()) corners.insert(mesh.points[p]);
  return corners;
}

inline void expect_same_lines(const Mesh& out, const Mesh& in) {
  const double tolerance = rounding * diagonal_of(in);
  auto found = lines_of(out);
  for (const auto& [ref, edges] : lines_of(in)) {
    ASSERT_TRUE(found.contains(ref)) << "no line of reference " << ref << " is left";
    const auto line = straight(in, edges, tolerance);
    if (!line) continue;
    EXPECT_NEAR(length_of(out, found[ref]), length_of(in, edges), tolerance) << "line of reference " << ref;
    for (const auto& edge : found[ref])
      for (const Index p : edge)
        EXPECT_LT(distance_from(*line, out.points[p]), tolerance) << "point " << p << ", line of reference " << ref;
  }
  EXPECT_EQ(found.size(), lines_of(in).size());
  EXPECT_EQ(corners_of(out), corners_of(in));
}

/// Which patches meet, and the Euler characteristic of each of them.
inline void expect_same_topology(const Mesh& out, const Mesh& in) {
  const auto meet = [](const Mesh& mesh) {
    std::set<std::multiset<int>> refs;
    for (const auto& [edge, at] : border_edges(mesh)) refs.insert(at);
    return refs;
  };
  const auto characteristics = [](const Mesh& mesh) {
    std::map<int, long long> sums;
    for (const auto& [ref, points] : points_of_patches(mesh)) sums[ref] += static_cast<long long>(points.size());
    for (const auto& [edge, at] : refs_at_edges(mesh))
      for (const int ref : std::set<int>(at.begin(), at.end())) --sums[ref];
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) ++sums[ref_of(mesh.triangle_refs, t)];
    return sums;
  };
  EXPECT_EQ(meet(out), meet(in));
  EXPECT_EQ(characteristics(out), characteristics(in));
  EXPECT_EQ(euler_characteristic(out), euler_characteristic(in));
}

/// All patches that lie on no shape are planar, and stay in their planes.
inline void expect_same_planes(const Mesh& out, const Mesh& in, const std::map<int, Shape>& shapes) {
  std::map<int, std::pair<Point, Vec3>> planes;
  for (std::size_t t = 0; t < in.triangles.size(); ++t) {
    const Vec3 n = area_normal(in, in.triangles[t]);
    planes.try_emplace(ref_of(in.triangle_refs, t), in.points[in.triangles[t][0]], (1 / norm(n)) * n);
  }
  for (const auto& [ref, points] : points_of_patches(out)) {
    if (shapes.contains(ref)) continue;
    const auto& [origin, normal] = planes.at(ref);
    for (const Index p : points)
      EXPECT_LT(std::abs(dot(out.points[p] - origin, normal)), rounding * diagonal_of(in))
          << "point " << p << " has left the plane of reference " << ref;
  }
}

}  // namespace taut::test
