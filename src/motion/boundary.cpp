#include "motion/boundary.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace taut {
namespace {

constexpr double same_wall = 1e-6;  // sine of the angle up to which two walls count as one

// The directions in which a vertex on walls cannot go; as many as are independent.
class WallNormals {
public:
  void add(const Vec3& normal) {
    Vec3 rest = normal;
    for (std::size_t k = 0; k < count_; ++k) rest = rest - dot(rest, found_[k]) * found_[k];
    const double length = norm(rest);
    if (count_ < 3 && length > same_wall) found_[count_++] = (1 / length) * rest;
  }
  [[nodiscard]] bool is_corner() const { return count_ == 3; }
  [[nodiscard]] Constraint<Vec3> constraint() const {
    return count_ == 1 ? sliding(found_[0]) : sliding(found_[0], found_[1]);
  }

private:
  std::array<Vec3, 3> found_{};
  std::size_t count_ = 0;
};

Vec3 unit_normal(const TetMesh& mesh, const Triangle& t) {
  const Vec3 n = cross(mesh.x(t.v[1]) - mesh.x(t.v[0]), mesh.x(t.v[2]) - mesh.x(t.v[0]));
  return (1 / norm(n)) * n;
}

void set_slides(Boundary& boundary, const std::map<VertexId, WallNormals>& slides) {
  for (const auto& [v, normals] : slides) {
    Role& role = boundary.roles[v];
    if (role.driver != Driver::inside) continue;
    role.driver = normals.is_corner() ? Driver::wall : Driver::slide;
    if (!normals.is_corner()) boundary.sliding[v] = normals.constraint();
  }
}

// Of a vertex between two bodies, whatever the order of the triangles.
Role first_body(const Role& role, std::uint16_t body) {
  return {Driver::body, role.driver == Driver::body ? std::min(role.body, body) : body};
}

// What a vertex without a role becomes next to one that has one: of that body, or of a wall, which is also what a
// vertex between two bodies becomes.
Role grown(const Role& role, const Role& from) {
  const Role offered = from.driver == Driver::body ? from : Role{Driver::wall};
  if (role.driver == Driver::inside) return offered;
  return role == offered ? role : Role{Driver::wall};
}

std::vector<Role> with_next_layer(const std::vector<Role>& roles, const TetMesh& mesh) {
  std::vector<Role> next = roles;
  for (const Tet& t : mesh.tets) {
    if (!t.alive()) continue;
    for (const VertexId from : t.v) {
      if (roles[from].driver == Driver::inside) continue;
      for (const VertexId v : t.v)
        if (roles[v].driver == Driver::inside) next[v] = grown(next[v], roles[from]);
    }
  }
  return next;
}

}  // namespace

Boundary boundary_of(const Session& session, std::span<const int> bodies, std::span<const int> walls) {
  const TetMesh& mesh = session.mesh;
  Boundary boundary{std::vector<Role>(mesh.vertices.size()), std::vector<Constraint<Vec3>>(mesh.vertices.size())};
  std::map<VertexId, WallNormals> slides;
  for (const Triangle& t : mesh.triangles) {
    if (!t.alive()) continue;
    const int ref = session.model.patches[t.patch].ref;
    const auto body = std::ranges::find(bodies, ref);
    const bool slides_here = std::ranges::find(walls, ref) != walls.end();
    for (const VertexId v : t.v) {
      Role& role = boundary.roles[v];
      if (body != bodies.end())
        role = first_body(role, static_cast<std::uint16_t>(body - bodies.begin()));
      else if (role.driver == Driver::body)
        continue;
      else if (slides_here)
        slides[v].add(unit_normal(mesh, t));
      else
        role.driver = Driver::wall;
    }
  }
  set_slides(boundary, slides);
  return boundary;
}

// Walls grow as bodies do, so that half of what lies between two of them is left to each.
void add_shell(Boundary& boundary, const TetMesh& mesh, int layers) {
  std::vector<Role> roles = boundary.roles;
  for (int layer = 0; layer < layers; ++layer) roles = with_next_layer(roles, mesh);
  for (std::size_t v = 0; v < roles.size(); ++v)
    if (boundary.roles[v].driver == Driver::inside && roles[v].driver == Driver::body) boundary.roles[v] = roles[v];
}

}  // namespace taut
