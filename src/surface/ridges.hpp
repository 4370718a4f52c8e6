// The edges at which a surface is not smooth.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "surface/facets.hpp"

namespace taut {

/// An edge of the input.
struct GivenEdge {
  std::array<VertexId, 2> edge;  ///< ascending
  int ref = 0;
  bool sharp = false;  ///< a ridge, whatever the surface looks like there
};

struct RidgeEdge {
  std::array<VertexId, 2> edge;  ///< ascending
  int ref = 0;                   ///< as given
};

/// The edges of a surface, each once and in ascending order.
struct SplitEdges {
  std::vector<EdgePair> smooth;
  std::vector<RidgeEdge> ridges;
};

/// Turns the triangles to one sense of rotation where they are connected, and parts their edges. Ridges are: edges
/// where other than two triangles meet, or two of different reference (`refs` is by triangle); edges that are given as
/// sharp; edges where the normals of the two triangles differ by `angle` degrees or more.
///
/// Without an angle the surface decides. An edge is a ridge if the triangles' normals differ by more than 15 degrees,
/// and those of quadrics fitted on either side as well (surface/jump.hpp), and by more than 0.6 of what the triangles'
/// do. At an edge that is given, though not as sharp, 5 degrees suffice; so the seams that meshers write into a smooth
/// surface part nothing. Ridges are followed to their ends (surface/ridge_gaps.hpp), and the tips of cones have none
/// (surface/spokes.hpp). `given` is ascending.
[[nodiscard]] SplitEdges split_at_ridges(Facets& facets, std::span<const int> refs, std::span<const GivenEdge> given,
                                         std::optional<double> angle);

}  // namespace taut
