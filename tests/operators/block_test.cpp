// Operations in a part of a mesh: what they do not change.
#include "partition/block.hpp"

#include <gtest/gtest.h>

#include "operators/cut_bench.hpp"

namespace taut {
namespace {

using test::bits_of;
using test::CutBench;
using test::for_each_attempt;
using test::Kind;
using test::kinds;
using test::owns;
using test::plenty;
using test::run_all;
using test::Workbench;

TEST(CollectShell, IsPutOffIfATetrahedronIsNotOwned) {
  for (unsigned round = 0; round < 3; ++round) {
    CutBench cut(round);
    const TetMesh& mesh = cut.mesh;
    std::map<Outcome, int> count;
    Shell shell;
    for (std::size_t b = 0; b < cut.blocks.size(); ++b) {
      const Block& block = cut.blocks[b];
      for_each_attempt(kinds[0], mesh, block, [&](std::uint32_t id, int e) {
        const TetId t{id};
        const VertexId p = mesh.tets[t].v[edge_vertices[e][0]], q = mesh.tets[t].v[edge_vertices[e][1]];
        const bool whole = std::ranges::all_of(
            mesh.tets, [&](const Tet& tet) { return !tet.alive() || !tet.has(p) || !tet.has(q) || owns(block, tet); });
        const Outcome outcome = collect_shell(mesh, block, t, e, shell);
        ++count[outcome];
        EXPECT_EQ(outcome, whole ? Outcome::accepted : Outcome::put_off);
      });
    }
    EXPECT_GT(count[Outcome::accepted], 500);
    EXPECT_GT(count[Outcome::put_off], 100);
  }
}

class InABlock : public testing::TestWithParam<Kind> {};

INSTANTIATE_TEST_SUITE_P(Operations, InABlock, testing::ValuesIn(kinds),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST_P(InABlock, ChangesNothingWhenRefusedAndMarksNothingWhenPutOff) {
  const Kind& kind = GetParam();
  CutBench cut(0);
  std::map<Outcome, int> count;
  for (std::size_t b = 0; b < cut.blocks.size(); ++b) {
    Kernel kernel = cut.kernel(b);
    for_each_attempt(kind, cut.mesh, cut.blocks[b], [&](std::uint32_t id, int part) {
      const test::Snapshot before(cut.mesh);
      const test::Bits bits = bits_of(cut.mesh);
      const std::size_t tets = cut.blocks.tet_count(), vertices = cut.blocks.vertex_count();
      const Outcome outcome = kind.run(kernel, id, part);
      ++count[outcome];
      if (outcome == Outcome::accepted) return;
      EXPECT_TRUE(test::Snapshot(cut.mesh) == before) << test::Attempts::name(outcome);
      EXPECT_TRUE(cut.blocks.tet_count() == tets && cut.blocks.vertex_count() == vertices) << "ids were taken";
      // Repair records which of the edges that it tries were refused for good.
      const bool is_silent = outcome == Outcome::put_off && kind.run != kinds[4].run;
      EXPECT_TRUE(!is_silent || bits_of(cut.mesh) == bits) << "marked, although put off";
    });
  }
  EXPECT_GT(count[Outcome::accepted], 3);
  EXPECT_GT(count[Outcome::put_off], 20);
}

TEST_P(InABlock, IsRefusedForGoodOnlyIfTheWholeMeshRefusesIt) {
  const Kind& kind = GetParam();
  const Mesh input = test::domain();
  Workbench bench(input, test::random_field(input, 0.3, 1));
  Kernel& whole = bench.kernel;
  Blocks blocks(bench.mesh);
  blocks.cut(test::block_size, 0);
  blocks.lend(std::vector<IdNeed>(blocks.size(), plenty));
  int refused = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    Kernel kernel{bench.mesh, bench.model, bench.target, &blocks[b]};
    for_each_attempt(kind, bench.mesh, blocks[b], [&](std::uint32_t id, int part) {
      const Outcome outcome = kind.run(kernel, id, part);
      if (outcome == Outcome::accepted || outcome == Outcome::put_off || testing::Test::HasFailure()) return;
      EXPECT_EQ(kind.run(whole, id, part), outcome) << test::Attempts::name(outcome);
      ++refused;
    });
  }
  EXPECT_GT(refused, 5);
}

// What blocks share and must not change: tetrahedra, except the links of their faces, and their vertices.
struct Seams {
  explicit Seams(CutBench& cut) {
    for (std::size_t b = 0; b < cut.blocks.size(); ++b)
      tets.insert(tets.end(), cut.blocks[b].shared_tets.begin(), cut.blocks[b].shared_tets.end());
    for (TetId t : tets) vertices.insert(cut.mesh.tets[t].v.begin(), cut.mesh.tets[t].v.end());
  }

