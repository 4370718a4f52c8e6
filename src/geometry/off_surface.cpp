#include "geometry/off_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/parallel.hpp"
#include "geometry/match_patches.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

// A vertex that the input does not let move has no place to go to, but may be off its patches.
double distance_off(const Model& model, Tag tag, const Vec3& x) {
  double distance = norm(model.project(tag, x) - x);
  if (!tag.is_at_corner() || model.corners[tag.corner()].place) return distance;
  model.for_each_patch_at(tag, [&](PatchId p) {
    if (const Curved* curved = model.patches[p].curved(); curved != nullptr)
      distance = std::max(distance, model.surface.closest_on(*curved, x).distance);
  });
  return distance;
}

std::vector<double> distances_off(const TetMesh& mesh, const Model& model) {
  std::vector<double> distances(mesh.vertices.size(), 0);
  for_each_index(distances.size(), [&](std::size_t i) {
    const auto v = static_cast<VertexId>(i);
    if (mesh.is_vertex_alive(v) && !mesh.tag_of_vertex[v].is_in_volume())
      distances[v] = distance_off(model, mesh.tag_of_vertex[v], mesh.x(v));
  });
  return distances;
}

std::vector<double> longest_edges(const TetMesh& mesh) {
  std::vector<double> longest(mesh.vertices.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    if (!t.alive()) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::array edge{t.v[k], t.v[(k + 1) % 3]};
      const double length = norm(mesh.x(edge[1]) - mesh.x(edge[0]));
      for (const VertexId v : edge) longest[v] = std::max(longest[v], length);
    }
  }
  return longest;
}

}  // namespace

std::vector<VertexId> vertices_off_surface(const TetMesh& mesh, const Model& model) {
  if (!model.surface_is_given) return {};
  const double tolerance = flatness_tolerance(model.surface.facets());
  const std::vector<double> distances = distances_off(mesh, model);
  std::vector<VertexId> off;
  for (const VertexId v : mesh.vertex_ids())
    if (distances[v] > tolerance) off.push_back(v);
  return off;
}

void require_near_surface(const TetMesh& mesh, const Model& model) {
  if (!model.surface_is_given) return;
  const std::vector<double> distances = distances_off(mesh, model), longest = longest_edges(mesh);
  for (const VertexId v : mesh.vertex_ids())
    if (distances[v] > farthest_share * longest[v])
      throw InputError(fmt::format("geometry: vertex {} is {:.3g} away from it, expected at most {:.3g}, half an edge",
                                   place_of(mesh, std::array{v}), distances[v], farthest_share * longest[v]));
}

}  // namespace taut
