#include "operators/lift.hpp"

#include <cmath>

#include "operators/vertex_move.hpp"

namespace taut {
namespace {

TetId worst_tet(const Kernel& k) {
  const auto ball = k.cavity.tets.span();
  TetId worst = ball[0];
  for (TetId t : ball)
    if (k.mesh.tets[t].state.quality < k.mesh.tets[worst].state.quality) worst = t;
  return worst;
}

// Orthogonal to the face in the metric of v.
Vec3 away_from_face(const Kernel& k, TetId t, VertexId v) {
  const TetMesh& mesh = k.mesh;
  const auto face = mesh.face(t, mesh.tets[t].index_of(v));
  const Vec3 inward = cross(mesh.x(face[2]) - mesh.x(face[0]), mesh.x(face[1]) - mesh.x(face[0]));
  return adjugate(mesh.vertices[v].m) * inward;
}

}  // namespace

Outcome lift(Kernel& kernel, VertexId v, double gain) {
  if (!kernel.block->owns_ball(v)) return Outcome::put_off;
  if (kernel.mesh.tag_of_vertex[v].is_at_corner()) return Outcome::geometry;
  VertexMove move(kernel, v);
  if (const Outcome outcome = move.gather(); outcome != Outcome::accepted) return outcome;
  const Vec3 direction = away_from_face(kernel, worst_tet(kernel), v);
  const double length = std::sqrt(quadratic_form(move.old().m, direction));
  Outcome outcome = Outcome::no_candidate;
  for (const double share : {0.5, 0.25, 0.12, 0.06}) {  // of a unit length
    outcome = move.propose((share / length) * direction);
    if (outcome != Outcome::accepted) continue;
    outcome = kernel.batch.all_above(gain * move.old_quality()) ? move.commit({}) : Outcome::quality;
    if (outcome == Outcome::accepted) return outcome;
  }
  return outcome;
}

}  // namespace taut
