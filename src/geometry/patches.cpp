#include "geometry/patches.hpp"

#include <algorithm>
#include <cmath>

#include "base/disjoint_sets.hpp"
#include "surface/facets.hpp"

namespace taut {
namespace {

// For each triangle the first one of its patch.
std::vector<TriangleId> roots(std::size_t triangles, const std::vector<EdgeUse>& uses_of_edges,
                              std::span<const Feature> features) {
  DisjointSets sets(triangles);
  for_each_smooth_edge(uses_of_edges, features,
                       [&](const EdgeUse& s, const EdgeUse& t) { sets.join(s.triangle, t.triangle); });
  std::vector<TriangleId> root;
  for (const TriangleId t : ids<TriangleId>(triangles)) root.push_back(TriangleId{sets.root(t)});
  return root;
}

// A plane perpendicular to an axis keeps its coordinate exactly, so that rounding never moves vertices off the plane.
void snap_to_axis(Vec3& normal) {
  for (int d = 0; d < 3; ++d) {
    if (std::fabs(normal[d]) < 1 - 1e-15) continue;
    const double sign = normal[d] > 0 ? 1 : -1;
    normal = {};
    normal[d] = sign;
    return;
  }
}

// The plane of the largest triangle of each patch.
std::vector<Plane> fitted_planes(const TetMesh& mesh, std::size_t patches) {
  std::vector<Plane> planes(patches);
  std::vector<double> largest(patches, -1);
  for (const Triangle& t : mesh.triangles) {
    const Vec3 normal = cross(mesh.x(t.v[1]) - mesh.x(t.v[0]), mesh.x(t.v[2]) - mesh.x(t.v[0]));
    const double area = norm(normal);
    if (area <= largest[t.patch]) continue;
    largest[t.patch] = area;
    Plane& plane = planes[t.patch];
    plane.normal = (1 / area) * normal;
    snap_to_axis(plane.normal);
    plane.offset = dot(plane.normal, mesh.x(t.v[0]));
  }
  return planes;
}

}  // namespace

double flatness_tolerance(const TetMesh& mesh) {
  Vec3 low = mesh.vertices[0].x, high = low;
  for (const Vertex& v : mesh.vertices)
    for (int d = 0; d < 3; ++d) low[d] = std::min(low[d], v.x[d]), high[d] = std::max(high[d], v.x[d]);
  return flatness * norm(high - low);
}

std::vector<Patch> group_patches(TetMesh& mesh, const std::vector<EdgeUse>& uses, std::span<const Feature> features,
                                 std::span<const int> refs, std::span<const std::uint8_t> required) {
  const std::vector<TriangleId> root = roots(mesh.triangles.size(), uses, features);
  std::vector<Patch> patches;
  for (const TriangleId t : mesh.triangle_ids()) {
    if (root[t] != t) {
      mesh.triangles[t].patch = mesh.triangles[root[t]].patch;
      continue;
    }
    mesh.triangles[t].patch = static_cast<PatchId>(patches.size());
    patches.push_back({.ref = refs[t], .required = required[t] != 0});
  }
  return patches;
}

void find_shapes(const TetMesh& mesh, std::vector<Patch>& patches, double tolerance) {
  const std::vector<Plane> planes = fitted_planes(mesh, patches.size());
  std::vector<std::uint8_t> planar(patches.size(), 1);
  for (const Triangle& t : mesh.triangles) {
    const Plane& plane = planes[t.patch];
    for (VertexId v : t.v)
      if (std::fabs(dot(plane.normal, mesh.x(v)) - plane.offset) > tolerance) planar[t.patch] = 0;
  }
  for (std::size_t p = 0; p < patches.size(); ++p) {
    patches[p].shape = Frozen{};
    if (planar[p] != 0 && !patches[p].required) patches[p].shape = planes[p];
  }
}

}  // namespace taut
