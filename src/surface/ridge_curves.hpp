// Ridges joined to smooth curves between corners.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/buckets.hpp"
#include "surface/cubic_segment.hpp"
#include "surface/ridges.hpp"
#include "taut/mesh.hpp"

namespace taut {

/// A chain of ridge edges. A closed one begins and ends with the same vertex.
struct RidgeCurve {
  int ref = 0;
  std::vector<VertexId> vertices;
  std::vector<Index> edges;            ///< between them: indices of ridge edges
  std::vector<CubicSegment> segments;  ///< one for each of these, in the sense of the chain

  [[nodiscard]] bool is_closed() const { return vertices.front() == vertices.back(); }
};

struct RidgeCurves {
  std::vector<RidgeCurve> curves;
  std::vector<CubicSegment> of_edge;    ///< by ridge edge, from its smaller vertex to the larger
  std::vector<std::uint8_t> is_corner;  ///< by vertex: the ends of curves, and what was given as a corner on one
};

/// Corners are vertices of ridges that other than two of them meet, that are in `given` (by vertex, not 0 if so), where
/// references differ, and where the chain turns sharply: by `angle` degrees or more. Without an angle: by more than 45
/// degrees, or by more than 15 if the arcs on both sides do not fit to each other, as ridges of surfaces are found.
[[nodiscard]] RidgeCurves find_ridge_curves(const std::vector<Vec3>& points, std::span<const RidgeEdge> ridges,
                                            std::span<const std::uint8_t> given, std::optional<double> angle);

/// The tangent at b of the circle through a, b, c, from a to c; of any length.
[[nodiscard]] Vec3 tangent_of_circle(const Vec3& a, const Vec3& b, const Vec3& c);

/// The tangent of a circle at one end of a chord along e, from that at the other end; both in the sense of e.
[[nodiscard]] Vec3 reflected(const Vec3& tangent, const Vec3& e);

}  // namespace taut
