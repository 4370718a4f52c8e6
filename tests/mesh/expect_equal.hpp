// Comparison of whole meshes.
#pragma once

#include <gtest/gtest.h>

#include "taut/mesh.hpp"

namespace taut::test {

inline void expect_equal(const Mesh& a, const Mesh& b) {
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.point_refs, b.point_refs);
  EXPECT_EQ(a.tetrahedra, b.tetrahedra);
  EXPECT_EQ(a.tetrahedron_refs, b.tetrahedron_refs);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.triangle_refs, b.triangle_refs);
  EXPECT_EQ(a.edges, b.edges);
  EXPECT_EQ(a.edge_refs, b.edge_refs);
  EXPECT_EQ(a.corners, b.corners);
  EXPECT_EQ(a.required_points, b.required_points);
  EXPECT_EQ(a.ridges, b.ridges);
  EXPECT_EQ(a.required_edges, b.required_edges);
  EXPECT_EQ(a.required_triangles, b.required_triangles);
  EXPECT_EQ(a.required_tetrahedra, b.required_tetrahedra);
}

}  // namespace taut::test
