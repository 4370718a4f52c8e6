// A mesh cut into blocks, and every operation on them.
#pragma once

#include <string>

#include "operators/collapse.hpp"
#include "operators/insertion.hpp"
#include "operators/relocation.hpp"
#include "operators/repair.hpp"
#include "operators/swap.hpp"
#include "operators/workbench.hpp"
#include "partition/blocks.hpp"

namespace taut::test {

inline constexpr std::size_t block_size = 60;
inline constexpr IdNeed plenty = {.vertices = 30, .tets = 250, .triangles = 60};

inline Mesh domain() {
  Mesh mesh = cube(6);
  jitter(mesh, 0.03, 1);
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
  Workbench bench{input, random_field(input, 0.3, 1)};
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

inline constexpr std::array<Kind, 6> kinds = {{
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
inline int run_all(const Kind& kind, Kernel& kernel) {
  int accepted = 0;
  for_each_attempt(kind, kernel.mesh, *kernel.block, [&](std::uint32_t id, int part) {
    accepted += kind.run(kernel, id, part) == Outcome::accepted ? 1 : 0;
  });
  return accepted;
}

inline bool owns(const Block& block, const Tet& tet) {
  return std::ranges::all_of(tet.v, [&](VertexId v) { return block.owns(v); });
}

// All data of a mesh, including the records of tries and the contents of dead entities.
using Bits = std::vector<std::string>;

inline Bits bits_of(const TetMesh& mesh) {
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

}  // namespace taut::test
