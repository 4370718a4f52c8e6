#include "elasticity/vertex_graph.hpp"

#include <algorithm>

#include "base/conjugate_gradients.hpp"

namespace taut {
namespace {

using Use = VertexGraph::Use;

Buckets<Use> uses_of(const TetMesh& mesh) {
  return gather<Use>(mesh.tets.size(), mesh.vertices.size(), [&](std::size_t t, auto put) {
    const Tet& tet = mesh.tets[t];
    if (!tet.alive()) return;
    for (std::uint32_t k = 0; k < 4; ++k) put(tet.v[k], Use{static_cast<TetId>(t), k, {}});
  });
}

void add_columns(const TetMesh& mesh, std::size_t i, std::span<const Use> uses, std::vector<std::uint32_t>& columns) {
  columns.push_back(static_cast<std::uint32_t>(i));
  const auto begin = static_cast<std::ptrdiff_t>(columns.size());
  for (const Use& use : uses)
    for (const VertexId v : mesh.tets[use.tet].v)
      if (v != i && std::find(columns.begin() + begin, columns.end(), std::uint32_t{v}) == columns.end())
        columns.push_back(v);
  std::sort(columns.begin() + begin, columns.end());
}

}  // namespace

VertexGraph::VertexGraph(const TetMesh& mesh) : uses_(uses_of(mesh)), first_(mesh.vertices.size() + 1, 0) {
  const Chunks rows = chunks_of_rows(size());
  columns_ = collect_in_order<std::uint32_t>(rows, [&](std::vector<std::uint32_t>& list, std::size_t i) {
    const std::size_t before = list.size();
    add_columns(mesh, i, uses_[i], list);
    first_[i + 1] = list.size() - before;
  });
  for (std::size_t i = 0; i < size(); ++i) first_[i + 1] += first_[i];
  for_each_index(rows, [&](std::size_t i) {
    const auto neighbours = columns(i).subspan(1);
    for (Use& use : uses_[i])
      for (std::size_t k = 0; k < 4; ++k) {
        const VertexId v = mesh.tets[use.tet].v[k];
        if (v == i) continue;
        const auto at = std::lower_bound(neighbours.begin(), neighbours.end(), static_cast<std::uint32_t>(v));
        use.place[k] = 1 + static_cast<std::uint32_t>(at - neighbours.begin());
      }
  });
}

}  // namespace taut
