#include "geometry/patches.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace taut {
namespace {

// Union-find; the smallest triangle of a set is its root.
std::vector<TriangleId> roots(std::size_t triangles, std::span<const std::array<TriangleId, 2>> joined) {
  std::vector<TriangleId> parent(triangles);
  std::iota(parent.begin(), parent.end(), TriangleId{0});
  const auto root = [&](TriangleId t) {
    while (parent[t] != t) t = parent[t] = parent[parent[t]];
    return t;
  };
  for (const auto& [s, t] : joined) {
    const TriangleId a = root(s), b = root(t);
    parent[std::max(a, b)] = std::min(a, b);
  }
  for (TriangleId t = 0; t < triangles; ++t) parent[t] = root(t);
  return parent;
}

// A plane across an axis keeps its coordinate exactly: no rounding moves the vertices off it.
void snap_to_axis(Vec3& normal) {
  for (int d = 0; d < 3; ++d) {
    if (std::fabs(normal[d]) < 1 - 1e-15) continue;
    const double sign = normal[d] > 0 ? 1 : -1;
    normal = {};
    normal[d] = sign;
    return;
  }
}

void fit_planes(const TetMesh& mesh, std::vector<Patch>& patches) {
  std::vector<double> largest(patches.size(), -1);
  for (const Triangle& t : mesh.triangles) {
    Patch& patch = patches[t.patch];
    const Vec3 normal = cross(mesh.x(t.v[1]) - mesh.x(t.v[0]), mesh.x(t.v[2]) - mesh.x(t.v[0]));
    const double area = norm(normal);
    if (area <= largest[t.patch]) continue;
    largest[t.patch] = area;
    patch.normal = (1 / area) * normal;
    snap_to_axis(patch.normal);
    patch.offset = dot(patch.normal, mesh.x(t.v[0]));
  }
}

}  // namespace

std::vector<Patch> make_patches(TetMesh& mesh, std::span<const std::array<TriangleId, 2>> joined,
                                std::span<const int> refs, std::span<const std::uint8_t> required, double tolerance) {
  const std::vector<TriangleId> root = roots(mesh.triangles.size(), joined);
  std::vector<Patch> patches;
  for (TriangleId t = 0; t < mesh.triangles.size(); ++t) {
    if (root[t] != t) {
      mesh.triangles[t].patch = mesh.triangles[root[t]].patch;
      continue;
    }
    mesh.triangles[t].patch = static_cast<PatchId>(patches.size());
    patches.push_back({refs[t], required[t] != 0, required[t] != 0, {}, 0});
  }
  fit_planes(mesh, patches);
  for (const Triangle& t : mesh.triangles) {
    Patch& patch = patches[t.patch];
    for (VertexId v : t.v) patch.frozen |= std::fabs(dot(patch.normal, mesh.x(v)) - patch.offset) > tolerance;
  }
  return patches;
}

}  // namespace taut
