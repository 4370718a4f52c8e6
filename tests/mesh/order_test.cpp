#include "mesh/order.hpp"

#include <gtest/gtest.h>

#include <random>

#include "mesh/build.hpp"
#include "mesh/canonical.hpp"
#include "mesh/hilbert.hpp"
#include "mesh/invariants.hpp"
#include "mesh/shapes.hpp"
#include "partition/whole_block.hpp"
#include "taut/threads.hpp"

namespace taut {
namespace {

std::vector<std::uint32_t> identity(std::size_t n) {
  std::vector<std::uint32_t> order(n);
  for (std::uint32_t i = 0; i < n; ++i) order[i] = i;
  return order;
}

TEST(HilbertOrder, IsAPermutation) {
  std::mt19937_64 generator(1);
  std::normal_distribution<double> normal(3, 100);
  for (const std::size_t n : {0, 1, 2, 1000}) {
    std::vector<Vec3> points(n);
    for (Vec3& p : points) p = {normal(generator), 1e-9 * normal(generator), 1e9 * normal(generator)};
    auto order = hilbert_order(points);
    std::sort(order.begin(), order.end());
    EXPECT_EQ(order, identity(n));
  }
}

TEST(HilbertOrder, WalksAGridStepByStep) {
  std::vector<Vec3> points;
  for (int i = 0; i < 512; ++i)
    points.push_back({static_cast<double>(i * 5 % 8), static_cast<double>(i / 8 % 8), static_cast<double>(i / 64)});
  const auto order = hilbert_order(points);
  for (std::size_t i = 1; i < order.size(); ++i)
    EXPECT_EQ(norm(points[order[i]] - points[order[i - 1]]), 1) << "step " << i;
}

TEST(HilbertOrder, TiesKeepTheirOrder) {
  EXPECT_EQ(hilbert_order(std::vector<Vec3>(20, {1, 2, 3})), identity(20));
  const auto flat = hilbert_order(std::vector<Vec3>{{0, 5, 1}, {1, 5, 1}, {0, 5, 1}, {1, 5, 1}});
  EXPECT_EQ(flat, (std::vector<std::uint32_t>{0, 2, 1, 3}));
}

// Dead entities, some of them between living ones.
void wear(TetMesh& mesh) {
  VertexId a = none, b = none;
  test::change_whole(mesh, [&](Block& block) {
    block.remove_tet(mesh, block.tets.take());
    a = block.add_vertex(mesh, {}, {}, CellId{0});
    b = block.add_vertex(mesh, {}, {}, CellId{0});
    block.remove_vertex(mesh, a);
    block.remove_vertex(mesh, b);
    block.remove_triangle(mesh, block.triangles.take());
  });
  const auto last = static_cast<TetId>(mesh.tets.size() - 2), behind = static_cast<TetId>(last + 1);
  // Exchanges the last living tetrahedron and the dead one behind it.
  std::swap(mesh.tets[last], mesh.tets[behind]);
  std::swap(mesh.region_of_tet[last], mesh.region_of_tet[behind]);
  for (TetId& t : mesh.tet_of_vertex) t = t == last ? behind : t;
  for (int f = 0; f < 4; ++f) {
    const FaceLink link = mesh.tets[behind].n[f], here = FaceLink::to_face(behind, f);
    if (link.is_triangle())
      for (FaceLink& side : mesh.triangles[link.triangle()].side)
        side = side == FaceLink::to_face(last, f) ? here : side;
    else
      mesh.tets[link.tet()].n[link.face()] = here;
  }
}

TEST(Reorder, KeepsTheMeshAndDropsTheDead) {
  Mesh input = test::two_regions(4);
  test::jitter(input, 0.05, 3);
  TetMesh mesh = build(input).mesh;
  const auto before = test::canonical(mesh);
  for (const VertexId v : ids<VertexId>(mesh.vertices.size())) {  // to be recognised
    mesh.host_of_vertex[v] = static_cast<CellId>(v);
    mesh.tag_of_vertex[v] = Tag::on_patch(static_cast<PatchId>(v));
    mesh.vertices[v].m = {mesh.x(v)[0], mesh.x(v)[1], mesh.x(v)[2], 0, 0, 0};
    mesh.state_of_vertex[v].drift = static_cast<float>(mesh.x(v)[1]);
    mesh.state_of_vertex[v].restless = mesh.x(v)[0] > 0.5;
  }
  const auto origin = mesh.origin_of_vertex;
  wear(mesh);
  ASSERT_EQ(test::canonical(mesh), before);
  ASSERT_LT(mesh.tet_count(), mesh.tets.size());
  reorder(mesh);
  EXPECT_EQ(first_broken_invariant(mesh), "");
  EXPECT_EQ(test::canonical(mesh), before);
  EXPECT_EQ(mesh.tets.size(), input.tetrahedra.size());
  EXPECT_EQ(mesh.vertices.size(), input.points.size());
  EXPECT_EQ(mesh.triangles.size(), input.triangles.size());
  for (const VertexId v : ids<VertexId>(mesh.vertices.size())) {
    EXPECT_EQ(mesh.x(v), input.points[mesh.origin_of_vertex[v]]);
    EXPECT_EQ(mesh.origin_of_vertex[v], origin[mesh.host_of_vertex[v]]);
    EXPECT_EQ(mesh.tag_of_vertex[v], Tag::on_patch(static_cast<PatchId>(mesh.host_of_vertex[v])));
    EXPECT_EQ(mesh.vertices[v].m[2], mesh.x(v)[2]);
    EXPECT_EQ(mesh.state_of_vertex[v].drift, static_cast<float>(mesh.x(v)[1]));
    EXPECT_EQ(mesh.state_of_vertex[v].restless, mesh.x(v)[0] > 0.5);
  }
}

// Every second tetrahedron is dead, as far as reorder() is concerned.
TetMesh with_gaps() {
  TetMesh mesh = build(test::grid(28)).mesh;
  for (std::size_t t = 0; t < mesh.tets.size(); t += 2) mesh.tets[t].v[0] = none;
  for (TetId& t : mesh.tet_of_vertex) t = TetId{t | 1U};
  for (std::size_t v = 0; v < mesh.vertices.size(); v += 5) mesh.host_of_vertex[v] = static_cast<CellId>(v);
  return mesh;
}

TEST(Reorder, IsTheSameOnAnyNumberOfThreads) {
  TetMesh one = with_gaps(), three = one;
  on_threads(1, [&] { reorder(one); });
  on_threads(3, [&] { reorder(three); });
  EXPECT_EQ(one.tets.size(), 28 * 28 * 28 * 3);
  EXPECT_EQ(one.tet_of_vertex, three.tet_of_vertex);
  EXPECT_EQ(one.host_of_vertex, three.host_of_vertex);
  EXPECT_EQ(one.origin_of_vertex, three.origin_of_vertex);
  EXPECT_TRUE(
      std::ranges::equal(one.tets, three.tets, [](const Tet& a, const Tet& b) { return a.v == b.v && a.n == b.n; }));
}

TEST(Reorder, BringsNeighboursTogether) {
  const TetMesh mesh = build(test::cube(8)).mesh;
  std::uint32_t widest = 0;
  for (std::size_t t = 0; t + 1 < mesh.tets.size(); ++t) {
    const auto smallest = [&](std::size_t i) { return *std::ranges::min_element(mesh.tets[i].v); };
    EXPECT_LE(smallest(t), smallest(t + 1));
    widest = std::max(widest, smallest(t + 1) - smallest(t));
  }
  EXPECT_LT(widest, mesh.vertices.size() / 8);
}

TEST(Reorder, IsDoneAfterOnce) {
  TetMesh mesh = build(test::cube(3)).mesh, again = mesh;
  reorder(again);
  for (const TetId t : ids<TetId>(mesh.tets.size())) EXPECT_EQ(mesh.tets[t].v, again.tets[t].v);
}

}  // namespace
}  // namespace taut
