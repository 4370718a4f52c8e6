#include "mesh/adjacency.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "mesh/door.hpp"

namespace taut {
namespace {

// A face of a tetrahedron or a triangle, kept in the bucket of its smallest vertex.
struct Face {
  VertexId middle, largest;
  FaceLink link;
  [[nodiscard]] std::uint64_t key() const { return (std::uint64_t{middle} << 32) | largest; }
  [[nodiscard]] bool operator<(const Face& other) const {
    return key() != other.key() ? key() < other.key() : link.bits() < other.link.bits();
  }
};

std::array<VertexId, 3> ascending(std::array<VertexId, 3> v) {
  std::sort(v.begin(), v.end());
  return v;
}

class FaceTable {
public:
  explicit FaceTable(const TetMesh& mesh) : start_(mesh.vertices.size() + 1, 0) {
    each_face(mesh, [&](const auto& v, FaceLink) { ++start_[v[0] + 1]; });
    for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
    faces_.resize(start_.back());
    auto fill = start_;
    each_face(mesh, [&](const auto& v, FaceLink link) { faces_[fill[v[0]]++] = {v[1], v[2], link}; });
  }

  // Calls visit(span of equal faces), tetrahedra before triangles, in ascending order of the faces' vertices.
  template <class Visit>
  void each_group(Visit visit) {
    for (std::size_t v = 0; v + 1 < start_.size(); ++v) {
      const auto begin = faces_.begin() + start_[v], end = faces_.begin() + start_[v + 1];
      std::sort(begin, end);
      for (auto group = begin; group != end;) {
        auto next = group;
        while (next != end && next->key() == group->key()) ++next;
        visit(std::span<const Face>(group, next));
        group = next;
      }
    }
  }

private:
  template <class Visit>
  static void each_face(const TetMesh& mesh, Visit visit) {
    for (TetId t = 0; t < mesh.tets.size(); ++t)
      for (int f = 0; f < 4; ++f) visit(ascending(mesh.face(t, f)), FaceLink::to_face(t, f));
    for (TriangleId t = 0; t < mesh.triangles.size(); ++t)
      visit(ascending(mesh.triangles[t].v), FaceLink::to_triangle(t));
  }

  std::vector<std::uint32_t> start_;
  std::vector<Face> faces_;
};

bool same_cycle(const std::array<VertexId, 3>& a, const std::array<VertexId, 3>& b) {
  return (a[0] == b[0] && a[1] == b[1]) || (a[0] == b[1] && a[1] == b[2]) || (a[0] == b[2] && a[1] == b[0]);
}

class Connector {
public:
  Connector(TetMesh& mesh, const Mesh& input, const std::vector<int>& region_refs)
      : mesh_(mesh), input_(input), region_refs_(region_refs) {}

  void operator()(std::span<const Face> group) {
    std::size_t tets = 0;
    while (tets < group.size() && !group[tets].link.is_triangle()) ++tets;
    if (tets == 0) throw_no_face(group[0].link.triangle(), input_.triangles[group[0].link.triangle()]);
    if (tets > 2) throw_crowded_face(points_of(group[0].link));
    if (group.size() > tets + 1) throw_duplicate(group[tets + 1].link.triangle(), group[tets].link.triangle());
    const FaceLink first = group[0].link, second = tets == 2 ? group[1].link : outside;
    if (group.size() > tets)
      put_triangle(group[tets].link.triangle(), first, second);
    else if (second == outside || ref(first) != ref(second))
      put_triangle(mesh_.add_triangle(), first, second);
    else
      link(first, second);
  }

private:
  [[nodiscard]] int ref(FaceLink face) const { return region_refs_[mesh_.region_of_tet[face.tet()]]; }

  std::array<Index, 3> points_of(FaceLink face) const {
    std::array<Index, 3> v = mesh_.face(face.tet(), face.face());
    for (Index& i : v) i = mesh_.origin_of_vertex[i];
    return v;
  }

  void link(FaceLink a, FaceLink b) {
    mesh_.tets[a.tet()].n[a.face()] = b;
    mesh_.tets[b.tet()].n[b.face()] = a;
  }

  // Between two tetrahedra a triangle of the input keeps its orientation; at the boundary it points outward.
  void put_triangle(TriangleId t, FaceLink first, FaceLink second) {
    Triangle& triangle = mesh_.triangles[t];
    const auto outward = mesh_.face(first.tet(), first.face());
    if (second == outside || !triangle.alive()) {
      if (!triangle.alive() || !same_cycle(triangle.v, outward)) triangle.v = outward;
    } else if (!same_cycle(triangle.v, outward)) {
      std::swap(first, second);
    }
    triangle.side = {first, second};
    for (FaceLink side : triangle.side)
      if (side != outside) mesh_.tets[side.tet()].n[side.face()] = FaceLink::to_triangle(t);
  }

  TetMesh& mesh_;
  const Mesh& input_;
  const std::vector<int>& region_refs_;
};

}  // namespace

void connect(TetMesh& mesh, const Mesh& input, const std::vector<int>& region_refs) {
  FaceTable(mesh).each_group(Connector(mesh, input, region_refs));
}

}  // namespace taut
