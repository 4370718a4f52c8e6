#include "surface/spokes.hpp"

#include <algorithm>
#include <cstddef>
#include <map>

#include "base/disjoint_sets.hpp"
#include "surface/apexes.hpp"

namespace taut {
namespace {

constexpr int longest_spoke = 3;
constexpr std::size_t most_vertices_of_stray = 3;  ///< two edges that nothing continues at either end
constexpr std::size_t most_vertices_of_spokes = 32;

bool holds_vertex(std::span<const VertexId> vertices, VertexId v) {
  return std::find(vertices.begin(), vertices.end(), v) != vertices.end();
}

/// Whether other than two triangles meet at an edge of each vertex: around the others there are as many edges as
/// triangles.
std::vector<std::uint8_t> borders(const Facets& facets, std::span<const EdgePair> pairs,
                                  const Buckets<TriangleId>& triangles_at) {
  std::vector<std::size_t> edges(facets.points.size(), 0);
  for (const EdgePair& pair : pairs)
    for (const VertexId v : pair[0].edge) ++edges[v];
  std::vector<std::uint8_t> is_on_border(edges.size());
  for (std::size_t v = 0; v < edges.size(); ++v) is_on_border[v] = edges[v] != triangles_at[v].size();
  return is_on_border;
}

/// Connected ridges.
struct RidgeTree {
  std::vector<VertexId> vertices;
  int ends = 0;           ///< vertices where a ridge ends in a smooth part of the surface
  bool is_given = false;  ///< whether an edge is, by the input
};

/// By root of the set of vertices.
std::map<std::uint32_t, RidgeTree> connected_ridges(DisjointSets& connected, std::span<const EdgePair> pairs,
                                                    std::span<const Parting> parting,
                                                    std::span<const std::uint8_t> is_on_border) {
  std::map<VertexId, int> ridges_at;
  for (std::size_t e = 0; e < pairs.size(); ++e)
    if (parting[e] != Parting::smooth)
      for (const VertexId v : pairs[e][0].edge) ++ridges_at[v];
  std::map<std::uint32_t, RidgeTree> found;
  for (const auto& [v, count] : ridges_at) {
    RidgeTree& tree = found[connected.root(v)];
    tree.vertices.push_back(v);
    if (count == 1 && is_on_border[v] == 0) ++tree.ends;
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
  const auto is_spokes = [&](const RidgeTree& tree) {
    return tree.ends > 0 && tree.vertices.size() <= most_vertices_of_spokes &&
           std::any_of(tree.vertices.begin(), tree.vertices.end(), [&](VertexId v) {
             return is_apex[v] != 0 && are_around(tree.vertices, v, facets, triangles_at);
           });
  };
  const auto is_short = [](const RidgeTree& tree) {
    return tree.ends == 2 && tree.vertices.size() <= most_vertices_of_stray;
  };
  auto trees = connected_ridges(connected, pairs, parting, borders(facets, pairs, triangles_at));
  std::erase_if(trees, [&](const auto& entry) {
    const RidgeTree& tree = entry.second;
    return tree.is_given || !(is_spokes(tree) || is_short(tree));
  });
  for (std::size_t e = 0; e < pairs.size(); ++e)
    if (parting[e] == Parting::by_shape && trees.contains(connected.root(pairs[e][0].edge[0])))
      parting[e] = Parting::smooth;
}

}  // namespace taut
