#include "mesh/invariants.hpp"

#include <gtest/gtest.h>

#include "mesh/build.hpp"
#include "mesh/shapes.hpp"
#include "partition/whole_block.hpp"

namespace taut {
namespace {

TetMesh sound() {
  return build(test::two_regions(2)).mesh;
}

std::vector<TetId> all_tets(const TetMesh& mesh) {
  std::vector<TetId> tets;
  for (const TetId t : ids<TetId>(mesh.tets.size())) tets.push_back(t);
  return tets;
}

// Breaks a valid mesh and looks for the words in the message. The local check must also find the fault, unless it
// concerns dead entities.
template <class Break>
void expect_found(Break damage, const std::string& words, bool locally = true) {
  TetMesh mesh = sound();
  damage(mesh);
  const std::string whole = first_broken_invariant(mesh);
  EXPECT_NE(whole.find(words), std::string::npos) << "expected: " << words << "\nfound: " << whole;
  EXPECT_EQ(first_broken_invariant(mesh, all_tets(mesh)).empty(), !locally) << words;
}

// A face between two tetrahedra, and one at a triangle between two.
FaceLink inner_face(const TetMesh& mesh) {
  for (const TetId t : ids<TetId>(mesh.tets.size()))
    for (int f = 0; f < 4; ++f)
      if (!mesh.tets[t].n[f].is_triangle()) return FaceLink::to_face(t, f);
  return outside;
}

TriangleId interface_triangle(const TetMesh& mesh) {
  for (const TriangleId t : mesh.triangle_ids())
    if (mesh.triangles[t].side[1] != outside) return t;
  return none;
}

TEST(Invariants, HoldInABuiltMesh) {
  const TetMesh mesh = sound();
  EXPECT_EQ(first_broken_invariant(mesh), "");
  EXPECT_EQ(first_broken_invariant(mesh, all_tets(mesh)), "");
}

TEST(Invariants, OfOrientation) {
  expect_found([](TetMesh& m) { m.vertices[m.tets[5].v[0]].x = {9, 9, 9}; }, "is not positive");
  expect_found([](TetMesh& m) { m.vertices[m.tets[5].v[0]].x = m.x(m.tets[5].v[1]); }, "is not positive");
}

TEST(Invariants, OfLinks) {
  expect_found([](TetMesh& m) { m.tets[3].n[1] = outside; }, "");
  expect_found(
      [](TetMesh& m) {
        const FaceLink face = inner_face(m), other = m.tets[face.tet()].n[face.face()];
        m.tets[face.tet()].n[face.face()] = FaceLink::to_face(other.tet(), (other.face() + 1) % 4);
      },
      "links to");
  // Exchanges two vertices of a tetrahedron and their opposite faces: the links hold, but the orientation does not.
  expect_found(
      [](TetMesh& m) {
        std::swap(m.tets[3].v[0], m.tets[3].v[1]);
        std::swap(m.tets[3].n[0], m.tets[3].n[1]);
      },
      "");
  expect_found(
      [](TetMesh& m) {  // permuted evenly, without its links
        auto& v = m.tets[inner_face(m).tet()].v;
        v = {v[1], v[2], v[0], v[3]};
      },
      "");
}

TEST(Invariants, OfTriangles) {
  expect_found([](TetMesh& m) { std::swap(m.triangles[2].v[0], m.triangles[2].v[1]); }, "of the triangle");
  expect_found([](TetMesh& m) { std::swap(m.triangles[2].side[0], m.triangles[2].side[1]); }, "side 0");
  expect_found(
      [](TetMesh& m) {
        auto& side = m.triangles[interface_triangle(m)].side;
        std::swap(side[0], side[1]);
      },
      "of the triangle");
  expect_found([](TetMesh& m) { m.triangles[interface_triangle(m)].side[1] = outside; }, "");
  expect_found([](TetMesh& m) { m.triangles[1].side[0] = m.triangles[2].side[0]; }, "");
  expect_found([](TetMesh& m) { test::change_whole(m, [&](Block& b) { b.remove_triangle(m, TriangleId{4}); }); },
               "dead");
}

TEST(Invariants, OfRegions) {
  expect_found([](TetMesh& m) { m.region_of_tet[7] = RegionId{2}; }, "parts two regions");
  TetMesh mesh = sound();
  const RegionId region = mesh.region_of_tet[7];
  mesh.region_of_tet[7] = RegionId{2};
  EXPECT_EQ(first_broken_invariant(mesh, std::vector<int>{1, 2, region + 1}), "");
  EXPECT_NE(first_broken_invariant(mesh, std::vector<int>{1, 2, 2 - region}), "");
  EXPECT_EQ(first_broken_invariant(mesh, std::vector<TetId>{TetId{7}}), "") << "only those given are compared";
}

TEST(Invariants, OfVertices) {
  expect_found([](TetMesh& m) { m.tet_of_vertex[4] = none; }, "");
  expect_found(
      [](TetMesh& m) {
        for (const TetId t : m.tet_ids())
          if (!m.tets[t].has(VertexId{4})) m.tet_of_vertex[4] = t;
      },
      "which lacks it");
  expect_found([](TetMesh& m) { test::change_whole(m, [&](Block& b) { b.remove_vertex(m, VertexId{4}); }); }, "dead");
  expect_found([](TetMesh& m) { m.tets[3].v[2] = VertexId{1000}; }, "");
}

TEST(Invariants, OfTheDead) {
  const auto give_dead_tet = [](TetMesh& m) {
    test::change_whole(m, [&](Block& b) { m.tet_of_vertex[b.add_vertex(m, {}, {}, CellId{0})] = b.tets.take(); });
  };
  expect_found(give_dead_tet, "", true);
  const auto add_free = [](TetMesh& m, const IdNeed& ids) {
    Block whole;
    whole.borrow(m, ids);
    whole.give_back(m);
  };
  expect_found([&](TetMesh& m) { add_free(m, {.tets = 1}), m.tets.back().v = m.tets[0].v; }, "tetrahedra", true);
  expect_found([&](TetMesh& m) { add_free(m, {.triangles = 1}), m.triangles.pop_back(); }, "triangles", false);
  expect_found([](TetMesh& m) { m.state_of_vertex.pop_back(); }, "arrays of one entity", false);
  expect_found([](TetMesh& m) { m.region_of_tet.push_back(RegionId{0}); }, "arrays of one entity", false);
}

TEST(Invariants, AllowTheDead) {
  TetMesh mesh = sound();
  test::change_whole(mesh, [&](Block& block) {
    block.remove_vertex(mesh, block.add_vertex(mesh, {}, {}, CellId{0}));
    block.remove_tet(mesh, block.tets.take());
    block.remove_triangle(mesh, block.triangles.take());
  });
  EXPECT_EQ(first_broken_invariant(mesh), "");
}

}  // namespace
}  // namespace taut
