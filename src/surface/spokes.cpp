#include "surface/spokes.hpp"

#include <algorithm>
#include <cstddef>
#include <map>

#include "base/disjoint_sets.hpp"
#include "surface/apexes.hpp"

namespace taut {
namespace {

constexpr int longest_spoke = 2;
constexpr std::size_t most_vertices_of_spokes = 32;

bool holds_vertex(std::span<const VertexId> vertices, VertexId v) {
  return std::find(vertices.begin(), vertices.end(), v) != vertices.end();
}

/// Connected ridges.
struct RidgeTree {
  std::vector<VertexId> vertices;
  bool ends = false;      ///< whether a ridge ends in a smooth part of the surface
  bool is_given = false;  ///< whether an edge is, by the input
};

/// By root of the set of vertices.
std::map<std::uint32_t, RidgeTree> connected_ridges(DisjointSets& connected, std::span<const EdgePair> pairs,
                                                    std::span<const Parting> parting) {
  std::map<VertexId, int> ridges_at;
  for (std::size_t e = 0; e < pairs.size(); ++e)
    if (parting[e] != Parting::smooth)
      for (const VertexId v : pairs[e][0].edge) ++ridges_at[v];
  std::map<std::uint32_t, RidgeTree> found;
  for (const auto& [v, count] : ridges_at) {
    RidgeTree& tree = found[connected.root(v)];
    tree.vertices.push_back(v);
    tree.ends |= count == 1;
  }
  for (std::size_t e = 0; e < pairs.size(); ++e)
    if (parting[e] == Parting::by_input) found[connected.root(pairs[e][0].edge[0])].is_given = true;
  return found;
}

/// Whether all vertices are within two edges of the centre.
bool are_around(std::span<const VertexId> vertices, VertexId centre, const Facets& facets,
                const Buckets<TriangleId>& triangles_at) {
  std::vector<VertexId> reached{centre};
  std::size_t begin = 0;
  for (int ring = 0; ring < longest_spoke; ++ring) {
    const std::size_t end = reached.size();
    for (std::size_t i = begin; i < end; ++i)
      for (const TriangleId t : triangles_at[reached[i]])
        for (const VertexId v : facets.triangles[t])
          if (!holds_vertex(reached, v)) reached.push_back(v);
    begin = end;
  }
  return std::all_of(vertices.begin(), vertices.end(), [&](VertexId v) { return holds_vertex(reached, v); });
}

}  // namespace

void drop_spokes(const Facets& facets, std::span<const EdgePair> pairs, std::vector<Parting>& parting) {
  std::vector<EdgePair> not_given;
  DisjointSets connected(facets.points.size());
  for (std::size_t e = 0; e < pairs.size(); ++e) {
    if (parting[e] != Parting::by_input) not_given.push_back(pairs[e]);
    if (parting[e] != Parting::smooth) connected.join(pairs[e][0].edge[0], pairs[e][0].edge[1]);
  }
  const auto is_apex = find_apexes(facets, find_sectors(facets.triangles, not_given), {});
  const auto triangles_at = triangles_of_vertices(facets);
  auto trees = connected_ridges(connected, pairs, parting);
  std::erase_if(trees, [&](const auto& entry) {
    const RidgeTree& tree = entry.second;
    return tree.is_given || !tree.ends || tree.vertices.size() > most_vertices_of_spokes ||
           std::none_of(tree.vertices.begin(), tree.vertices.end(), [&](VertexId v) {
             return is_apex[v] != 0 && are_around(tree.vertices, v, facets, triangles_at);
           });
  });
  for (std::size_t e = 0; e < pairs.size(); ++e)
    if (parting[e] == Parting::by_shape && trees.contains(connected.root(pairs[e][0].edge[0])))
      parting[e] = Parting::smooth;
}

}  // namespace taut
