#include "cavity/collect.hpp"

#include <algorithm>

namespace taut {
namespace {

// The two vertices off each edge such that (edge, these) is an even permutation: a positive tetrahedron.
constexpr std::array<std::array<int, 2>, 6> off_edge = {{{2, 3}, {3, 1}, {1, 2}, {0, 3}, {2, 0}, {0, 1}}};

// A tetrahedron of the shell, with the two ring vertices between which it lies.
struct Step {
  TetId tet;
  VertexId from, to;
};

// Turns on round ab across the face (a, b, to); false at the boundary.
bool advance(const TetMesh& mesh, Step& step) {
  const FaceLink link = mesh.beyond(step.tet, mesh.tets[step.tet].index_of(step.from));
  if (link == outside) return false;
  step = {link.tet(), step.to, mesh.tets[link.tet()].v[link.face()]};
  return true;
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

// Turns back to the tetrahedron from which an open shell is walked in order; `first` itself if the shell is closed.
Step rewind(const TetMesh& mesh, const Step& first) {
  Step back{first.tet, first.to, first.from};
  do {
    if (!advance(mesh, back)) return {back.tet, back.to, back.from};
  } while (back.tet != first.tet);
  return first;
}

}  // namespace

bool collect_ball(const TetMesh& mesh, VertexId v, TetSet& ball) {
  return walk_ball(mesh, v, ball, [](const Tet&, int, VertexId) {});
}

bool collect_shell(const TetMesh& mesh, TetId t, int edge, Shell& shell) {
  const auto& v = mesh.tets[t].v;
  shell.a = v[edge_vertices[edge][0]];
  shell.b = v[edge_vertices[edge][1]];
  shell.size = shell.triangle_count = 0;
  Step first{t, v[off_edge[edge][0]], v[off_edge[edge][1]]};
  Step step = first;
  bool open = false;
  while (true) {
    if (!append(mesh, step, shell)) return false;
    if (!advance(mesh, step)) {
      if (open) break;
      open = true;  // met the boundary: start again from the shell's other end
      shell.size = shell.triangle_count = 0;
      step = rewind(mesh, first);
      if (!note_triangle(mesh, step, step.to, shell)) return false;
      first.tet = none;
      continue;
    }
    if (step.tet == first.tet) break;
  }
  shell.closed = !open;
  shell.ring_size = shell.size;
  if (open) shell.ring[shell.ring_size++] = step.to;
  return true;
}

}  // namespace taut
