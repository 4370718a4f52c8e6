// Where many points lie in a mesh.
#pragma once

#include <span>
#include <vector>

#include "locate/background.hpp"

namespace taut {

/// Where a point lies in a mesh or, if it lies outside, the nearest point of the boundary.
struct Place {
  CellId cell = none;
  Weights weights{};    ///< of the cell's vertices; rounding may make them negative by up to 1e-9
  double distance = 0;  ///< from the mesh; 0 inside
};

/// The place of each point. It is found whatever the shape of the domain: a walk from cell to cell that ends at the
/// boundary is followed by a search of all cells and, if none contains the point, of the whole boundary.
[[nodiscard]] std::vector<Place> places_of(const Background& mesh, std::span<const Vec3> points);

}  // namespace taut
