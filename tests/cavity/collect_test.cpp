#include "cavity/collect.hpp"

#include <gtest/gtest.h>

#include <set>

#include "mesh/build.hpp"
#include "mesh/orientation.hpp"
#include "mesh/shapes.hpp"

namespace taut {
namespace {

std::vector<Mesh> domains() {
  std::vector<Mesh> meshes = {test::cube(3), test::two_regions(4), test::l_shape(4), test::ball(test::cube(4))};
  for (unsigned i = 0; i < 3; ++i) test::jitter(meshes[i], 0.05, i);
  return meshes;
}

std::set<TetId> tets_with(const TetMesh& mesh, const std::vector<VertexId>& v) {
  std::set<TetId> tets;
  for (const TetId t : ids<TetId>(mesh.tets.size()))
    if (std::ranges::all_of(v, [&](VertexId i) { return mesh.tets[t].has(i); })) tets.insert(t);
  return tets;
}

std::set<TriangleId> triangles_with(const TetMesh& mesh, VertexId a, VertexId b) {
  std::set<TriangleId> triangles;
  for (const TriangleId t : ids<TriangleId>(mesh.triangles.size())) {
    const auto& v = mesh.triangles[t].v;
    if (std::ranges::find(v, a) != v.end() && std::ranges::find(v, b) != v.end()) triangles.insert(t);
  }
  return triangles;
}

TEST(CollectBall, FindsAllAtAVertexAcrossInterfacesToo) {
  for (const Mesh& input : domains()) {
    const TetMesh mesh = build(input).mesh;
    TetSet ball;
    for (const VertexId v : ids<VertexId>(mesh.vertices.size())) {
      ASSERT_TRUE(collect_ball(mesh, v, ball));
      const std::set<TetId> found(ball.span().begin(), ball.span().end());
      EXPECT_EQ(found, tets_with(mesh, {v}));
      EXPECT_EQ(found.size(), static_cast<std::size_t>(ball.size())) << "one is there twice";
    }
  }
}

void expect_oriented(const TetMesh& mesh, const Shell& shell) {
  for (int i = 0; i < shell.size; ++i) {
    const VertexId from = shell.ring[i], to = shell.next(i);
    EXPECT_EQ(tets_with(mesh, {shell.a, shell.b, from, to}), std::set<TetId>{shell.tets[i]});
    EXPECT_EQ(orientation(mesh.x(shell.a), mesh.x(shell.b), mesh.x(from), mesh.x(to)), 1);
    const auto& [j, k] = edge_vertices[shell.edges[i]];
    const auto& v = mesh.tets[shell.tets[i]].v;
    EXPECT_EQ(std::minmax(v[j], v[k]), std::minmax(shell.a, shell.b));
  }
}

TEST(CollectShell, FindsAllRoundAnEdgeInOrder) {
  for (const Mesh& input : domains()) {
    const TetMesh mesh = build(input).mesh;
    int closed = 0, open = 0;
    Shell shell;
    for (const TetId t : ids<TetId>(mesh.tets.size())) {
      for (int e = 0; e < 6; ++e) {
        ASSERT_EQ(collect_shell(mesh, Block(), t, e, shell), Outcome::accepted);
        const VertexId a = mesh.tets[t].v[edge_vertices[e][0]], b = mesh.tets[t].v[edge_vertices[e][1]];
        ASSERT_EQ((std::pair{shell.a, shell.b}), (std::pair{a, b}));
        const std::set<TetId> found(shell.tets.begin(), shell.tets.begin() + shell.size);
        EXPECT_EQ(found, tets_with(mesh, {a, b}));
        EXPECT_EQ(found.size(), static_cast<std::size_t>(shell.size));
        const std::set<TriangleId> triangles(shell.triangles.begin(), shell.triangles.begin() + shell.triangle_count);
        EXPECT_EQ(triangles, triangles_with(mesh, a, b));
        EXPECT_EQ(triangles.size(), static_cast<std::size_t>(shell.triangle_count));
        const bool at_boundary =
            std::ranges::any_of(triangles, [&](TriangleId i) { return mesh.triangles[i].side[1] == outside; });
        EXPECT_EQ(shell.closed, !at_boundary);
        EXPECT_EQ(shell.ring_size, shell.size + (shell.closed ? 0 : 1));
        expect_oriented(mesh, shell);
        ++(shell.closed ? closed : open);
      }
    }
    EXPECT_GT(closed, 0);
    EXPECT_GT(open, 0);
  }
}

TEST(CollectShell, RefusesWhatHasNoRoom) {
  for (const bool closed : {true, false}) {
    const int extra = closed ? 0 : 1;
    for (const int n : {Shell::capacity, Shell::capacity + 1, TetSet::capacity, TetSet::capacity + 1}) {
      const std::vector<double> radius(n + extra, 1.0), elevation(n + extra, 0.0);
      const Built built = build(test::ring(radius, elevation, 1, closed));
      const VertexId a = built.vertex_of_point[0], b = built.vertex_of_point[1];
      const Tet& tet = built.mesh.tets[0];
      Shell shell;
      EXPECT_EQ(collect_shell(built.mesh, Block(), TetId{0}, edge_between[tet.index_of(a)][tet.index_of(b)], shell),
                n <= Shell::capacity ? Outcome::accepted : Outcome::too_large);
      TetSet ball;
      EXPECT_EQ(collect_ball(built.mesh, a, ball), n <= TetSet::capacity);
    }
  }
}

TEST(CollectShell, RefusesMoreTrianglesThanASoundGeometryHas) {
  Mesh mesh = test::ring(std::vector<double>(9, 1.0), std::vector<double>(9, 0.0), 1, true);
  for (int i = 0; i < 9; ++i) mesh.tetrahedron_refs.push_back(i);
  mesh.triangles.clear();
  mesh.triangle_refs.clear();
  const Built built = build(mesh);
  const Tet& tet = built.mesh.tets[0];
  const int edge = edge_between[tet.index_of(built.vertex_of_point[0])][tet.index_of(built.vertex_of_point[1])];
  Shell shell;
  EXPECT_EQ(collect_shell(built.mesh, Block(), TetId{0}, edge, shell), Outcome::too_large);
}

}  // namespace
}  // namespace taut
