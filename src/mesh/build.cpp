#include "mesh/build.hpp"

#include <algorithm>
#include <utility>

#include "mesh/adjacency.hpp"
#include "mesh/door.hpp"
#include "mesh/hilbert.hpp"
#include "mesh/order.hpp"
#include "mesh/orientation.hpp"

namespace taut {
namespace {

void number_vertices(const Mesh& input, Built& built) {
  std::vector<std::uint8_t> used(input.points.size(), 0);
  for (const auto& tet : input.tetrahedra)
    for (Index v : tet) used[v] = 1;
  built.vertex_of_point.assign(input.points.size(), none);
  TetMesh& mesh = built.mesh;
  for (Index i = 0; i < input.points.size(); ++i) {
    if (used[i] == 0) continue;
    const VertexId v = mesh.add_vertex({input.points[i], {}}, {}, none);
    mesh.origin_of_vertex[v] = i;
    built.vertex_of_point[i] = v;
  }
}

// Regions are numbered by ascending reference; required tetrahedra are a frozen region of their own.
void number_regions(const Mesh& input, Built& built) {
  std::vector<std::pair<int, std::uint8_t>> key(input.tetrahedra.size(), {0, 0});
  for (std::size_t t = 0; t < input.tetrahedron_refs.size(); ++t) key[t].first = input.tetrahedron_refs[t];
  for (Index t : input.required_tetrahedra) key[t].second = 1;
  auto regions = key;
  std::sort(regions.begin(), regions.end());
  regions.erase(std::unique(regions.begin(), regions.end()), regions.end());
  require_region_count(regions.size());
  for (const auto& [ref, required] : regions) {
    built.region_refs.push_back(ref);
    built.region_required.push_back(required);
  }
  built.mesh.region_of_tet.resize(key.size());
  for (std::size_t t = 0; t < key.size(); ++t) {
    const auto at = std::lower_bound(regions.begin(), regions.end(), key[t]);
    built.mesh.region_of_tet[t] = static_cast<RegionId>(at - regions.begin());
  }
}

void add_tets(const Mesh& input, Built& built) {
  TetMesh& mesh = built.mesh;
  mesh.tets.resize(input.tetrahedra.size());
  for (std::size_t t = 0; t < input.tetrahedra.size(); ++t) {
    const auto& v = input.tetrahedra[t];
    Tet& tet = mesh.tets[t];
    for (int k = 0; k < 4; ++k) tet.v[k] = built.vertex_of_point[v[k]];
    const int sign = orientation(input.points[v[0]], input.points[v[1]], input.points[v[2]], input.points[v[3]]);
    if (sign == 0) throw_flat(t, v);
    if (sign > 0) continue;
    std::swap(tet.v[2], tet.v[3]);
    ++built.reoriented;
  }
  for (TetId t = 0; t < mesh.tets.size(); ++t)
    for (VertexId v : mesh.tets[t].v) mesh.tet_of_vertex[v] = t;
}

void add_triangles(const Mesh& input, Built& built) {
  auto& triangles = built.mesh.triangles;
  triangles.resize(input.triangles.size());
  built.triangle_refs.assign(input.triangles.size(), 0);
  for (std::size_t i = 0; i < input.triangles.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      triangles[i].v[k] = built.vertex_of_point[input.triangles[i][k]];
      if (triangles[i].v[k] == none) throw_no_face(i, input.triangles[i]);
    }
    if (!input.triangle_refs.empty()) built.triangle_refs[i] = input.triangle_refs[i];
  }
  connect(built.mesh, input, built.region_refs);
  built.triangles_built = triangles.size() - input.triangles.size();
  built.triangle_refs.resize(triangles.size(), 0);
}

// reorder() moves the triangles: their patch, still unused, carries their old number along.
void order(const Mesh& input, Built& built) {
  TetMesh& mesh = built.mesh;
  for (TriangleId t = 0; t < mesh.triangles.size(); ++t) mesh.triangles[t].patch = t;
  reorder(mesh);
  for (VertexId v = 0; v < mesh.vertices.size(); ++v) built.vertex_of_point[mesh.origin_of_vertex[v]] = v;
  built.triangle_of_input.resize(input.triangles.size());
  std::vector<int> refs(mesh.triangles.size());
  for (TriangleId t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t old = mesh.triangles[t].patch;
    refs[t] = built.triangle_refs[old];
    if (old < input.triangles.size()) built.triangle_of_input[old] = t;
  }
  built.triangle_refs.swap(refs);
}

}  // namespace

Built build(const Mesh& input) {
  require_sound_arrays(input);
  Built built;
  number_vertices(input, built);
  number_regions(input, built);
  add_tets(input, built);
  add_triangles(input, built);
  order(input, built);
  return built;
}

}  // namespace taut
