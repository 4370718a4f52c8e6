#include "adapt/result.hpp"

#include <algorithm>

#include "adapt/hash.hpp"
#include "base/parallel.hpp"
#include "surface/surface_edges.hpp"

namespace taut {
namespace {

void assemble_vertices(const Session& session, const Mesh& input, AdaptResult& result) {
  const TetMesh& work = session.mesh;
  result.mesh.points.resize(work.vertices.size());
  result.mesh.point_refs.resize(work.vertices.size());
  result.metric.resize(work.vertices.size());
  result.new_of_old.assign(input.points.size(), AdaptResult::gone);
  for_each_index(work.vertices.size(), [&](std::size_t v) {
    result.mesh.points[v] = work.vertices[v].x;
    result.metric[v] = work.vertices[v].m;
    const std::uint32_t origin = work.origin_of_vertex[v];
    if (origin == none) return;
    if (!input.point_refs.empty()) result.mesh.point_refs[v] = input.point_refs[origin];
    result.new_of_old[origin] = static_cast<Index>(v);
  });
  const auto keep = [&](const std::vector<Index>& marks, std::vector<Index>& kept) {
    for (Index p : marks)
      if (result.new_of_old[p] != AdaptResult::gone) kept.push_back(result.new_of_old[p]);
  };
  keep(input.corners, result.mesh.corners);
  keep(input.required_points, result.mesh.required_points);
}

// The weights of the cell's vertices go to the points of the input's tetrahedron in its own order: one that was
// inverted has been turned round since.
void assemble_hosts(const Session& session, const Mesh& input, std::vector<Host>& hosts) {
  const TetMesh& work = session.mesh;
  hosts.resize(work.vertices.size());
  for_each_index(hosts.size(), [&](std::size_t v) {
    CellId cell = work.host_of_vertex[v];
    const Weights weights = session.background->locate(work.vertices[v].x, cell);
    const auto& vertices = session.background->vertices_of(cell);
    const std::uint32_t tet = session.tet_of_cell[cell];
    hosts[v].tetrahedron = tet;
    for (std::size_t k = 0; k < 4; ++k) {
      const VertexId wanted = session.vertex_of_point[input.tetrahedra[tet][k]];
      hosts[v].weights[k] = weights[static_cast<std::size_t>(std::ranges::find(vertices, wanted) - vertices.begin())];
    }
  });
}

void assemble_tets(const Session& session, Mesh& mesh) {
  const TetMesh& work = session.mesh;
  const auto region_of = [&](std::size_t t) -> const Region& { return session.model.regions[work.region_of_tet[t]]; };
  mesh.tetrahedra.resize(work.tets.size());
  mesh.tetrahedron_refs.resize(work.tets.size());
  for_each_index(work.tets.size(), [&](std::size_t t) {
    mesh.tetrahedra[t] = indices(work.tets[t].v);
    mesh.tetrahedron_refs[t] = region_of(t).ref;
  });
  mesh.required_tetrahedra = indices_where(work.tets.size(), [&](std::size_t t) { return region_of(t).required; });
}

void assemble_triangles(const Session& session, Mesh& mesh) {
  const auto& triangles = session.mesh.triangles;
  const auto patch_of = [&](std::size_t t) -> const Patch& { return session.model.patches[triangles[t].patch]; };
  mesh.triangles.resize(triangles.size());
  mesh.triangle_refs.resize(triangles.size());
  for_each_index(triangles.size(), [&](std::size_t t) {
    mesh.triangles[t] = indices(triangles[t].v);
    mesh.triangle_refs[t] = patch_of(t).ref;
  });
  mesh.required_triangles = indices_where(triangles.size(), [&](std::size_t t) { return patch_of(t).required; });
}

void add_edge(Mesh& mesh, const std::array<Index, 2>& edge, int ref, bool sharp, bool required) {
  const auto e = static_cast<Index>(mesh.edges.size());
  if (sharp) mesh.ridges.push_back(e);
  if (required) mesh.required_edges.push_back(e);
  mesh.edges.push_back(edge);
  mesh.edge_refs.push_back(ref);
}

void assemble_edges(const Session& session, AdaptResult& result) {
  for_each_edge(edge_uses(corners_of(session.mesh.triangles)), [&](std::span<const EdgeUse> uses) {
    const LineId id = session.mesh.triangles[uses[0].triangle].line[uses[0].corner];
    if (id == none) return;
    const Line& line = session.model.lines[id];
    if (!line.implicit) add_edge(result.mesh, indices(uses[0].edge), line.ref, line.sharp, line.required);
  });
  for (const InnerEdge& e : session.model.inner_edges) {
    const std::array<Index, 2> edge = {result.new_of_old[e.points[0]], result.new_of_old[e.points[1]]};
    add_edge(result.mesh, edge, e.ref, e.sharp, e.required);
  }
}

}  // namespace

void assemble_mesh(const Session& session, const Mesh& input, AdaptResult& result) {
  assemble_vertices(session, input, result);
  assemble_tets(session, result.mesh);
  assemble_triangles(session, result.mesh);
  assemble_edges(session, result);
}

void assemble(Session session, const Mesh& input, AdaptResult& result) {
  session.target.reset();
  assemble_hosts(session, input, result.hosts);
  session.background.reset();  // as large as the mesh: its memory is the result's now
  assemble_mesh(session, input, result);
  result.report.hash = hash_of(result.mesh, result.metric);
  result.report.quality = measure(result.mesh, Metric{result.metric});
}

}  // namespace taut
