#include "quality/faces.hpp"

#include <algorithm>

namespace taut {
namespace {

Face make_face(std::array<VertexId, 3> vertices, Index source) {
  std::sort(vertices.begin(), vertices.end());
  return {vertices, source};
}

template <class Visit>
void for_each_face(std::span<const std::array<Index, 4>> tets, Visit&& visit) {
  for (Index t = 0; t < tets.size(); ++t)
    for (const auto& [i, j, k] : face_vertices) visit(make_face({tets[t][i], tets[t][j], tets[t][k]}, t));
}

}  // namespace

// Counting sort by the smallest vertex, then a sort of each small bucket.
std::vector<Face> faces_of(std::span<const std::array<Index, 4>> tets, std::size_t vertices) {
  std::vector<std::size_t> first(vertices + 2);
  for_each_face(tets, [&](const Face& f) { ++first[f.vertices[0] + 2]; });
  for (std::size_t v = 2; v < first.size(); ++v) first[v] += first[v - 1];
  std::vector<Face> faces(4 * tets.size());
  for_each_face(tets, [&](const Face& f) { faces[first[f.vertices[0] + 1]++] = f; });
  for (std::size_t v = 0; v < vertices; ++v)
    std::sort(faces.begin() + static_cast<std::ptrdiff_t>(first[v]),
              faces.begin() + static_cast<std::ptrdiff_t>(first[v + 1]));
  return faces;
}

std::vector<Face> faces_of(std::span<const std::array<Index, 3>> triangles) {
  std::vector<Face> faces(triangles.size());
  for (Index t = 0; t < triangles.size(); ++t) faces[t] = make_face(triangles[t], t);
  std::sort(faces.begin(), faces.end());
  return faces;
}

}  // namespace taut
