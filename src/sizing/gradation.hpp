// Gradation: limits how fast the wanted sizes grow from vertex to vertex.
#pragma once

#include <span>
#include <vector>

#include "base/ids.hpp"
#include "base/sym3.hpp"
#include "taut/mesh.hpp"

namespace taut {

/// Makes the sizes grow by at most the factor beta > 1 per unit length along every edge: "H-correction" of Borouchaki,
/// Hecht and Frey 1998 in metric space (Dobrzynski and Frey 2008, 4.1; Alauzet 2010). M_p grown to q is
/// M_p / (1 + l_p(pq) ln beta)^2, and M_q is intersected with it, in both directions, until no eigenvalue would change
/// by more than one in a thousand (a size by half of that). Metrics only grow; a metric within all bounds keeps its
/// bits.
///
/// `points` and `metrics` have one entry per vertex; `edges` holds each edge once. The same input gives the same bits.
[[nodiscard]] std::vector<Sym3> gradate(std::span<const Point> points, std::span<const std::array<Index, 2>> edges,
                                        std::vector<Sym3> metrics, double beta);

}  // namespace taut
