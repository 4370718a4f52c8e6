#include "levelset/level_faces.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "base/parallel.hpp"
#include "mesh/door.hpp"
#include "mesh/orientation.hpp"

namespace taut {
namespace {

constexpr std::size_t tets_per_face_task = std::size_t{1} << 13;

/// A face on the level, as one of its tetrahedra sees it.
struct Seen {
  std::array<Index, 3> key;      ///< its vertices, ascending
  std::array<Index, 3> outward;  ///< its vertices; the normal points away from the tetrahedron
  bool below;                    ///< the value at the fourth vertex is below the level
};

void add_seen(const LevelField& field, std::size_t t, std::vector<Seen>& faces) {
  const auto& v = field.mesh.tetrahedra[t];
  const Signs s = field.signs(v);
  if (std::ranges::count(s, 0) < 3) return;
  const auto x = [&](int k) { return field.mesh.points[v[k]]; };
  const int sign = orientation(x(0), x(1), x(2), x(3));
  if (sign == 0) throw_flat(t, v);
  for (std::size_t apex = 0; apex < 4; ++apex) {
    const auto& [i, j, k] = face_vertices[apex];
    if (s[i] != 0 || s[j] != 0 || s[k] != 0) continue;
    Seen face{{v[i], v[j], v[k]}, {v[i], v[j], v[k]}, s[apex] < 0};
    std::ranges::sort(face.key);
    if (sign < 0) std::swap(face.outward[0], face.outward[1]);
    faces.push_back(face);
  }
}

std::vector<Seen> faces_on_level(const LevelField& field) {
  auto faces = collect_in_order<Seen>(Chunks(field.mesh.tetrahedra.size(), tets_per_face_task),
                                      [&](std::vector<Seen>& list, std::size_t t) { add_seen(field, t, list); });
  std::ranges::stable_sort(faces, {}, &Seen::key);
  return faces;
}

/// `sides`: of one face.
void add_if_lower_end(std::span<const Seen> sides, std::vector<CrossingTriangle>& triangles) {
  if (sides.size() > 2) throw_crowded_face(sides[0].key);
  if (sides.size() < 2 || sides[0].below == sides[1].below) return;
  const auto& [a, b, c] = sides[sides[0].below ? 0 : 1].outward;
  triangles.push_back({Crossing{a, a}, Crossing{b, b}, Crossing{c, c}});
}

}  // namespace

std::vector<CrossingTriangle> level_faces(const LevelField& field) {
  const std::vector<Seen> faces = faces_on_level(field);
  std::vector<CrossingTriangle> triangles;
  for (std::size_t begin = 0, end = 0; begin < faces.size(); begin = end) {
    while (end < faces.size() && faces[end].key == faces[begin].key) ++end;
    add_if_lower_end(std::span(faces).subspan(begin, end - begin), triangles);
  }
  return triangles;
}

}  // namespace taut
