// Operations in a part of a mesh: what they do not change, and that parts do not depend on each other.
#include "partition/block.hpp"

#include <functional>
#include <numeric>
#include <random>
#include <string>

#include "base/parallel.hpp"
#include "operators/collapse.hpp"
#include "operators/insertion.hpp"
#include "operators/relocation.hpp"
#include "operators/repair.hpp"
#include "operators/swap.hpp"
#include "operators/workbench.hpp"
#include "partition/blocks.hpp"
#include "taut/threads.hpp"

namespace taut {
namespace {

using test::Workbench;

constexpr std::size_t block_size = 60;
constexpr IdNeed plenty = {.vertices = 30, .tets = 250, .triangles = 60};

Mesh domain() {
  Mesh mesh = test::cube(6);
  test::jitter(mesh, 0.03, 1);
  return mesh;
}

// A domain whose mesh is divided into blocks.
struct CutBench {
  explicit CutBench(unsigned round, const IdNeed& need = plenty) { cut(round, need); }

  void cut(unsigned round, const IdNeed& need) {
    blocks.cut(block_size, round);
    blocks.lend(std::vector<IdNeed>(blocks.size(), need));
  }
  [[nodiscard]] Kernel kernel(std::size_t b) { return {mesh, bench.model, bench.target, &blocks[b]}; }

