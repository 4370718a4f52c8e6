// Whether a surface is smooth across an edge: how far the sides' own normals differ there.
#pragma once

#include <span>
#include <vector>

#include "base/buckets.hpp"
#include "surface/facets.hpp"

namespace taut {

/// On a coarse mesh of a smooth surface the normals of two triangles differ as they do at a ridge. But a surface that is
/// fitted to one side alone has at the edge the same normal as one that is fitted to the other side, unless the edge is
/// a ridge.
class JumpFinder {
public:
  /// Refers to all that it is given. Triangles have one sense of rotation, see orient(); `refs` is by triangle, and no
  /// side reaches beyond its reference.
  JumpFinder(const Facets& facets, std::span<const int> refs, std::span<const Vec3> normals);

  /// The angle in radians between the normals at the edge of quadrics (jets, at both ends) fitted to the points on
  /// either side of it.
  [[nodiscard]] double jump_at(const EdgePair& pair) const;

private:
  [[nodiscard]] std::vector<VertexId> points_of_side(const EdgeUse& side, const EdgeUse& other) const;
  [[nodiscard]] Vec3 normal_of_side(const EdgeUse& side, const EdgeUse& other) const;

  const Facets& facets_;
  std::span<const int> refs_;
  std::span<const Vec3> normals_;
  Buckets<TriangleId> triangles_of_vertices_;
  double tolerance_;
};

}  // namespace taut
