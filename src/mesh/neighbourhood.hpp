// The vertices around a vertex, ring by ring.
#pragma once

#include <span>
#include <vector>

#include "base/buckets.hpp"
#include "base/ids.hpp"
#include "taut/mesh.hpp"

namespace taut {

/// The ends of the edges at each of the `vertices`, ascending. `edges` holds each edge once.
[[nodiscard]] Buckets<Index> neighbours_of_vertices(std::span<const std::array<Index, 2>> edges, std::size_t vertices);

/// Scratch of one worker: it is reused from vertex to vertex.
class Neighbourhood {
public:
  explicit Neighbourhood(const Buckets<Index>& neighbours);

  /// Only the vertex itself.
  void start_at(Index vertex);

  /// Adds all vertices that an edge links to those of the last ring.
  void grow();

  /// The centre, then ring after ring.
  [[nodiscard]] std::span<const Index> vertices() const { return vertices_; }

private:
  void add(Index v);

  const Buckets<Index>* neighbours_;
  std::vector<std::uint32_t> seen_;  ///< the call of start_at() that added a vertex last
  std::uint32_t call_ = 0;
  std::size_t last_ring_ = 0;  ///< where it begins in vertices_
  std::vector<Index> vertices_;
};

}  // namespace taut
