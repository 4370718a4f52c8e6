// What the vertices of the boundary do while bodies move.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "adapt/session.hpp"
#include "elasticity/constraint.hpp"

namespace taut {

/// Who decides where a vertex goes.
enum class Driver : std::uint8_t {
  inside,  ///< nobody: it follows the others
  wall,    ///< it stays
  slide,   ///< it follows the others along one or two planar walls
  body,    ///< the body that it belongs to
};

struct Role {
  Driver driver = Driver::inside;
  std::uint16_t body = 0;  ///< number of the body, from 0

  bool operator==(const Role&) const = default;
};

struct Boundary {
  std::vector<Role> roles;                ///< by vertex
  std::vector<Constraint<Vec3>> sliding;  ///< by vertex; of those that slide
};

/// Triangles with the reference bodies[i] belong to body i. Those with one of the references `walls` slide; all others
/// are fixed. A vertex of a body belongs to it, whatever else it touches; between bodies, to the first of them.
[[nodiscard]] Boundary boundary_of(const Session& session, std::span<const int> bodies, std::span<const int> walls);

/// The vertices inside that are within so many edges of a body move with it, unless something else is as near.
void add_shell(Boundary& boundary, const TetMesh& mesh, int layers);

}  // namespace taut
