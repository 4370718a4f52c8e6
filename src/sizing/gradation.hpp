// Gradation: limits how fast the wanted sizes grow from vertex to vertex.
#pragma once

#include <span>
#include <vector>

#include "base/ids.hpp"
#include "base/sym3.hpp"
#include "taut/gradation.hpp"
#include "taut/mesh.hpp"

namespace taut {

/// Throws InputError unless 1 < beta < infinity and 0 <= mix <= 1.
void require_gradation(const Gradation& gradation);

/// Intersects the metric at each end of each edge with what the other end demands (sizing/growth.hpp), until no
/// eigenvalue would change by more than one in a thousand (a size by half of that). Metrics only grow; a metric that
/// meets all demands keeps its bits.
///
/// `points` and `metrics` have one entry per vertex; `edges` holds each edge once. The result depends neither on the
/// order of the vertices nor on that of the edges: where they are renumbered, it has the same bits.
[[nodiscard]] std::vector<Sym3> gradate(std::span<const Point> points, std::span<const std::array<Index, 2>> edges,
                                        std::vector<Sym3> metrics, const Gradation& gradation);

}  // namespace taut
