#include "surface/surface_input.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mesh/build.hpp"
#include "mesh/door.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

std::vector<Corners> given_triangles(const Mesh& mesh) {
  std::vector<Corners> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) triangles.push_back({VertexId{a}, VertexId{b}, VertexId{c}});
  return triangles;
}

/// An edge without length has no direction.
void require_extent(const Mesh& mesh) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      if (mesh.points[a] == mesh.points[b])
        throw InputError(fmt::format("triangle {}: vertices {} and {} lie at one place", t + 1, a + 1, b + 1));
    }
}

/// In the caller's numbers.
Corners seen_outside(const TetMesh& mesh, TriangleId t) {
  Corners corners = mesh.triangles[t].v;
  for (VertexId& v : corners) v = VertexId{mesh.origin_of_vertex[v]};
  return corners;
}

void add_triangles_of_volume(const Mesh& mesh, SurfaceInput& input) {
  const Built built = build(mesh);
  std::vector<std::uint8_t> is_given(built.mesh.triangles.size(), 0);
  for (std::size_t i = 0; i < built.triangle_of_input.size(); ++i) {
    const TriangleId t = built.triangle_of_input[i];
    is_given[t] = 1;
    input.facets.triangles[i] = seen_outside(built.mesh, t);
  }
  for (const TriangleId t : built.mesh.triangle_ids())
    if (is_given[t] == 0) input.facets.triangles.push_back(seen_outside(built.mesh, t));
}

std::vector<GivenEdge> given_edges_of(const Mesh& mesh, std::span<const VertexId> vertex_of_point) {
  std::vector<GivenEdge> edges;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const auto [a, b] = std::minmax({vertex_of_point[mesh.edges[e][0]], vertex_of_point[mesh.edges[e][1]]});
    edges.push_back({{a, b}, mesh.edge_refs.empty() ? 0 : mesh.edge_refs[e]});
  }
  // A required edge is kept as an edge, which says nothing of the surface there.
  for (const Index e : mesh.ridges) edges[e].sharp = true;
  // A sharp one comes first, and of several equal ones the first stays.
  std::stable_sort(edges.begin(), edges.end(), [](const GivenEdge& a, const GivenEdge& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.sharp && !b.sharp;
  });
  edges.erase(
      std::unique(edges.begin(), edges.end(), [](const GivenEdge& a, const GivenEdge& b) { return a.edge == b.edge; }),
      edges.end());
  return edges;
}

}  // namespace

SurfaceInput surface_of(const Mesh& mesh) {
  if (mesh.tetrahedra.empty() && mesh.triangles.empty())
    throw InputError("the mesh has neither tetrahedra nor triangles, expected a surface");
  require_sound_entities(mesh);
  require_extent(mesh);
  std::vector<VertexId> same(mesh.points.size());
  for (const VertexId v : ids<VertexId>(same.size())) same[v] = v;
  SurfaceInput input = with_marks({{mesh.points, given_triangles(mesh)}, mesh.triangle_refs, {}, {}}, mesh, same);
  if (!mesh.tetrahedra.empty()) add_triangles_of_volume(mesh, input);
  input.refs.resize(input.facets.triangles.size(), 0);
  return input;
}

SurfaceInput with_marks(SurfaceInput input, const Mesh& mesh, std::span<const VertexId> vertex_of_point) {
  input.edges = given_edges_of(mesh, vertex_of_point);
  input.is_corner.assign(input.facets.points.size(), 0);
  for (const auto* marks : {&mesh.corners, &mesh.required_points})
    for (const Index p : *marks)
      if (vertex_of_point[p] != none) input.is_corner[vertex_of_point[p]] = 1;
  return input;
}

}  // namespace taut
