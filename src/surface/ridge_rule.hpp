// When an edge is a ridge.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "surface/facets.hpp"
#include "surface/jump.hpp"

namespace taut {

/// How clearly the surface must turn at an edge, in radians: the triangles, and the sides' own normals.
struct RidgeThreshold {
  double dihedral, jump;
};

/// By angle, or by the shape of the surface.
class RidgeRule {
public:
  /// Refers to the facets; `pairs` are the edges of two triangles each. The angle is in degrees.
  RidgeRule(const Facets& facets, std::span<const EdgePair> pairs, std::optional<double> angle);

  /// Whether the edge is a ridge. Less is asked of those that are `given`.
  [[nodiscard]] bool holds_at(const EdgePair& pair, bool given) const;
  /// Whether a ridge that ends at one end of the edge goes on along it. Less is asked here too.
  [[nodiscard]] bool continues_at(const EdgePair& pair) const;

private:
  [[nodiscard]] bool exceeds(const EdgePair& pair, const RidgeThreshold& least) const;
  [[nodiscard]] double dihedral_at(const EdgePair& pair) const;

  std::optional<double> angle_;
  std::vector<Vec3> normals_;
  JumpFinder jumps_;
};

}  // namespace taut
