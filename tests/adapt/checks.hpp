// What must hold for every adaptation, whatever the mesh and the metric.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "mesh/orientation.hpp"
#include "mesh/shapes.hpp"
#include "metric/random_metrics.hpp"
#include "taut/adapt.hpp"

namespace taut::test {

inline int ref_of(const std::vector<int>& refs, std::size_t i) {
  return refs.empty() ? 0 : refs[i];
}

inline std::map<int, double> volumes(const Mesh& mesh) {
  std::map<int, double> sums;
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    const auto& v = mesh.tetrahedra[t];
    sums[ref_of(mesh.tetrahedron_refs, t)] +=
        std::abs(six_volumes(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]])) / 6;
  }
  return sums;
}

inline std::map<int, double> areas(const Mesh& mesh) {
  std::map<int, double> sums;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    sums[ref_of(mesh.triangle_refs, t)] += norm(area_normal(mesh, mesh.triangles[t]));
  return sums;
}

/// Lengths of the edges of each reference.
inline std::map<int, double> lengths(const Mesh& mesh) {
  std::map<int, double> sums;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    sums[ref_of(mesh.edge_refs, e)] += norm(mesh.points[mesh.edges[e][0]] - mesh.points[mesh.edges[e][1]]);
  return sums;
}

inline void expect_same_sums(const std::map<int, double>& found, const std::map<int, double>& expected,
                             const char* what) {
  for (const auto& [ref, value] : expected) {
    ASSERT_TRUE(found.contains(ref)) << "no " << what << " of reference " << ref << " is left";
    EXPECT_NEAR(found.at(ref), value, 1e-12 * value) << what << " of reference " << ref;
  }
  EXPECT_EQ(found.size(), expected.size()) << what;
}

/// Entities by their points, in any order of the points, with their reference.
template <std::size_t n>
std::set<std::pair<std::array<Point, n>, int>> placed(const Mesh& mesh,
                                                      const std::vector<std::array<Index, n>>& entities,
                                                      const std::vector<int>& refs, const std::vector<Index>& which) {
  std::set<std::pair<std::array<Point, n>, int>> found;
  for (const Index e : which) {
    std::array<Point, n> points;
    for (std::size_t k = 0; k < n; ++k) points[k] = mesh.points[entities[e][k]];
    std::sort(points.begin(), points.end());
    found.emplace(points, ref_of(refs, e));
  }
  return found;
}

inline std::vector<Index> all_of(std::size_t n) {
  std::vector<Index> all;
  for (Index i = 0; i < n; ++i) all.push_back(i);
  return all;
}

inline std::set<std::pair<std::array<Point, 3>, int>> placed_triangles(const Mesh& mesh) {
  return placed(mesh, mesh.triangles, mesh.triangle_refs, all_of(mesh.triangles.size()));
}

inline std::multiset<Point> placed_points(const Mesh& mesh, const std::vector<Index>& which) {
  std::multiset<Point> points;
  for (const Index p : which) points.insert(mesh.points[p]);
  return points;
}

inline void expect_marks_kept(const Mesh& out, const Mesh& in) {
  EXPECT_EQ(placed_points(out, out.corners), placed_points(in, in.corners));
  EXPECT_EQ(placed_points(out, out.required_points), placed_points(in, in.required_points));
  EXPECT_EQ(placed(out, out.edges, out.edge_refs, out.required_edges),
            placed(in, in.edges, in.edge_refs, in.required_edges));
  EXPECT_EQ(placed(out, out.triangles, out.triangle_refs, out.required_triangles),
            placed(in, in.triangles, in.triangle_refs, in.required_triangles));
  EXPECT_EQ(placed(out, out.tetrahedra, out.tetrahedron_refs, out.required_tetrahedra),
            placed(in, in.tetrahedra, in.tetrahedron_refs, in.required_tetrahedra));
}

