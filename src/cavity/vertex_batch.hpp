// A few dozen vertices that are gathered once, so that the edges to them can be measured in vector form.
#pragma once

#include <array>
#include <span>

#include "cavity/small_map.hpp"
#include "mesh/tet_mesh.hpp"

namespace taut {

/// Numbers vertices locally, from 0, in the order of their first mention.
class VertexBatch {
public:
  static constexpr int capacity = 64;

  void clear() {
    size_ = 0;
    local_of_.clear();
  }
  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] VertexId id(int i) const { return ids_[i]; }
  [[nodiscard]] Vec3 x(int i) const { return {x_[0][i], x_[1][i], x_[2][i]}; }
  [[nodiscard]] int find(VertexId v) const { return local_of_.find(v); }
  [[nodiscard]] bool contains(VertexId v) const { return local_of_.contains(v); }

  /// The local number of v, or -1 if there is no room for one more.
  int add(const TetMesh& mesh, VertexId v);

  /// Sum over the vertices of weights[i] (p - x(i)).
  [[nodiscard]] Vec3 weighted_edges(const Vec3& p, std::span<const double> weights) const;

  /// Fast edge lengths (edge_length_fast) from the apex to each vertex; valid until the next call.
  std::span<const double> lengths(const Vertex& apex);

private:
  int size_ = 0;
  SmallMap<256> local_of_;
  std::array<VertexId, capacity> ids_{};
  alignas(64) double x_[3][capacity]{};
  alignas(64) double m_[6][capacity]{};
  alignas(64) std::array<double, capacity> lengths_{};
};

}  // namespace taut
