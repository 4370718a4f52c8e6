#include "adapt/session.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "geometry/refit.hpp"
#include "metric/quality.hpp"

namespace taut {
namespace {

float quality_of(const TetMesh& mesh, const Tet& tet) {
  const auto at = [&](int k) -> const Vertex& { return mesh.vertices[tet.v[k]]; };
  const Vertex &a = at(0), &b = at(1), &c = at(2), &d = at(3);
  return static_cast<float>(shape_quality(a.x, b.x, c.x, d.x, a.m, b.m, c.m, d.m));
}

}  // namespace

void Session::measure_qualities() {
  for_each_index(mesh.tets.size(), [&](std::size_t t) { mesh.tets[t].state.quality = quality_of(mesh, mesh.tets[t]); });
}

void Session::refresh(std::span<const VertexId> moved) {
  std::vector<std::uint8_t> has_moved(mesh.vertices.size(), 0);
  for (VertexId v : moved) has_moved[v] = 1;
  refit(model, mesh, has_moved);
  for_each_index(moved.size(), [&](std::size_t i) {
    const VertexId v = moved[i];
    mesh.vertices[v].m = target->at(mesh.x(v), mesh.host_of_vertex[v]);
  });
  const auto is_at_moved = [&](std::size_t t) {
    return std::ranges::any_of(mesh.tets[t].v, [&](VertexId v) { return has_moved[v] != 0; });
  };
  const auto changed = indices_where(mesh.tets.size(), is_at_moved);
  for_each_index(changed.size(), [&](std::size_t i) {
    Tet& tet = mesh.tets[changed[i]];
    tet.state = {.quality = quality_of(mesh, tet), .tried = {}};
  });
  for (const std::uint32_t t : changed)
    for (VertexId v : mesh.tets[t].v) mesh.state_of_vertex[v].restless = true;
}

}  // namespace taut
