#include "mesh/edges.hpp"

#include <algorithm>
#include <bit>

#include "base/buckets.hpp"
#include "base/parallel.hpp"

namespace taut {
namespace {

using Tets = std::span<const std::array<Index, 4>>;

constexpr std::size_t vertices_per_task = 1024;  // each with about 36 edge ends to sort

struct Bound {
  std::size_t vertices = 0;
  Bound& operator+=(const Bound& other) {
    vertices = std::max(vertices, other.vertices);
    return *this;
  }
};

std::size_t vertex_bound(Tets tets) {
  const auto add = [&](Bound& sum, std::size_t t) { sum += {std::size_t{*std::ranges::max_element(tets[t])} + 1}; };
  return sum_in_order<Bound>(tets.size(), add).vertices;
}

// Moves one of each to the front and returns these. An edge occurs about five times. Marking seen edges in a hash table
// with linear probing leaves only a fifth to be sorted.
std::span<Index> distinct(std::span<Index> vertices) {
  const int bits = static_cast<int>(std::bit_width(2 * vertices.size()));
  std::vector<Index> seen(std::size_t{1} << bits, none);
  std::size_t count = 0;
  for (const Index v : vertices) {
    std::size_t slot = (v * 0x9e3779b9U) >> (32 - bits);
    while (seen[slot] != none && seen[slot] != v) slot = (slot + 1) & (seen.size() - 1);
    if (seen[slot] == v) continue;
    seen[slot] = vertices[count++] = v;
  }
  return vertices.first(count);
}

}  // namespace

std::vector<std::array<Index, 2>> edges_of(Tets tets) {
  auto larger_ends = gather<Index>(tets.size(), vertex_bound(tets), [&](std::size_t t, auto put) {
    for (const auto& [i, j] : edge_vertices) put(std::min(tets[t][i], tets[t][j]), std::max(tets[t][i], tets[t][j]));
  });
  using Edge = std::array<Index, 2>;
  const auto add_edges_from = [&](std::vector<Edge>& edges, std::size_t v) {
    const std::span<Index> ends = distinct(larger_ends[v]);
    std::ranges::sort(ends);
    for (const Index w : ends) edges.push_back({static_cast<Index>(v), w});
  };
  return collect_in_order<Edge>(Chunks(larger_ends.keys(), vertices_per_task), add_edges_from);
}

}  // namespace taut