/// Vertices that are kept keep their references; corners and vertices of required entities keep their places.
inline void expect_map_right(const AdaptResult& result, const Mesh& in) {
  const Mesh& out = result.mesh;
  ASSERT_EQ(result.new_of_old.size(), in.points.size());
  std::set<Index> fixed(in.corners.begin(), in.corners.end());
  fixed.insert(in.required_points.begin(), in.required_points.end());
  for (const Index t : in.required_tetrahedra) fixed.insert(in.tetrahedra[t].begin(), in.tetrahedra[t].end());
  for (const Index t : in.required_triangles) fixed.insert(in.triangles[t].begin(), in.triangles[t].end());
  for (const Index e : in.required_edges) fixed.insert(in.edges[e].begin(), in.edges[e].end());
  std::set<Index> hit;
  for (Index p = 0; p < in.points.size(); ++p) {
    const Index q = result.new_of_old[p];
    if (fixed.contains(p)) {
      ASSERT_NE(q, AdaptResult::gone) << "point " << p << " had to stay";
      EXPECT_EQ(out.points[q], in.points[p]) << "point " << p << " had to stay";
    }
    if (q == AdaptResult::gone) continue;
    ASSERT_LT(q, out.points.size());
    EXPECT_TRUE(hit.insert(q).second) << "two points became one";
    EXPECT_EQ(ref_of(out.point_refs, q), ref_of(in.point_refs, p));
  }
}

inline void expect_report_consistent(const AdaptResult& result) {
  const Report& report = result.report;
  EXPECT_EQ(report.quality.vertices, result.mesh.points.size());
  EXPECT_EQ(report.quality.tetrahedra, result.mesh.tetrahedra.size());
  EXPECT_EQ(report.quality.triangles, result.mesh.triangles.size());
  std::vector<std::string> passes, phases;
  for (const PassReport& pass : report.passes) passes.push_back(pass.name);
  for (const auto& [phase, seconds] : report.seconds) phases.push_back(phase);
  EXPECT_EQ(passes, (std::vector<std::string>{"insert", "collapse", "swap", "relocate", "repair"}));
  EXPECT_EQ(phases, (std::vector<std::string>{"build", "geometry", "metric", "cut", "order", "result"}));
  for (const PassReport& pass : report.passes) {
    std::size_t outcomes = pass.accepted;
    for (const auto& [reason, count] : pass.refused) outcomes += count;
    EXPECT_EQ(pass.tried, outcomes) << pass.name;
    EXPECT_GE(pass.seconds, 0);
  }
}

/// What holds whatever the shape of the surface. The input must be positively oriented.
inline void expect_valid(const AdaptResult& result, const Mesh& in) {
  const Mesh& out = result.mesh;
  EXPECT_EQ(defects(out), std::vector<std::string>{});
  for (const auto& t : out.tetrahedra)
    ASSERT_GT(exact_orientation(out.points[t[0]], out.points[t[1]], out.points[t[2]], out.points[t[3]]), 0);
  for (const auto& t : out.triangles) EXPECT_GT(norm(area_normal(out, t)), 0);
  expect_marks_kept(out, in);
  expect_map_right(result, in);
  expect_report_consistent(result);
  EXPECT_EQ(result.metric.size(), out.points.size());
}

/// Of a domain whose patches are planar or kept. The input must be positively oriented.
inline void expect_faithful(const AdaptResult& result, const Mesh& in) {
  expect_valid(result, in);
  EXPECT_NEAR(volume_of(result.mesh), volume_of(in), 1e-12 * volume_of(in));
  expect_same_sums(volumes(result.mesh), volumes(in), "region");
  if (!in.triangles.empty()) expect_same_sums(areas(result.mesh), areas(in), "patch");
}

inline Tensors sampled(const Mesh& mesh, const MetricFunction& field) {
  Tensors tensors;
  for (const Point& p : mesh.points) tensors.push_back(field(p));
  return tensors;
}

}  // namespace taut::test
