#include "mesh/invariants.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "mesh/orientation.hpp"

namespace taut {
namespace {

using FaceVertices = std::array<VertexId, 3>;

bool opposite_cycle(const FaceVertices& a, const FaceVertices& b) {
  return same_cycle(a, FaceVertices{b[0], b[2], b[1]});
}

std::string name_of(FaceLink link) {
  if (link == outside) return "nowhere";
  if (link.is_triangle()) return fmt::format("triangle {}", link.triangle());
  return fmt::format("face {} of tetrahedron {}", link.face(), link.tet());
}

/// Each member returns the first fault that it finds, or nothing.
class Inspector {
public:
  Inspector(const TetMesh& mesh, std::span<const int> region_refs) : mesh_(mesh), region_refs_(region_refs) {}
  Inspector(const TetMesh& mesh, std::span<const TetId> among) : mesh_(mesh), among_(among) {}

  [[nodiscard]] std::string tet(TetId t) const {
    if (t >= mesh_.tets.size() || !mesh_.tets[t].alive()) return fmt::format("tetrahedron {} is dead", t);
    for (VertexId v : mesh_.tets[t].v)
      if (std::string fault = vertex(v); !fault.empty()) return fmt::format("tetrahedron {}: {}", t, fault);
    const auto& v = mesh_.tets[t].v;
    if (orientation(mesh_.x(v[0]), mesh_.x(v[1]), mesh_.x(v[2]), mesh_.x(v[3])) <= 0)
      return fmt::format("tetrahedron {} ({}) is not positive", t, fmt::join(v, " "));
    for (int f = 0; f < 4; ++f)
      if (std::string fault = face(t, f); !fault.empty())
        return fmt::format("{}: {}", name_of(FaceLink::to_face(t, f)), fault);
    return {};
  }

  [[nodiscard]] std::string vertex(VertexId v) const {
    if (v >= mesh_.vertices.size()) return fmt::format("vertex {} of {}", v, mesh_.vertices.size());
    const TetId t = mesh_.tet_of_vertex[v];
    if (t == none) return fmt::format("vertex {} is dead", v);
    if (!is_alive(t)) return fmt::format("vertex {} is said to be of the dead tetrahedron {}", v, t);
    if (!mesh_.tets[t].has(v)) return fmt::format("vertex {} is said to be of tetrahedron {}, which lacks it", v, t);
    return {};
  }

  [[nodiscard]] std::string triangle(TriangleId id) const {
    const auto& side = mesh_.triangles[id].side;
    if (side[0] == outside) return fmt::format("triangle {} has no side 0", id);
    if (side[0] == side[1]) return fmt::format("triangle {} has one face on both sides", id);
    for (int s = 0; s < 2; ++s)
      if (std::string fault = triangle_side(id, s); !fault.empty())
        return fmt::format("side {} of triangle {}: {}", s, id, fault);
    return {};
  }

private:
  [[nodiscard]] bool is_alive(TetId t) const { return t < mesh_.tets.size() && mesh_.tets[t].alive(); }

  [[nodiscard]] std::string face(TetId t, int f) const {
    const FaceLink here = FaceLink::to_face(t, f), link = mesh_.tets[t].n[f];
    if (link == outside) return "links nowhere";
    if (link.is_triangle()) {
      const TriangleId id = link.triangle();
      if (id >= mesh_.triangles.size() || !mesh_.triangles[id].alive()) return fmt::format("triangle {} is dead", id);
      const auto& side = mesh_.triangles[id].side;
      return side[0] == here || side[1] == here ? triangle(id) : fmt::format("no side of triangle {}", id);
    }
    if (!is_alive(link.tet())) return fmt::format("tetrahedron {} beyond is dead", link.tet());
    if (mesh_.tets[link.tet()].n[link.face()] != here)
      return fmt::format("{} links to {}", name_of(link), name_of(mesh_.tets[link.tet()].n[link.face()]));
    if (!opposite_cycle(mesh_.face(t, f), mesh_.face(link.tet(), link.face())))
      return fmt::format("vertices {} against {}", fmt::join(mesh_.face(t, f), " "),
                         fmt::join(mesh_.face(link.tet(), link.face()), " "));
    return may_meet(t, link.tet()) ? "" : "parts two regions without a triangle";
  }

