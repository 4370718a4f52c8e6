#include "partition/blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "mesh/canonical.hpp"
#include "mesh/invariants.hpp"
#include "mesh/metric_grid.hpp"
#include "taut/threads.hpp"

namespace taut {
namespace {

constexpr std::size_t block_size = 60;

// With dead entities, as blocks leave them behind.
TetMesh worn_grid(Index n) {
  TetMesh mesh = test::metric_grid(n);
  Block block;
  block.borrow(mesh, {.vertices = 10, .tets = 20, .triangles = 30});
  block.give_back(mesh);
  return mesh;
}

template <class Id>
std::vector<Id> used(const IdPool<Id>& ids) {
  std::vector<Id> list;
  for (std::size_t i = 0; i < ids.size(); ++i) list.push_back(ids[i]);
  return list;
}

bool owns(const Block& block, const Tet& tet) {
  return std::ranges::all_of(tet.v, [&](VertexId v) { return block.owns(v); });
}

TEST(Blocks, PartTheLivingVertices) {
  TetMesh mesh = worn_grid(6);
  Blocks blocks(mesh);
  for (unsigned round = 0; round < 4; ++round) {
    blocks.cut(block_size, round);
    EXPECT_EQ(blocks.size(), 6) << "of 343 vertices";
    std::vector<int> listed(mesh.vertices.size(), 0), owners(mesh.vertices.size(), 0);
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      EXPECT_TRUE(std::ranges::is_sorted(used(blocks[b].vertices)));
      for (VertexId v : used(blocks[b].vertices)) {
        ++listed[v];
        EXPECT_TRUE(blocks[b].owns(v));
      }
      for (const VertexId v : ids<VertexId>(mesh.vertices.size())) owners[v] += blocks[b].owns(v) ? 1 : 0;
    }
    for (const VertexId v : ids<VertexId>(mesh.vertices.size())) {
      EXPECT_EQ(listed[v], mesh.is_vertex_alive(v) ? 1 : 0);
      EXPECT_EQ(owners[v], listed[v]);
    }
    blocks.close();
    EXPECT_EQ(blocks.size(), 0);
  }
}

TEST(Blocks, OwnTheTetrahedraOfTheirVerticesAndShareTheOthers) {
  TetMesh mesh = worn_grid(6);
  Blocks blocks(mesh);
  for (unsigned round = 0; round < 4; ++round) {
    blocks.cut(block_size, round);
    std::vector<int> owned(mesh.tets.size(), 0), shared(mesh.tets.size(), 0);
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      EXPECT_GT(blocks[b].tets.size(), 0);
      EXPECT_TRUE(std::ranges::is_sorted(used(blocks[b].tets)));
      EXPECT_TRUE(std::ranges::is_sorted(blocks[b].shared_tets));
      for (TetId t : used(blocks[b].tets)) {
        ++owned[t];
        EXPECT_TRUE(mesh.tets[t].alive() && owns(blocks[b], mesh.tets[t]));
      }
      for (TetId t : blocks[b].shared_tets) {
        ++shared[t];
        EXPECT_TRUE(mesh.tets[t].alive() && !owns(blocks[b], mesh.tets[t]));
        EXPECT_TRUE(std::ranges::any_of(mesh.tets[t].v, [&](VertexId v) { return blocks[b].owns(v); }));
      }
    }
    for (const TetId t : ids<TetId>(mesh.tets.size()))
      EXPECT_EQ(owned[t] + shared[t], mesh.tets[t].alive() ? 1 : 0) << "tetrahedron " << t;
    blocks.close();
  }
}

TEST(Blocks, KnowWhoseBallsTheyOwn) {
  TetMesh mesh = worn_grid(6);
  Blocks blocks(mesh);
  for (unsigned round = 0; round < 4; ++round) {
    blocks.cut(block_size, round);
    std::size_t whole = 0;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      std::vector<bool> inside(mesh.vertices.size(), true);
      for (const Tet& tet : mesh.tets)
        for (VertexId v : tet.v)
          if (tet.alive() && !owns(blocks[b], tet)) inside[v] = false;
      for (VertexId v : used(blocks[b].vertices)) {
        EXPECT_EQ(blocks[b].owns_ball(v), inside[v]) << "vertex " << v;
        whole += inside[v] ? 1 : 0;
      }
    }
    EXPECT_GT(whole, 20);
    EXPECT_LT(whole, mesh.vertex_count());
    blocks.close();
  }
}

TEST(Blocks, OfSizeZeroAreTheWholeMesh) {
  TetMesh mesh = worn_grid(3);
  for (const std::size_t size : {std::size_t{0}, std::size_t{1'000'000}}) {
    Blocks blocks(mesh);
    blocks.cut(size, 0);
    ASSERT_EQ(blocks.size(), 1);
    EXPECT_EQ(blocks[0].vertices.size(), mesh.vertex_count());
    EXPECT_EQ(blocks[0].tets.size(), mesh.tet_count());
    EXPECT_TRUE(blocks[0].shared_tets.empty());
    for (VertexId v : used(blocks[0].vertices)) EXPECT_TRUE(blocks[0].owns(v) && blocks[0].owns_ball(v));
    blocks.close();
  }
}

std::vector<IdNeed> some_needs(std::size_t blocks) {
  std::vector<IdNeed> needs(blocks);
  for (std::size_t b = 0; b < blocks; ++b) needs[b] = {.vertices = 3 * b, .tets = 7 + b, .triangles = 5 * (b % 2)};
  return needs;
}

