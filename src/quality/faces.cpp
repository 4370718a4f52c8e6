#include "quality/faces.hpp"

#include <algorithm>

#include "base/parallel.hpp"

namespace taut {
namespace {

Face make_face(std::array<VertexId, 3> vertices, std::size_t source) {
  std::sort(vertices.begin(), vertices.end());
  return {vertices, static_cast<Index>(source)};
}

Buckets<Face> sorted(Buckets<Face> faces) {
  for_each_index(faces.keys(), [&](std::size_t v) { std::ranges::sort(faces[v]); });
  return faces;
}

}  // namespace

Buckets<Face> faces_of(std::span<const std::array<Index, 4>> tets, std::size_t vertices) {
  return sorted(gather<Face>(tets.size(), vertices, [&](std::size_t t, auto put) {
    for (const auto& [i, j, k] : face_vertices) {
      const Face face = make_face({tets[t][i], tets[t][j], tets[t][k]}, t);
      put(face.vertices[0], face);
    }
  }));
}

Buckets<Face> faces_of(std::span<const std::array<Index, 3>> triangles, std::size_t vertices) {
  return sorted(gather<Face>(triangles.size(), vertices, [&](std::size_t t, auto put) {
    const Face face = make_face(triangles[t], t);
    put(face.vertices[0], face);
  }));
}

}  // namespace taut
