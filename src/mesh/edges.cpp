#include "mesh/edges.hpp"

#include <algorithm>

namespace taut {
namespace {

using Tets = std::span<const std::array<Index, 4>>;

std::size_t vertex_bound(Tets tets) {
  Index bound = 0;
  for (const auto& tet : tets) bound = std::max({bound, tet[0], tet[1], tet[2], tet[3]});
  return tets.empty() ? 0 : std::size_t{bound} + 1;
}

template <class Visit>
void for_each_edge(Tets tets, Visit&& visit) {
  for (const auto& tet : tets)
    for (const auto& [i, j] : edge_vertices) visit(std::min(tet[i], tet[j]), std::max(tet[i], tet[j]));
}

/// The larger end points of all edges, with repetitions, gathered by the smaller: those of v lie from first[v] to
/// first[v + 1].
struct Buckets {
  std::vector<std::size_t> first;
  std::vector<VertexId> larger;
};

Buckets gather_by_smaller_vertex(Tets tets) {
  Buckets b{std::vector<std::size_t>(vertex_bound(tets) + 2), std::vector<VertexId>(6 * tets.size())};
  for_each_edge(tets, [&](VertexId small, VertexId) { ++b.first[small + 2]; });
  for (std::size_t v = 2; v < b.first.size(); ++v) b.first[v] += b.first[v - 1];
  for_each_edge(tets, [&](VertexId small, VertexId large) { b.larger[b.first[small + 1]++] = large; });
  return b;
}

}  // namespace

std::vector<std::array<VertexId, 2>> edges_of(Tets tets) {
  const Buckets buckets = gather_by_smaller_vertex(tets);
  const std::size_t vertices = buckets.first.size() - 2;
  std::vector<std::array<VertexId, 2>> edges;
  edges.reserve(tets.size() + tets.size() / 4 + 16);
  // An edge occurs about five times: marking what was seen leaves a fifth to be sorted.
  std::vector<VertexId> seen_from(vertices, none);
  for (VertexId v = 0; v < vertices; ++v) {
    const auto start = static_cast<std::ptrdiff_t>(edges.size());
    for (std::size_t i = buckets.first[v]; i < buckets.first[v + 1]; ++i) {
      const VertexId w = buckets.larger[i];
      if (seen_from[w] == v) continue;
      seen_from[w] = v;
      edges.push_back({v, w});
    }
    std::sort(edges.begin() + start, edges.end());
  }
  return edges;
}

}  // namespace taut
