#include "adapt/session.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"
#include "geometry/refit.hpp"
#include "metric/quality.hpp"
#include "operators/repair.hpp"
#include "operators/vertex_move.hpp"

namespace taut {
namespace {

float quality_of(const TetMesh& mesh, const Tet& tet) {
  const auto at = [&](int k) -> const Vertex& { return mesh.vertices[tet.v[k]]; };
  const Vertex &a = at(0), &b = at(1), &c = at(2), &d = at(3);
  return static_cast<float>(shape_quality(a.x, b.x, c.x, d.x, a.m, b.m, c.m, d.m));
}

// Whether shapes have changed so much that swaps and moves are worth trying again: 1/Q of one tetrahedron by more than
// a share, or those at a vertex by shares that add up to more than the moves after which swaps are tried again.
constexpr float noticeable = 0.01F, adds_up = static_cast<float>(MoveRules{}.drift);
constexpr float bad = static_cast<float>(RepairRules{}.bad);
constexpr float tiny_quality = 1e-6F;

// The vertices at which small changes, one in each refresh, have added up.
std::vector<std::uint8_t> worn_vertices(TetMesh& mesh, std::span<const std::uint32_t> tets,
                                        std::span<const float> change) {
  std::vector<float> largest(mesh.vertices.size(), 0);
  for (std::size_t i = 0; i < tets.size(); ++i)
    if (change[i] <= noticeable)
      for (const VertexId v : mesh.tets[tets[i]].v) largest[v] = std::max(largest[v], change[i]);
  std::vector<std::uint8_t> worn(mesh.vertices.size(), 0);
  for_each_index(worn.size(), [&](std::size_t v) {
    float& drift = mesh.state_of_vertex[v].drift;
    drift += largest[v];
    if (largest[v] == 0 || drift <= adds_up) return;
    worn[v] = 1;
    drift = 0;
  });
  return worn;
}

// What moves rigidly keeps its shape, and costs nothing after that. But what is bad, and has no vertex that may move,
// can only be mended once its neighbours have changed.
void retry_shapes(TetMesh& mesh, std::span<const std::uint32_t> tets, std::span<const float> change) {
  const std::vector<std::uint8_t> worn = worn_vertices(mesh, tets, change);
  for (std::size_t i = 0; i < tets.size(); ++i) {
    Tet& tet = mesh.tets[tets[i]];
    const bool is_bad = tet.state.quality <= bad;
    const bool is_worn = std::ranges::any_of(tet.v, [&](VertexId v) { return worn[v] != 0; });
    if (!is_bad && !is_worn && change[i] <= noticeable) continue;
    tet.state.tried.forget_shapes();
    for (const VertexId v : tet.v) mesh.state_of_vertex[v].restless = true;
  }
}

}  // namespace

void Session::measure_qualities() {
  for_each_index(mesh.tets.size(), [&](std::size_t t) { mesh.tets[t].state.quality = quality_of(mesh, mesh.tets[t]); });
}

void Session::refresh(std::span<const VertexId> moved) {
  refresh(moved, {}, moved);
}

void Session::refresh(std::span<const VertexId> moved, const RigidMoves& rigid,
                      std::span<const VertexId> in_another_target) {
  std::vector<std::uint8_t> has_moved(mesh.vertices.size(), 0);
  for (VertexId v : moved) has_moved[v] = 1;
  refit(model, mesh, has_moved, rigid);
  for_each_index(in_another_target.size(), [&](std::size_t i) {
    const VertexId v = in_another_target[i];
    mesh.vertices[v].m = target->at(mesh.x(v), mesh.host_of_vertex[v]);
  });
  refresh_metrics(in_another_target);
}

void Session::refresh_metrics(std::span<const VertexId> changed) {
  std::vector<std::uint8_t> has_changed(mesh.vertices.size(), 0);
  for (VertexId v : changed) has_changed[v] = 1;
  const auto is_at_changed = [&](std::size_t t) {
    return std::ranges::any_of(mesh.tets[t].v, [&](VertexId v) { return has_changed[v] != 0; });
  };
  const auto tets = indices_where(mesh.tets.size(), is_at_changed);
  std::vector<float> change(tets.size());
  for_each_index(tets.size(), [&](std::size_t i) {
    TetState& state = mesh.tets[tets[i]].state;
    const float before = std::exchange(state.quality, quality_of(mesh, mesh.tets[tets[i]]));
    change[i] = std::abs(state.quality - before) / std::max(before, tiny_quality);
    state.tried.measure_lengths();
  });
  retry_shapes(mesh, tets, change);
}

}  // namespace taut
