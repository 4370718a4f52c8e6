#include "cavity/vertex_batch.hpp"

#include <cmath>

#include "metric/length.hpp"

namespace taut {

int VertexBatch::add(const TetMesh& mesh, VertexId v) {
  const int found = local_of_.find_or_insert(v, size_);
  if (found < size_) return found;
  if (size_ == capacity) return -1;
  const Vertex& vertex = mesh.vertices[v];
  ids_[size_] = v;
  for (int d = 0; d < 3; ++d) x_[d][size_] = vertex.x[d];
  for (int k = 0; k < 6; ++k) m_[k][size_] = vertex.m[k];
  return size_++;
}

Vec3 VertexBatch::weighted_edges(const Vec3& p, std::span<const double> weights) const {
  Vec3 sum{};
  for (int i = 0; i < size_; ++i)
    for (int d = 0; d < 3; ++d) sum[d] += weights[i] * (p[d] - x_[d][i]);
  return sum;
}

std::span<const double> VertexBatch::lengths(const Vertex& apex) {
  const Vec3 p = apex.x;
  const Sym3 m = apex.m;
  const int lanes = (size_ + 3) & ~3;  // whole vectors: nothing reads the lanes beyond the end
  for (int i = 0; i < lanes; ++i) {
    const double x = x_[0][i] - p[0], y = x_[1][i] - p[1], z = x_[2][i] - p[2];
    const double a = quadratic_form(m[0], m[1], m[2], m[3], m[4], m[5], x, y, z);
    const double b = quadratic_form(m_[0][i], m_[1][i], m_[2][i], m_[3][i], m_[4][i], m_[5][i], x, y, z);
    lengths_[i] = simpson_mean(std::sqrt(a), std::sqrt(b));
  }
  return {lengths_.data(), static_cast<std::size_t>(size_)};
}

}  // namespace taut
