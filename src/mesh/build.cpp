#include "mesh/build.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "base/parallel.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/door.hpp"
#include "mesh/incidence.hpp"
#include "mesh/order.hpp"
#include "mesh/orientation.hpp"

namespace taut {
namespace {

void add_vertices(const Mesh& input, Built& built) {
  const auto tet_of_point = last_tet_of_points(input.tetrahedra, input.points.size());
  const auto used = indices_where(input.points.size(), [&](std::size_t p) { return tet_of_point[p] != none; });
  built.vertex_of_point.assign(input.points.size(), none);
  TetMesh& mesh = built.mesh;
  mesh.resize_vertices(used.size());
  for_each_index(used.size(), [&](std::size_t i) {
    const auto v = static_cast<VertexId>(i);
    mesh.put_vertex(v, {input.points[used[i]], {}}, {}, none);
    mesh.tet_of_vertex[v] = tet_of_point[used[i]];
    mesh.origin_of_vertex[v] = used[i];
    built.vertex_of_point[used[i]] = v;
  });
}

using RegionKey = std::pair<int, std::uint8_t>;  // reference, and whether required

struct RegionKeys {
  std::set<RegionKey> found;
  RegionKeys& operator+=(const RegionKeys& other) {
    found.insert(other.found.begin(), other.found.end());
    return *this;
  }
};

// Regions are numbered by ascending reference; required tetrahedra are a frozen region of their own.
void number_regions(const Mesh& input, Built& built) {
  std::vector<RegionKey> key(input.tetrahedra.size(), {0, 0});
  for_each_index(input.tetrahedron_refs.size(), [&](std::size_t t) { key[t].first = input.tetrahedron_refs[t]; });
  for (Index t : input.required_tetrahedra) key[t].second = 1;
  const auto add = [&](RegionKeys& keys, std::size_t t) { keys.found.insert(key[t]); };
  const std::set<RegionKey> regions = sum_in_order<RegionKeys>(key.size(), add).found;
  require_region_count(regions.size());
  for (const auto& [ref, required] : regions) {
    built.region_refs.push_back(ref);
    built.region_required.push_back(required);
  }
  const std::vector<RegionKey> sorted(regions.begin(), regions.end());
  for_each_index(key.size(), [&](std::size_t t) {
    const auto at = std::lower_bound(sorted.begin(), sorted.end(), key[t]);
    built.mesh.region_of_tet[t] = static_cast<RegionId>(at - sorted.begin());
  });
}

void add_tets(const Mesh& input, Built& built) {
  TetMesh& mesh = built.mesh;
  built.reoriented = sum_in_order<std::size_t>(mesh.tets.size(), [&](std::size_t& reoriented, std::size_t t) {
    const auto& v = input.tetrahedra[t];
    Tet& tet = mesh.tets[t];
    for (int k = 0; k < 4; ++k) tet.v[k] = built.vertex_of_point[v[k]];
    const int sign = orientation(input.points[v[0]], input.points[v[1]], input.points[v[2]], input.points[v[3]]);
    if (sign == 0) throw_flat(t, v);
    if (sign > 0) return;
    std::swap(tet.v[2], tet.v[3]);
    ++reoriented;
  });
}

void add_triangles(const Mesh& input, Built& built) {
  auto& triangles = built.mesh.triangles;
  built.mesh.resize_triangles(input.triangles.size());
  for_each_index(input.triangles.size(), [&](std::size_t i) {
    for (int k = 0; k < 3; ++k) {
      triangles[i].v[k] = built.vertex_of_point[input.triangles[i][k]];
      if (triangles[i].v[k] == none) throw_no_face(i, input.triangles[i]);
    }
  });
  connect(built.mesh, input, built.region_refs);
  built.triangles_built = triangles.size() - input.triangles.size();
  built.triangle_refs = input.triangle_refs;
  built.triangle_refs.resize(triangles.size(), 0);
}

// Two positive tetrahedra that see their common face in the same sense lie on the same side of it. Turning single
// tetrahedra round repairs mixed orientations, but not vertices that lie in the wrong place.
void require_no_overlap(const Mesh& input, const TetMesh& mesh) {
  for_each_index(mesh.tets.size(), [&](std::size_t i) {
    const auto t = static_cast<TetId>(i);
    for (int f = 0; f < 4; ++f) {
      const FaceLink other = mesh.beyond(t, f);
      if (other != outside && same_cycle(mesh.face(t, f), mesh.face(other.tet(), other.face())))
        throw_overlap(t, input.tetrahedra[t], other.tet(), input.tetrahedra[other.tet()]);
    }
  });
}

void order(const Mesh& input, Built& built) {
  TetMesh& mesh = built.mesh;
  Renumbering map = reorder(mesh);
  for_each_index(mesh.vertices.size(),
                 [&](std::size_t v) { built.vertex_of_point[mesh.origin_of_vertex[v]] = static_cast<VertexId>(v); });
  std::vector<int> refs(mesh.triangles.size());
  for_each_index(refs.size(), [&](std::size_t old) { refs[map.triangle[old]] = built.triangle_refs[old]; });
  built.triangle_refs.swap(refs);
  map.triangle.resize(input.triangles.size());
  built.triangle_of_input = std::move(map.triangle);
  built.tet_of_input = std::move(map.tet);
}

}  // namespace

Built build(const Mesh& input) {
  require_sound_arrays(input);
  Built built;
  add_vertices(input, built);
  built.mesh.resize_tets(input.tetrahedra.size());
  number_regions(input, built);
  add_tets(input, built);
  add_triangles(input, built);
  require_no_overlap(input, built.mesh);
  order(input, built);
  return built;
}

}  // namespace taut