  [[nodiscard]] std::string values(const TetMesh& mesh) const {
    std::string bytes;
    const auto add = [&](const auto& value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof(value)); };
    for (TetId t : tets) {
      const Tet& tet = mesh.tets[t];
      add(tet.v);
      add(tet.state.quality);
      add(tet.state.tried);
      add(mesh.region_of_tet[t]);
    }
    for (VertexId v : vertices) {
      add(mesh.vertices[v]);
      add(mesh.tag_of_vertex[v]);
      add(mesh.host_of_vertex[v]);
      add(mesh.origin_of_vertex[v]);
      add(mesh.state_of_vertex[v].drift);
      add(mesh.is_vertex_alive(v));
    }
    return bytes;
  }

  std::vector<TetId> tets;
  std::set<VertexId> vertices;
};

TEST_P(InABlock, LeavesTheSeamsAlone) {
  for (unsigned round = 0; round < 3; ++round) {
    CutBench cut(round);
    const Seams seams(cut);
    EXPECT_GT(seams.tets.size(), 100);
    const std::string before = seams.values(cut.mesh);
    const test::Conserved conserved = test::conserved_by(cut.bench);
    int accepted = 0;
    for (std::size_t b = 0; b < cut.blocks.size(); ++b) {
      Kernel kernel = cut.kernel(b);
      accepted += run_all(GetParam(), kernel);
      EXPECT_TRUE(seams.values(cut.mesh) == before) << "block " << b;
    }
    EXPECT_GT(accepted, 3);
    cut.blocks.close();
    test::expect_sound(cut.bench, conserved);
  }
}

TEST(Insertion, IsPutOffWithoutIds) {
  const Mesh input = test::disturbed_domains()[0];
  Workbench bench(input, Sizes(input.points.size(), 0.15));
  const auto with = [&](const IdNeed& need, TetId t, int e) {
    bench.block.give_back(bench.mesh);
    bench.block.borrow(bench.mesh, need);
    const test::Snapshot before(bench.mesh);
    const test::Bits bits = bits_of(bench.mesh);
    const Outcome outcome = insert_on_edge(bench.kernel, t, e, {});
    EXPECT_TRUE(outcome == Outcome::accepted || test::Snapshot(bench.mesh) == before);
    EXPECT_TRUE(outcome != Outcome::put_off || bits_of(bench.mesh) == bits) << "marked, although put off";
    return outcome;
  };
  const test::Conserved conserved = test::conserved_by(bench);
  int inside = 0, at_surface = 0;
  test::for_each_tet_edge(bench.mesh, [&](TetId t, int e) {
    if (inside + at_surface > 60) return;
    const bool no_vertex = with({.vertices = 0, .tets = 200, .triangles = 40}, t, e) == Outcome::put_off;
    const Outcome no_tet = with({.vertices = 5, .tets = 0, .triangles = 40}, t, e);
    const Outcome no_triangle = with({.vertices = 5, .tets = 200, .triangles = 0}, t, e);
    if (no_triangle == Outcome::accepted) {
      EXPECT_EQ(bench.kernel.shell.triangle_count, 0);
      ++inside;
    } else {
      const Outcome outcome = with({.vertices = 5, .tets = 200, .triangles = 40}, t, e);
      EXPECT_EQ(no_triangle, outcome == Outcome::accepted ? Outcome::put_off : outcome);
      if (outcome != Outcome::accepted) return;
      EXPECT_GT(bench.kernel.shell.triangle_count, 0);
      ++at_surface;
    }
    EXPECT_TRUE(no_vertex);
    EXPECT_EQ(no_tet, Outcome::put_off);
    test::expect_sound(bench, conserved);
  });
  EXPECT_GT(inside, 10);
  EXPECT_GT(at_surface, 10);
}

// Swaps that create more tetrahedra than they remove: of a face, or of an edge with a large shell.
void expect_put_off_without_ids(const Kind& kind) {
  int put_off = 0, marked = 0;
  unsigned seed = 0;
  for (const Mesh& input : test::disturbed_domains()) {
    Workbench bench(input, test::random_field(input, 0.5, ++seed));
    const test::Conserved conserved = test::conserved_by(bench);
    for (TetId t : test::living_tets(bench.mesh))
      for (int part = 0; part < kind.parts && bench.mesh.tets[t].alive(); ++part) {
        bench.block.give_back(bench.mesh);
        const test::Bits before = bits_of(bench.mesh);
        const Outcome without = kind.run(bench.kernel, t, part);
        const bool changed = bits_of(bench.mesh) != before;
        bench.block.borrow(bench.mesh, plenty);
        if (without == Outcome::accepted) continue;
        marked += without == Outcome::put_off && changed ? 1 : 0;
        const Outcome with = kind.run(bench.kernel, t, part);
        EXPECT_EQ(without, with == Outcome::accepted ? Outcome::put_off : with);
        if (with != Outcome::accepted) continue;
        ++put_off;
        test::expect_sound(bench, conserved);
      }
  }
  EXPECT_GT(put_off, 5);
  EXPECT_EQ(marked, 0) << "no round would come back to them";
}

TEST(SwapEdge, IsPutOffWithoutIds) {
  expect_put_off_without_ids(kinds[2]);
}

TEST(SwapFace, IsPutOffWithoutIds) {
  expect_put_off_without_ids(kinds[3]);
}

}  // namespace
}  // namespace taut
