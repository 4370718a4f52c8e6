#include "adapt/result.hpp"

#include <bit>

#include "geometry/surface_edges.hpp"

namespace taut {
namespace {

class Fnv1a {
public:
  void mix(std::uint64_t word) { hash_ = (hash_ ^ word) * 1099511628211U; }
  [[nodiscard]] std::uint64_t value() const { return hash_; }

private:
  std::uint64_t hash_ = 14695981039346656037U;
};

std::uint64_t hash_of(const Mesh& mesh) {
  Fnv1a hash;
  for (const Point& p : mesh.points)
    for (double x : p) hash.mix(std::bit_cast<std::uint64_t>(x));
  for (const auto& t : mesh.tetrahedra)
    for (Index v : t) hash.mix(v);
  for (const auto& t : mesh.triangles)
    for (Index v : t) hash.mix(v);
  return hash.value();
}

void assemble_vertices(const Problem& problem, const Mesh& input, AdaptResult& result) {
  const TetMesh& work = problem.mesh;
  result.new_of_old.assign(input.points.size(), AdaptResult::gone);
  for (VertexId v = 0; v < work.vertices.size(); ++v) {
    result.mesh.points.push_back(work.x(v));
    result.metric.push_back(work.vertices[v].m);
    const std::uint32_t origin = work.origin_of_vertex[v];
    result.mesh.point_refs.push_back(origin == none || input.point_refs.empty() ? 0 : input.point_refs[origin]);
    if (origin != none) result.new_of_old[origin] = v;
  }
  const auto keep = [&](const std::vector<Index>& marks, std::vector<Index>& kept) {
    for (Index p : marks)
      if (result.new_of_old[p] != AdaptResult::gone) kept.push_back(result.new_of_old[p]);
  };
  keep(input.corners, result.mesh.corners);
  keep(input.required_points, result.mesh.required_points);
}

void assemble_tets(const Problem& problem, AdaptResult& result) {
  const TetMesh& work = problem.mesh;
  for (TetId t = 0; t < work.tets.size(); ++t) {
    const Region& region = problem.model.regions[work.region_of_tet[t]];
    if (region.required) result.mesh.required_tetrahedra.push_back(t);
    result.mesh.tetrahedra.push_back(work.tets[t].v);
    result.mesh.tetrahedron_refs.push_back(region.ref);
  }
}

void assemble_triangles(const Problem& problem, AdaptResult& result) {
  for (const Triangle& t : problem.mesh.triangles) {
    const Patch& patch = problem.model.patches[t.patch];
    if (patch.required) result.mesh.required_triangles.push_back(static_cast<Index>(result.mesh.triangles.size()));
    result.mesh.triangles.push_back(t.v);
    result.mesh.triangle_refs.push_back(patch.ref);
  }
}

void add_edge(Mesh& mesh, const std::array<VertexId, 2>& edge, int ref, bool sharp, bool required) {
  const auto e = static_cast<Index>(mesh.edges.size());
  if (sharp) mesh.ridges.push_back(e);
  if (required) mesh.required_edges.push_back(e);
  mesh.edges.push_back(edge);
  mesh.edge_refs.push_back(ref);
}

void assemble_edges(const Problem& problem, AdaptResult& result) {
  for_each_edge(edge_uses(problem.mesh.triangles), [&](std::span<const EdgeUse> uses) {
    const LineId id = problem.mesh.triangles[uses[0].triangle].line[uses[0].corner];
    if (id == none) return;
    const Line& line = problem.model.lines[id];
    if (!line.implicit) add_edge(result.mesh, uses[0].edge, line.ref, line.sharp, line.required);
  });
  for (const InnerEdge& e : problem.model.inner_edges) {
    const std::array<VertexId, 2> edge = {result.new_of_old[e.points[0]], result.new_of_old[e.points[1]]};
    add_edge(result.mesh, edge, e.ref, e.sharp, e.required);
  }
}

}  // namespace

void assemble(const Problem& problem, const Mesh& input, AdaptResult& result) {
  assemble_vertices(problem, input, result);
  assemble_tets(problem, result);
  assemble_triangles(problem, result);
  assemble_edges(problem, result);
  result.report.hash = hash_of(result.mesh);
  result.report.quality = measure(result.mesh, Metric{result.metric});
}

}  // namespace taut