TEST(Blocks, BorrowIdsThatNobodyElseHas) {
  TetMesh mesh = worn_grid(6);
  const std::size_t vertices = mesh.vertex_count(), tets = mesh.tet_count();
  Blocks blocks(mesh);
  blocks.cut(block_size, 0);
  const auto needs = some_needs(blocks.size());
  blocks.lend(needs);
  EXPECT_EQ(blocks.vertex_count(), vertices);
  EXPECT_EQ(blocks.tet_count(), tets);
  std::array<std::set<std::uint32_t>, 3> lent;
  std::array<std::size_t, 3> count{};
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Block& block = blocks[b];
    EXPECT_EQ(block.vertices.available(), needs[b].vertices);
    EXPECT_EQ(block.tets.available(), needs[b].tets);
    EXPECT_EQ(block.triangles.available(), needs[b].triangles);
    for (VertexId v : block.vertices.unused()) {
      EXPECT_TRUE(!mesh.is_vertex_alive(v) && block.owns_ball(v));
      for (std::size_t other = 0; other < blocks.size(); ++other) EXPECT_EQ(blocks[other].owns(v), other == b);
    }
    for (TetId t : block.tets.unused()) EXPECT_FALSE(mesh.tets.at(t).alive());
    for (TriangleId t : block.triangles.unused()) EXPECT_FALSE(mesh.triangles.at(t).alive());
    int kind = 0;
    const auto note = [&](const auto& ids) {
      lent[kind].insert(ids.unused().begin(), ids.unused().end());
      count[kind++] += ids.available();
    };
    note(block.vertices);
    note(block.tets);
    note(block.triangles);
  }
  for (int kind = 0; kind < 3; ++kind) EXPECT_EQ(lent[kind].size(), count[kind]) << "an id is in two pools";
  blocks.close();
}

TEST(Blocks, CountWhatTheyMakeAndRemove) {
  TetMesh mesh = worn_grid(4);
  const std::size_t vertices = mesh.vertex_count(), tets = mesh.tet_count();
  Blocks blocks(mesh);
  blocks.cut(30, 0);
  ASSERT_GT(blocks.size(), 1);
  blocks.lend(std::vector<IdNeed>(blocks.size(), {.vertices = 4, .tets = 9, .triangles = 1}));
  for (int i = 0; i < 3; ++i) (void)blocks[0].vertices.take();
  for (int i = 0; i < 5; ++i) (void)blocks[1].tets.take();
  EXPECT_EQ(blocks.vertex_count(), vertices + 3);
  EXPECT_EQ(blocks.tet_count(), tets + 5);
  blocks[1].remove_vertex(mesh, blocks[1].vertices[0]);
  blocks[0].remove_tet(mesh, blocks[0].tets[0]);
  EXPECT_EQ(blocks.vertex_count(), vertices + 2);
  EXPECT_EQ(blocks.tet_count(), tets + 4);
  blocks.close();
  EXPECT_EQ(mesh.vertex_count(), vertices + 2);
  EXPECT_EQ(mesh.tet_count(), tets + 4);
}

TEST(Blocks, LeaveTheMeshAsItWas) {
  TetMesh mesh = worn_grid(6);
  const test::Canonical before = test::canonical(mesh);
  const std::size_t vertices = mesh.vertex_count(), tets = mesh.tet_count(), triangles = mesh.triangle_count();
  Blocks blocks(mesh);
  std::array<std::size_t, 3> size{};
  for (unsigned round = 0; round < 3; ++round) {
    blocks.cut(block_size, 5);
    blocks.lend(some_needs(blocks.size()));
    blocks.close();
    EXPECT_EQ(first_broken_invariant(mesh), "");
    EXPECT_TRUE(test::canonical(mesh) == before);
    EXPECT_EQ(std::tuple(mesh.vertex_count(), mesh.tet_count(), mesh.triangle_count()),
              std::tuple(vertices, tets, triangles));
    const std::array<std::size_t, 3> now = {mesh.vertices.size(), mesh.tets.size(), mesh.triangles.size()};
    EXPECT_TRUE(round == 0 || now == size) << "ids that came back are used first";
    size = now;
  }
}

// What each block has, as lists.
using Lists = std::vector<std::array<std::vector<std::uint32_t>, 5>>;

Lists cut_on(int threads, TetMesh mesh) {
  Lists lists;
  on_threads(threads, [&] {
    Blocks blocks(mesh);
    blocks.cut(1500, 3);
    blocks.lend(some_needs(blocks.size()));
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      const auto list = [](const auto& ids) { return std::vector<std::uint32_t>(ids.begin(), ids.end()); };
      lists.push_back({list(used(blocks[b].vertices)), list(used(blocks[b].tets)), list(blocks[b].shared_tets),
                       list(blocks[b].vertices.unused()), list(blocks[b].tets.unused())});
    }
    blocks.close();
  });
  return lists;
}

TEST(Blocks, AreTheSameOnAnyNumberOfThreads) {
  const TetMesh mesh = worn_grid(26);  // large enough that several threads take part in it
  const Lists expected = cut_on(1, mesh);
  EXPECT_EQ(expected.size(), 13) << "of 19683 vertices";
  for (const int threads : {2, 3, 8}) EXPECT_TRUE(cut_on(threads, mesh) == expected) << threads << " threads";
}

}  // namespace
}  // namespace taut
