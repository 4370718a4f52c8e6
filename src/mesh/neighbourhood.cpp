#include "mesh/neighbourhood.hpp"

namespace taut {

Buckets<Index> neighbours_of_vertices(std::span<const std::array<Index, 2>> edges, std::size_t vertices) {
  return gather<Index>(edges.size(), vertices, [&](std::size_t e, auto put) {
    const auto& [p, q] = edges[e];
    put(p, q);
    put(q, p);
  });
}

Neighbourhood::Neighbourhood(const Buckets<Index>& neighbours)
    : neighbours_(&neighbours), seen_(neighbours.keys(), 0) {}

void Neighbourhood::start_at(Index vertex) {
  ++call_;
  vertices_.clear();
  last_ring_ = 0;
  add(vertex);
}

void Neighbourhood::grow() {
  const std::size_t end = vertices_.size();
  for (std::size_t i = last_ring_; i < end; ++i)
    for (const Index v : (*neighbours_)[vertices_[i]]) add(v);
  last_ring_ = end;
}

void Neighbourhood::add(Index v) {
  if (seen_[v] == call_) return;
  seen_[v] = call_;
  vertices_.push_back(v);
}

}  // namespace taut