  [[nodiscard]] bool may_meet(TetId t, TetId u) const {
    const RegionId a = mesh_.region_of_tet[t], b = mesh_.region_of_tet[u];
    if (a == b || (!among_.empty() && std::ranges::find(among_, u) == among_.end())) return true;
    return !region_refs_.empty() && region_refs_[a] == region_refs_[b];
  }

  [[nodiscard]] std::string triangle_side(TriangleId id, int s) const {
    const Triangle& triangle = mesh_.triangles[id];
    const FaceLink side = triangle.side[s];
    if (side == outside) return {};
    if (side.is_triangle() || !is_alive(side.tet())) return fmt::format("{} is no living face", name_of(side));
    if (mesh_.tets[side.tet()].n[side.face()] != FaceLink::to_triangle(id))
      return fmt::format("{} links to {}", name_of(side), name_of(mesh_.tets[side.tet()].n[side.face()]));
    const FaceVertices seen = mesh_.face(side.tet(), side.face());
    if (s == 0 ? !same_cycle(triangle.v, seen) : !opposite_cycle(triangle.v, seen))
      return fmt::format("vertices {} of the triangle, {} of {}", fmt::join(triangle.v, " "), fmt::join(seen, " "),
                         name_of(side));
    return {};
  }

  const TetMesh& mesh_;
  std::span<const int> region_refs_;  // empty: no two regions may meet
  std::span<const TetId> among_;      // tetrahedra whose regions are compared; empty: all
};

bool arrays_agree(const TetMesh& m) {
  bool agree = true;
  const auto expect = [&agree](std::size_t n) {
    return [&agree, n](const auto& array, const auto&) { agree &= array.size() == n; };
  };
  TetMesh::for_each_vertex_array(m, expect(m.vertices.size()));
  TetMesh::for_each_tet_array(m, expect(m.tets.size()));
  TetMesh::for_each_triangle_array(m, expect(m.triangles.size()));
  return agree;
}

std::string count_fault(const char* what, std::size_t found, std::size_t expected) {
  if (found == expected) return {};
  return fmt::format("{} living {}, {} by the free list", found, what, expected);
}

std::string first_wrong_count(const TetMesh& m) {
  if (!arrays_agree(m)) return "arrays of one entity differ in length";
  const auto living = [](const auto& entities) {
    return static_cast<std::size_t>(std::ranges::count_if(entities, [](const auto& e) { return e.alive(); }));
  };
  const auto vertices = m.tet_of_vertex.size() - std::ranges::count(m.tet_of_vertex, TetId{none});
  if (auto fault = count_fault("vertices", vertices, m.vertex_count()); !fault.empty()) return fault;
  if (auto fault = count_fault("tetrahedra", living(m.tets), m.tet_count()); !fault.empty()) return fault;
  return count_fault("triangles", living(m.triangles), m.triangle_count());
}

}  // namespace

std::string first_broken_invariant(const TetMesh& mesh, std::span<const int> region_refs) {
  if (std::string fault = first_wrong_count(mesh); !fault.empty()) return fault;
  const Inspector inspect(mesh, region_refs);
  for (const VertexId v : mesh.vertex_ids())
    if (mesh.is_vertex_alive(v))
      if (std::string fault = inspect.vertex(v); !fault.empty()) return fault;
  for (const TriangleId t : mesh.triangle_ids())
    if (mesh.triangles[t].alive())
      if (std::string fault = inspect.triangle(t); !fault.empty()) return fault;
  for (const TetId t : mesh.tet_ids())
    if (mesh.tets[t].alive())
      if (std::string fault = inspect.tet(t); !fault.empty()) return fault;
  return {};
}

std::string first_broken_invariant(const TetMesh& mesh, std::span<const TetId> tets) {
  const Inspector inspect(mesh, tets);
  for (TetId t : tets)
    if (std::string fault = inspect.tet(t); !fault.empty()) return fault;
  return {};
}

}  // namespace taut
