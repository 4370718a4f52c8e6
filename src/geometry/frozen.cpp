#include "geometry/frozen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "taut/error.hpp"

namespace taut {
namespace {

RegionId frozen_twin(std::vector<Region>& regions, RegionId region) {
  if (regions[region].frozen) return region;
  for (std::size_t r = 0; r < regions.size(); ++r)
    if (regions[r].frozen && !regions[r].required && regions[r].ref == regions[region].ref)
      return static_cast<RegionId>(r);
  regions.push_back({regions[region].ref, true, false});
  return static_cast<RegionId>(regions.size() - 1);
}

void freeze_shell(TetMesh& mesh, const std::array<VertexId, 2>& edge, std::vector<Region>& regions) {
  bool found = false;
  for (const TetId t : mesh.tet_ids()) {
    if (!mesh.tets[t].has(edge[0]) || !mesh.tets[t].has(edge[1])) continue;
    found = true;
    mesh.region_of_tet[t] = frozen_twin(regions, mesh.region_of_tet[t]);
  }
  if (!found)
    throw InputError(fmt::format("edge ({} {}) is not an edge of any tetrahedron", mesh.origin_of_vertex[edge[0]] + 1,
                                 mesh.origin_of_vertex[edge[1]] + 1));
}

// If parts of the mesh touch at an edge, more than two of its triangles bound the domain, and a shell would contain
// only one part.
bool is_pinched(const TetMesh& mesh, const Feature& f) {
  return std::ranges::count_if(f.uses,
                               [&](const EdgeUse& use) { return mesh.triangles[use.triangle].side[1] == outside; }) > 2;
}

// The number of tetrahedra at v that can be reached from one of them without leaving v.
std::size_t connected_degree(const TetMesh& mesh, VertexId v) {
  std::vector<TetId> reached{mesh.tet_of_vertex[v]};
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const TetId t = reached[i];
    for (int f = 0; f < 4; ++f) {
      const FaceLink link = mesh.tets[t].v[f] == v ? outside : mesh.beyond(t, f);
      if (link != outside && std::ranges::find(reached, link.tet()) == reached.end()) reached.push_back(link.tet());
    }
  }
  return reached.size();
}

// If parts of the mesh touch only at a vertex, a walk around the vertex would find only one part.
void fix_pinched_vertices(const TetMesh& mesh, std::vector<std::uint8_t>& fixed) {
  std::vector<std::uint32_t> degree(mesh.vertices.size(), 0);
  for (const Tet& tet : mesh.tets)
    for (VertexId v : tet.v) ++degree[v];
  std::vector<std::uint8_t> seen(mesh.vertices.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    if (t.side[1] != outside) continue;
    for (VertexId v : t.v) {
      if (std::exchange(seen[v], 1) != 0 || fixed[v] != 0) continue;
      if (connected_degree(mesh, v) != degree[v]) fixed[v] = 1;
    }
  }
}

}  // namespace

std::vector<Region> find_regions(Built& built, std::span<const Feature> inner_edges) {
  std::vector<Region> regions;
  for (std::size_t r = 0; r < built.region_refs.size(); ++r)
    regions.push_back({built.region_refs[r], built.region_required[r] != 0, built.region_required[r] != 0});
  for (const Feature& feature : inner_edges) freeze_shell(built.mesh, feature.edge, regions);
  return regions;
}

bool stays(const TetMesh& mesh, const Feature& feature) {
  return feature.required || is_pinched(mesh, feature);
}

std::vector<std::uint8_t> find_fixed_vertices(const Mesh& input, const Built& built, const Model& model,
                                              const Features& features) {
  const TetMesh& mesh = built.mesh;
  std::vector<std::uint8_t> fixed(mesh.vertices.size(), 0);
  const auto fix = [&](const auto& vertices) {
    for (VertexId v : vertices) fixed[v] = 1;
  };
  for (const auto* points : {&input.corners, &input.required_points})
    for (Index p : *points)
      if (built.vertex_of_point[p] != none) fixed[built.vertex_of_point[p]] = 1;
  for (const Feature& f : features.inner) fix(f.edge);
  for (const TetId t : mesh.tet_ids())
    if (model.regions[mesh.region_of_tet[t]].frozen) fix(mesh.tets[t].v);
  for (const Triangle& t : mesh.triangles)
    if (model.patches[t.patch].frozen()) fix(t.v);
  for (const Feature& f : features.surface)
    if (stays(mesh, f)) fix(f.edge);
  fix_pinched_vertices(mesh, fixed);
  return fixed;
}

}  // namespace taut
