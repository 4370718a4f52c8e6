// A working mesh in a form that does not depend on the numbers of its entities.
#pragma once

#include <algorithm>
#include <vector>

#include "mesh/tet_mesh.hpp"

namespace taut::test {

/// The living entities by the positions of their vertices, each in ascending order.
struct Canonical {
  std::vector<Vec3> vertices;
  std::vector<std::pair<std::array<Vec3, 4>, RegionId>> tets;
  std::vector<std::pair<std::array<Vec3, 3>, PatchId>> triangles;
  bool operator==(const Canonical&) const = default;
};

/// Tetrahedra and triangles are permuted evenly to their least form.
template <std::size_t n>
std::array<Vec3, n> least_turn(const TetMesh& mesh, const std::array<VertexId, n>& v) {
  std::array<std::size_t, n> order;
  for (std::size_t i = 0; i < n; ++i) order[i] = i;
  std::array<Vec3, n> least{};
  bool any = false;
  do {
    int inversions = 0;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < i; ++j) inversions += order[j] > order[i] ? 1 : 0;
    if (inversions % 2 != 0) continue;
    std::array<Vec3, n> turned;
    for (std::size_t i = 0; i < n; ++i) turned[i] = mesh.x(v[order[i]]);
    if (!any || turned < least) least = turned;
    any = true;
  } while (std::next_permutation(order.begin(), order.end()));
  return least;
}

inline Canonical canonical(const TetMesh& mesh) {
  Canonical form;
  for (const VertexId v : ids<VertexId>(mesh.vertices.size()))
    if (mesh.is_vertex_alive(v)) form.vertices.push_back(mesh.x(v));
  for (const TetId t : ids<TetId>(mesh.tets.size()))
    if (mesh.tets[t].alive()) form.tets.emplace_back(least_turn(mesh, mesh.tets[t].v), mesh.region_of_tet[t]);
  for (const Triangle& t : mesh.triangles)
    if (t.alive()) form.triangles.emplace_back(least_turn(mesh, t.v), t.patch);
  std::sort(form.vertices.begin(), form.vertices.end());
  std::sort(form.tets.begin(), form.tets.end());
  std::sort(form.triangles.begin(), form.triangles.end());
  return form;
}

}  // namespace taut::test
