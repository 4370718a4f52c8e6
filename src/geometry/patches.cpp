#include "geometry/patches.hpp"

#include <algorithm>
#include <array>

#include "base/box.hpp"
#include "base/disjoint_sets.hpp"
#include "geometry/largest_plane.hpp"
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

std::array<Vec3, 3> corners_of(const TetMesh& mesh, const Triangle& t) {
  return {mesh.x(t.v[0]), mesh.x(t.v[1]), mesh.x(t.v[2])};
}

}  // namespace

double flatness_tolerance(const TetMesh& mesh) {
  Box box;
  for (const Vertex& v : mesh.vertices) box.include(v.x);
  return flatness * box.diagonal();
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
  std::vector<LargestPlane> planes(patches.size());
  for (const Triangle& t : mesh.triangles) planes[t.patch].add(corners_of(mesh, t));
  std::vector<std::uint8_t> planar(patches.size(), 1);
  for (const Triangle& t : mesh.triangles)
    for (const Vec3& x : corners_of(mesh, t))
      if (distance(planes[t.patch].plane(), x) > tolerance) planar[t.patch] = 0;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    patches[p].shape = Frozen{};
    if (planar[p] != 0 && !patches[p].required) patches[p].shape = planes[p].plane();
  }
}

}  // namespace taut