  Mesh input = domain();
  Workbench bench{input, test::random_field(input, 0.3, 1)};
  TetMesh& mesh = bench.mesh;
  Blocks blocks{(bench.block.give_back(mesh), mesh)};
};

// An operation, and the kind of entity of a block that it works on: edges or faces of tetrahedra, tetrahedra, or
// vertices.
struct Kind {
  const char* name;
  int parts;  // of a tetrahedron; 0: of vertices
  Outcome (*run)(Kernel& kernel, std::uint32_t id, int part);
};

constexpr std::array<Kind, 6> kinds = {{
    {"insertion", 6, [](Kernel& k, std::uint32_t t, int e) { return insert_on_edge(k, TetId{t}, e, {}); }},
    {"collapse", 6,
     [](Kernel& k, std::uint32_t t, int e) {
       return collapse_edge(k, TetId{t}, e, {.longest_new_edge = 9, .worst_quality = 0.01, .share_of_old = 0});
     }},
    {"edge_swap", 6,
     [](Kernel& k, std::uint32_t t, int e) {
       return swap_edge(k, TetId{t}, e, {.good_enough = 1, .longest_new_edge = 9});
     }},
    {"face_swap", 4,  // also for the worse, because hardly any gains
     [](Kernel& k, std::uint32_t t, int f) {
       return swap_face(k, TetId{t}, f, {.good_enough = 1, .gain = 0.1, .longest_new_edge = 9});
     }},
    {"repair", 1, [](Kernel& k, std::uint32_t t, int) { return repair(k, TetId{t}, {}); }},
    {"relocation", 0, [](Kernel& k, std::uint32_t v, int) { return relocate(k, VertexId{v}, {}); }},
}};

// Calls attempt(id, part) for all entities that the block has at the beginning and that still exist when their turn
// comes.
template <class Attempt>
void for_each_attempt(const Kind& kind, const TetMesh& mesh, const Block& block, Attempt attempt) {
  const bool of_vertices = kind.parts == 0;
  const auto id = [&](std::size_t i) { return of_vertices ? block.vertices[i] + 0U : block.tets[i] + 0U; };
  const auto alive = [&](std::uint32_t of) {
    return of_vertices ? mesh.is_vertex_alive(VertexId{of}) : mesh.tets[of].alive();
  };
  const std::size_t count = of_vertices ? block.vertices.size() : block.tets.size();
  for (std::size_t i = 0; i < count; ++i)
    for (int part = 0; part < std::max(1, kind.parts) && alive(id(i)); ++part) attempt(id(i), part);
}

// Returns how many were accepted.
int run_all(const Kind& kind, Kernel& kernel) {
  int accepted = 0;
  for_each_attempt(kind, kernel.mesh, *kernel.block, [&](std::uint32_t id, int part) {
    accepted += kind.run(kernel, id, part) == Outcome::accepted ? 1 : 0;
  });
  return accepted;
}

bool owns(const Block& block, const Tet& tet) {
  return std::ranges::all_of(tet.v, [&](VertexId v) { return block.owns(v); });
}

// All data of a mesh, including the records of tries and the contents of dead entities.
using Bits = std::vector<std::string>;

Bits bits_of(const TetMesh& mesh) {
  static_assert(sizeof(Tet) == 40 && sizeof(Triangle) == 36 && sizeof(Vertex) == 72, "padding has no value");
  Bits bits;
  const auto add = [&]<class T>(const std::vector<T>& array, const T&) {
    if constexpr (std::is_same_v<T, VertexState>)
      for (const VertexState& state : array) bits.push_back(std::to_string(state.drift) + (state.restless ? "r" : ""));
    else
      bits.emplace_back(reinterpret_cast<const char*>(array.data()), array.size() * sizeof(T));
  };
  TetMesh::for_each_vertex_array(mesh, add);
  TetMesh::for_each_tet_array(mesh, add);
  TetMesh::for_each_triangle_array(mesh, add);
  return bits;
}

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
      const Bits bits = bits_of(cut.mesh);
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
  const Mesh input = domain();
  Workbench bench(input, test::random_field(input, 0.3, 1));
  Kernel& whole = bench.kernel;
  Blocks blocks(bench.mesh);
  blocks.cut(block_size, 0);
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

// Calls work(block, kind) for all blocks and kinds, in its own order.
using Work = std::function<void(std::size_t block, std::size_t kind)>;
using Schedule = void (*)(std::size_t blocks, const Work& work);

void in_order(std::size_t blocks, const Work& work, const std::function<void(std::vector<std::size_t>&)>& arrange) {
  std::vector<std::size_t> order(blocks);
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    std::iota(order.begin(), order.end(), std::size_t{0});
    arrange(order);
    for (std::size_t b : order) work(b, kind);
  }
}

void forward(std::size_t blocks, const Work& work) {
  in_order(blocks, work, [](auto&) {});
}

void backward(std::size_t blocks, const Work& work) {
  in_order(blocks, work, [](auto& order) { std::ranges::reverse(order); });
}

void shuffled(std::size_t blocks, const Work& work) {
  std::mt19937 generator(7);
  in_order(blocks, work, [&](auto& order) { std::ranges::shuffle(order, generator); });
}

void block_by_block(std::size_t blocks, const Work& work) {
  for (std::size_t b = 0; b < blocks; ++b)
    for (std::size_t kind = 0; kind < kinds.size(); ++kind) work(b, kind);
}

void on_three_threads(std::size_t blocks, const Work& work) {
  on_threads(3, [&] {
    for_each_task(blocks, [&](std::size_t b, int) {
      for (std::size_t kind = 0; kind < kinds.size(); ++kind) work(b, kind);
    });
  });
}

// The ids that a mesh would hand out next.
std::vector<std::uint32_t> next_ids(TetMesh& mesh) {
  Block block;
  block.borrow(mesh, plenty);
  std::vector<std::uint32_t> ids;
  const auto add = [&ids](const auto& pool) { ids.insert(ids.end(), pool.unused().begin(), pool.unused().end()); };
  add(block.vertices);
  add(block.tets);
  add(block.triangles);
  return ids;
}

struct Adapted {
  Bits bits;
  std::vector<std::uint32_t> next;
  std::string fault;
  bool operator==(const Adapted&) const = default;
};

// The mesh after three rounds, each with another cut.
Adapted adapted(Schedule schedule, bool one_kernel) {
  CutBench cut(0);
  for (unsigned round = 0; round < 3; ++round) {
    if (round > 0) cut.cut(round, plenty);
    Kernel shared = cut.kernel(0);
    schedule(cut.blocks.size(), [&](std::size_t b, std::size_t kind) {
      if (!one_kernel) {
        Kernel own = cut.kernel(b);
        (void)run_all(kinds[kind], own);
        return;
      }
      shared.block = &cut.blocks[b];
      (void)run_all(kinds[kind], shared);
    });
    cut.blocks.close();
  }
  Adapted outcome{bits_of(cut.mesh), {}, first_broken_invariant(cut.mesh)};
  outcome.next = next_ids(cut.mesh);
  return outcome;
}

TEST(BlocksOfAMesh, GiveTheSameBitsInAnyOrder) {
  const Adapted expected = adapted(forward, true);
  EXPECT_EQ(expected.fault, "");
  EXPECT_TRUE(adapted(forward, true) == expected);
  EXPECT_TRUE(adapted(forward, false) == expected) << "a kernel remembers";
  EXPECT_TRUE(adapted(backward, true) == expected);
  EXPECT_TRUE(adapted(shuffled, true) == expected);
  EXPECT_TRUE(adapted(block_by_block, true) == expected);
  EXPECT_TRUE(adapted(on_three_threads, false) == expected);
}

TEST(Insertion, IsPutOffWithoutIds) {
  const Mesh input = test::disturbed_domains()[0];
  Workbench bench(input, Sizes(input.points.size(), 0.15));
  const auto with = [&](const IdNeed& need, TetId t, int e) {
    bench.block.give_back(bench.mesh);
    bench.block.borrow(bench.mesh, need);
    const test::Snapshot before(bench.mesh);
    const Bits bits = bits_of(bench.mesh);
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
        const Bits before = bits_of(bench.mesh);
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
