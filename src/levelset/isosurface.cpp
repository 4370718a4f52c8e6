#include <fmt/format.h>

#include <cmath>

#include "base/parallel.hpp"
#include "base/sort.hpp"
#include "levelset/cut_tetrahedra.hpp"
#include "levelset/level_faces.hpp"
#include "levelset/level_field.hpp"
#include "mesh/door.hpp"
#include "taut/levelset.hpp"

namespace taut {
namespace {

void require_values(const Mesh& mesh, std::span<const double> values, double level) {
  if (values.size() != mesh.points.size())
    throw InputError(
        fmt::format("field: {} values found, expected {}, one per vertex", values.size(), mesh.points.size()));
  if (!std::isfinite(level)) throw InputError(fmt::format("level: {} found, expected a finite number", level));
  for_each_index(values.size(), [&](std::size_t v) {
    if (!std::isfinite(values[v]))
      throw InputError(fmt::format("field: vertex {}: {} found, expected a finite number", v + 1, values[v]));
  });
}

std::uint64_t key_of(const Crossing& c) {
  return std::uint64_t{c[0]} << 32 | c[1];
}

/// All corners of all triangles, sorted by the place on the mesh.
std::vector<KeyedIndex> sorted_corners(std::span<const CrossingTriangle> triangles) {
  std::vector<KeyedIndex> corners(3 * triangles.size());
  for_each_index(corners.size(), [&](std::size_t k) {
    corners[k] = {key_of(triangles[k / 3][k % 3]), static_cast<std::uint32_t>(k)};
  });
  sort(corners);
  return corners;
}

/// Gives each place one point, in ascending order of the edges.
Isosurface with_shared_points(const LevelField& field, std::span<const CrossingTriangle> triangles) {
  Isosurface result;
  result.surface.triangles.resize(triangles.size());
  std::uint64_t last = 0;
  for (const auto& [key, corner] : sorted_corners(triangles)) {
    if (result.on_edges.empty() || key != last) {
      const Crossing& c = triangles[corner / 3][corner % 3];
      result.on_edges.push_back({c[0], c[1], field.weight(c)});
      result.surface.points.push_back(field.position(c));
      last = key;
    }
    result.surface.triangles[corner / 3][corner % 3] = static_cast<Index>(result.on_edges.size() - 1);
  }
  return result;
}

}  // namespace

Isosurface isosurface(const Mesh& mesh, std::span<const double> values, double level) {
  require_sound_arrays(mesh);
  require_values(mesh, values, level);
  const LevelField field{mesh, values, level};
  std::vector<CrossingTriangle> triangles = cut_tetrahedra(field);
  const std::vector<CrossingTriangle> faces = level_faces(field);
  triangles.insert(triangles.end(), faces.begin(), faces.end());
  return with_shared_points(field, triangles);
}

}  // namespace taut
