// What the vertices of the boundary do while bodies move.
#include "motion/boundary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "adapt/setup.hpp"
#include "motion/room.hpp"

namespace taut::test {
namespace {

constexpr int other_body = 8;

/// The upper half of the body is another one.
Mesh room_with_halves() {
  Mesh mesh = restricted(cube(6), [](const Vec3& x) { return distance_from_middle(x) > 0.5 / 3; });
  add_triangles(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 centre = centre_of(mesh, mesh.triangles[t]);
    mesh.triangle_refs[t] = distance_from_middle(centre) > 0.4 ? wall : centre[2] > 0.5 ? other_body : body;
  }
  return mesh;
}

/// By point.
std::vector<Role> roles_in(const Mesh& mesh, const std::vector<int>& bodies) {
  Report report;
  const Session session = set_up(mesh, Sizes(mesh.points.size(), 0.2), {}, report);
  const Boundary boundary = boundary_of(session, bodies, {});
  std::vector<Role> roles(mesh.points.size());
  for (const VertexId v : session.mesh.vertex_ids()) roles[session.mesh.origin_of_vertex[v]] = boundary.roles[v];
  return roles;
}

TEST(Boundary, BetweenBodiesMovesWithTheFirst) {
  const Mesh mesh = room_with_halves();
  Mesh reversed = mesh;
  std::ranges::reverse(reversed.triangles);
  std::ranges::reverse(reversed.triangle_refs);
  std::map<Index, int> bodies_at;
  for (const int ref : {body, other_body}) {
    std::vector<std::uint8_t> has(mesh.points.size(), 0);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      if (mesh.triangle_refs[t] == ref)
        for (const Index v : mesh.triangles[t]) has[v] = 1;
    for (Index v = 0; v < has.size(); ++v) bodies_at[v] += has[v];
  }
  for (const std::vector<int>& bodies : {std::vector{body, other_body}, std::vector{other_body, body}}) {
    const std::vector<Role> roles = roles_in(mesh, bodies);
    EXPECT_EQ(roles_in(reversed, bodies), roles);
    int between = 0;
    for (const auto& [v, count] : bodies_at) {
      if (count < 2) continue;
      EXPECT_EQ(roles[v], (Role{Driver::body, 0}));
      ++between;
    }
    EXPECT_GT(between, 4);
  }
}

}  // namespace
}  // namespace taut::test
