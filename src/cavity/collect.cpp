#include "cavity/collect.hpp"

#include <algorithm>

namespace taut {
namespace {

// The two vertices opposite each edge such that (edge, these two) is an even permutation, that is, a positive
// tetrahedron.
constexpr std::array<std::array<int, 2>, 6> off_edge = {{{2, 3}, {3, 1}, {1, 2}, {0, 3}, {2, 0}, {0, 1}}};

// A tetrahedron of the shell, and the two ring vertices between which it lies.
struct Step {
  TetId tet;
  VertexId from, to;
};

enum class Turn { on, boundary, foreign };

// Continues around ab across the face (a, b, to). If the whole ball of one end of the edge is in the block, `block` is
// null, because nothing needs to be checked.
Turn advance(const TetMesh& mesh, const Block* block, Step& step) {
  const FaceLink link = mesh.beyond(step.tet, mesh.tets[step.tet].index_of(step.from));
  if (link == outside) return Turn::boundary;
  step = {link.tet(), step.to, mesh.tets[link.tet()].v[link.face()]};
  return block != nullptr && !block->owns(step.to) ? Turn::foreign : Turn::on;
}

bool note_triangle(const TetMesh& mesh, const Step& step, VertexId face_opposite, Shell& shell) {
  const FaceLink link = mesh.tets[step.tet].n[mesh.tets[step.tet].index_of(face_opposite)];
  if (!link.is_triangle()) return true;
  if (shell.triangle_count == static_cast<int>(shell.triangles.size())) return false;
  shell.triangles[shell.triangle_count++] = link.triangle();
  return true;
}

bool append(const TetMesh& mesh, const Step& step, Shell& shell) {
  if (shell.size == Shell::capacity) return false;
  const Tet& tet = mesh.tets[step.tet];
  shell.tets[shell.size] = step.tet;
  shell.edges[shell.size] = edge_between[tet.index_of(shell.a)][tet.index_of(shell.b)];
  shell.ring[shell.size++] = step.from;
  return note_triangle(mesh, step, step.from, shell);
}

// Walks back, from a tetrahedron at the boundary, to the first tetrahedron of the open shell.
Turn rewind(const TetMesh& mesh, const Block* block, Step& step) {
  Step back{step.tet, step.to, step.from};
  Turn turn = Turn::on;
  while (turn == Turn::on) turn = advance(mesh, block, back);
  step = {back.tet, back.to, back.from};
  return turn;
}

}  // namespace

bool collect_ball(const TetMesh& mesh, VertexId v, TetSet& ball) {
  return walk_ball(mesh, v, ball, [](const Tet&, int, VertexId) {});
}

Outcome collect_shell(const TetMesh& mesh, const Block& block, TetId t, int edge, Shell& shell) {
  const auto& v = mesh.tets[t].v;
  shell.a = v[edge_vertices[edge][0]];
  shell.b = v[edge_vertices[edge][1]];
  shell.size = shell.triangle_count = 0;
  const Block* guard = block.owns_ball(shell.a) || block.owns_ball(shell.b) ? nullptr : &block;
  Step step{t, v[off_edge[edge][0]], v[off_edge[edge][1]]};
  bool open = false;
  while (true) {
    if (!append(mesh, step, shell)) return Outcome::too_large;
    const Turn turn = advance(mesh, guard, step);
    if (turn == Turn::foreign) return Outcome::put_off;
    if (turn == Turn::boundary) {
      if (open) break;
      open = true;  // start again at the other end of the shell
      shell.size = shell.triangle_count = 0;
      if (rewind(mesh, guard, step) == Turn::foreign) return Outcome::put_off;
      if (!note_triangle(mesh, step, step.to, shell)) return Outcome::too_large;
    } else if (!open && step.tet == t) {
      break;
    }
  }
  shell.closed = !open;
  shell.ring_size = shell.size;
  if (open) shell.ring[shell.ring_size++] = step.to;
  return Outcome::accepted;
}

}  // namespace taut
