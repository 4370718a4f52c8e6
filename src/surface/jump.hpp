// Whether a surface is smooth across an edge: how far the sides' own normals differ there.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "surface/facets.hpp"

namespace taut {

/// On a coarse mesh of a smooth surface the normals of two triangles differ as they do at a ridge. But a surface that
/// is fitted to one side alone has at the edge the same normal as one that is fitted to the other side, unless the edge
/// is a ridge.
class JumpFinder {
public:
  /// Refers to all that it is given but the pairs, which are the edges of two triangles each, of one sense of rotation:
  /// see orient(). `normals` are by triangle.
  JumpFinder(const Facets& facets, std::span<const EdgePair> pairs, std::span<const Vec3> normals);

  /// The angle in radians between the normals at the middle of the edge of quadrics fitted to the points on either
  /// side, in the sense in which the triangles turn there: negative if the quadrics turn the other way.
  [[nodiscard]] double jump_at(const EdgePair& pair) const;

private:
  /// The least cosines between normals of a side: of a triangle to that at the edge, and to the one before it.
  struct Bounds {
    double to_first, to_previous;
  };

  enum class Reach { near, far, across_edges };  ///< of a side

  [[nodiscard]] double jump_at(const EdgePair& pair, Reach reach) const;
  [[nodiscard]] std::vector<VertexId> points_of_side(const EdgeUse& side, const EdgeUse& other, Reach reach) const;
  template <class IsOfSide>
  [[nodiscard]] std::vector<VertexId> grown(const EdgeUse& side, const EdgeUse& other, const Bounds& bounds,
                                            IsOfSide is_of_side) const;
  [[nodiscard]] Vec3 normal_of_side(const EdgeUse& side, const EdgeUse& other, Reach reach) const;

  const Facets& facets_;
  std::span<const Vec3> normals_;
  std::vector<std::array<TriangleId, 3>> beyond_;  ///< the edge opposite to each corner of a triangle, or `none`
};

}  // namespace taut
