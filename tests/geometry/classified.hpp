// A mesh with its geometry, and look-ups by the numbers of the input.
#pragma once

#include <gtest/gtest.h>

#include "geometry/classify.hpp"
#include "mesh/shapes.hpp"
#include "metric/random_metrics.hpp"

namespace taut::test {

struct Count {
  std::size_t patches, lines, corners;
  bool operator==(const Count&) const = default;
};

inline void PrintTo(const Count& c, std::ostream* out) {
  *out << c.patches << " patches, " << c.lines << " lines, " << c.corners << " corners";
}

struct Classified {
  Built built;
  Model model;

  explicit Classified(const Mesh& mesh, Surface surface = Surface::planar, std::optional<double> ridge_angle = 45)
      : built(build(mesh)), model(classify(mesh, built, surface, ridge_angle)) {}

  /// The first corner represents all corners within frozen patches.
  [[nodiscard]] Count count() const { return {model.patches.size(), model.lines.size(), model.corners.size() - 1}; }

  [[nodiscard]] std::size_t frozen_patches() const {
    return static_cast<std::size_t>(std::ranges::count_if(model.patches, [](const Patch& p) { return p.frozen(); }));
  }

  /// Vertices by the dimension of their tags.
  [[nodiscard]] std::array<int, 4> tags() const {
    std::array<int, 4> tags{};
    for (const Tag& tag : built.mesh.tag_of_vertex) ++tags[tag.dimension()];
    return tags;
  }

  [[nodiscard]] std::vector<int> patch_refs() const {
    std::vector<int> refs;
    for (const Patch& patch : model.patches) refs.push_back(patch.ref);
    std::sort(refs.begin(), refs.end());
    return refs;
  }

  [[nodiscard]] Tag tag(Index point) const { return built.mesh.tag_of_vertex[built.vertex_of_point[point]]; }

  /// The line of the edge between two points, if it has one.
  [[nodiscard]] const Line* line(Index p, Index q) const {
    const VertexId a = built.vertex_of_point[p], b = built.vertex_of_point[q];
    for (const Triangle& t : built.mesh.triangles)
      for (int k = 0; k < 3; ++k) {
        const VertexId c = t.v[(k + 1) % 3], d = t.v[(k + 2) % 3];
        if (((a == c && b == d) || (a == d && b == c)) && t.line[k] != none) return &model.lines[t.line[k]];
      }
    return nullptr;
  }
};

/// Rotated so that no plane is perpendicular to an axis.
inline Mesh askew(Mesh mesh) {
  const Rotation r = Random(9).rotation();
  for (Point& p : mesh.points) p = rotate(r, p);
  return mesh;
}

}  // namespace taut::test
