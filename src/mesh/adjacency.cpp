#include "mesh/adjacency.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "base/buckets.hpp"
#include "base/parallel.hpp"
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

constexpr std::size_t smallest_vertices_per_task = 1024;  // each with about 24 faces

std::array<VertexId, 3> ascending(std::array<VertexId, 3> v) {
  std::sort(v.begin(), v.end());
  return v;
}

// The faces of all tetrahedra, then the triangles, by smallest vertex.
Buckets<Face> gather_faces(const TetMesh& mesh) {
  const std::size_t tets = mesh.tets.size();
  return gather<Face>(tets + mesh.triangles.size(), mesh.vertices.size(), [&](std::size_t i, auto put) {
    const auto put_face = [&](const std::array<VertexId, 3>& v, FaceLink link) { put(v[0], {v[1], v[2], link}); };
    if (i >= tets) {
      const auto t = static_cast<TriangleId>(i - tets);
      return put_face(ascending(mesh.triangles[t].v), FaceLink::to_triangle(t));
    }
    const auto t = static_cast<TetId>(i);
    for (int f = 0; f < 4; ++f) put_face(ascending(mesh.face(t, f)), FaceLink::to_face(t, f));
  });
}

// Calls visit(span of equal faces), tetrahedra before triangles, in ascending order of the faces' other vertices.
template <class Visit>
void for_each_group(std::span<Face> faces, Visit visit) {
  std::sort(faces.begin(), faces.end());
  for (auto group = faces.begin(); group != faces.end();) {
    auto next = group;
    while (next != faces.end() && next->key() == group->key()) ++next;
    visit(std::span<const Face>(group, next));
    group = next;
  }
}

class Connector {
public:
  Connector(TetMesh& mesh, const Mesh& input, const std::vector<int>& region_refs)
      : mesh_(mesh), input_(input), region_refs_(region_refs) {}

  void run() {
    auto faces = gather_faces(mesh_);
    const auto bare = collect_in_order<Sides>(
        Chunks(faces.keys(), smallest_vertices_per_task), [&](std::vector<Sides>& found, std::size_t v) {
          for_each_group(faces[v], [&](std::span<const Face> group) { join(group, found); });
        });
    const std::size_t given = mesh_.triangles.size();
    mesh_.resize_triangles(given + bare.size());
    for_each_index(bare.size(), [&](std::size_t i) { put_triangle(static_cast<TriangleId>(given + i), bare[i]); });
  }

private:
  using Sides = std::array<FaceLink, 2>;

  // Links the tetrahedra and triangles that share a face. If a triangle is missing, the face is added to `bare`.
  void join(std::span<const Face> group, std::vector<Sides>& bare) {
    std::size_t tets = 0;
    while (tets < group.size() && !group[tets].link.is_triangle()) ++tets;
    if (tets == 0) throw_no_face(group[0].link.triangle(), input_.triangles[group[0].link.triangle()]);
    if (tets > 2) throw_crowded_face(points_of(group[0].link));
    if (group.size() > tets + 1) throw_duplicate(group[tets + 1].link.triangle(), group[tets].link.triangle());
    const Sides sides = {group[0].link, tets == 2 ? group[1].link : outside};
    if (group.size() > tets)
      put_triangle(group[tets].link.triangle(), sides);
    else if (sides[1] == outside || ref(sides[0]) != ref(sides[1]))
      bare.push_back(sides);
    else
      link(sides[0], sides[1]);
  }

  [[nodiscard]] int ref(FaceLink face) const { return region_refs_[mesh_.region_of_tet[face.tet()]]; }

  std::array<Index, 3> points_of(FaceLink face) const {
    std::array<Index, 3> v = indices(mesh_.face(face.tet(), face.face()));
    for (Index& i : v) i = mesh_.origin_of_vertex[i];
    return v;
  }

  void link(FaceLink a, FaceLink b) {
    mesh_.tets[a.tet()].n[a.face()] = b;
    mesh_.tets[b.tet()].n[b.face()] = a;
  }

  // Between two tetrahedra a triangle of the input keeps its orientation; at the boundary it points outward.
  void put_triangle(TriangleId t, Sides sides) {
    Triangle& triangle = mesh_.triangles[t];
    const auto outward = mesh_.face(sides[0].tet(), sides[0].face());
    if (sides[1] == outside || !triangle.alive()) {
      if (!triangle.alive() || !same_cycle(triangle.v, outward)) triangle.v = outward;
    } else if (!same_cycle(triangle.v, outward)) {
      std::swap(sides[0], sides[1]);
    }
    triangle.side = sides;
    for (FaceLink side : triangle.side)
      if (side != outside) mesh_.tets[side.tet()].n[side.face()] = FaceLink::to_triangle(t);
  }

  TetMesh& mesh_;
  const Mesh& input_;
  const std::vector<int>& region_refs_;
};

}  // namespace

void connect(TetMesh& mesh, const Mesh& input, const std::vector<int>& region_refs) {
  Connector(mesh, input, region_refs).run();
}

}  // namespace taut
