#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "base/buckets.hpp"
#include "base/parallel.hpp"
#include "mesh/faces.hpp"
#include "mesh/incidence.hpp"
#include "mesh/orientation.hpp"
#include "taut/quality.hpp"

namespace taut {
namespace {

/// Where one kind of defect occurs: how often, and the first place.
struct Places {
  std::size_t count = 0, first = 0;

  void add(std::size_t place) { *this += {1, place}; }
  Places& operator+=(const Places& other) {
    if (other.count > 0) first = count == 0 ? other.first : std::min(first, other.first);
    count += other.count;
    return *this;
  }
};

void report(std::string_view kind, const Places& places, std::vector<std::string>& to) {
  if (places.count > 0)
    to.push_back(fmt::format("{}: {}, the first is number {}", kind, places.count, places.first + 1));
}

template <class Condition>
Places places_where(std::size_t count, const Condition& condition) {
  return sum_in_order<Places>(count, [&](Places& places, std::size_t i) {
    if (condition(i)) places.add(i);
  });
}

template <std::size_t n>
void check_range(std::string_view what, const std::vector<std::array<Index, n>>& entities, std::size_t bound,
                 std::vector<std::string>& found) {
  const auto is_beyond = [&](std::size_t i) { return *std::ranges::max_element(entities[i]) >= bound; };
  report(fmt::format("{} with an index out of range", what), places_where(entities.size(), is_beyond), found);
}

void check_range(std::string_view what, const std::vector<Index>& list, std::size_t bound,
                 std::vector<std::string>& found) {
  const auto is_beyond = [&](std::size_t i) { return list[i] >= bound; };
  report(fmt::format("{} with an index out of range", what), places_where(list.size(), is_beyond), found);
}

void check_ranges(const Mesh& mesh, std::vector<std::string>& found) {
  const std::size_t points = mesh.points.size();
  check_range("tetrahedra", mesh.tetrahedra, points, found);
  check_range("triangles", mesh.triangles, points, found);
  check_range("edges", mesh.edges, points, found);
  check_range("corners", mesh.corners, points, found);
  check_range("required points", mesh.required_points, points, found);
  check_range("ridges", mesh.ridges, mesh.edges.size(), found);
  check_range("required edges", mesh.required_edges, mesh.edges.size(), found);
  check_range("required triangles", mesh.required_triangles, mesh.triangles.size(), found);
  check_range("required tetrahedra", mesh.required_tetrahedra, mesh.tetrahedra.size(), found);
}

void check_references(std::string_view what, std::size_t references, std::size_t entities,
                      std::vector<std::string>& found) {
  if (references != 0 && references != entities)
    found.push_back(fmt::format("references of {}: {} found, expected {} or none", what, references, entities));
}

void check_references(const Mesh& mesh, std::vector<std::string>& found) {
  check_references("points", mesh.point_refs.size(), mesh.points.size(), found);
  check_references("tetrahedra", mesh.tetrahedron_refs.size(), mesh.tetrahedra.size(), found);
  check_references("triangles", mesh.triangle_refs.size(), mesh.triangles.size(), found);
  check_references("edges", mesh.edge_refs.size(), mesh.edges.size(), found);
}

void check_coordinates(const Mesh& mesh, std::vector<std::string>& found) {
  const auto is_broken = [&](std::size_t i) {
    return !std::ranges::all_of(mesh.points[i], [](double x) { return std::isfinite(x); });
  };
  report("points with a coordinate that is not finite", places_where(mesh.points.size(), is_broken), found);
}

struct Turned {
  Places inverted, flat;
  Turned& operator+=(const Turned& other) {
    inverted += other.inverted;
    flat += other.flat;
    return *this;
  }
};

void check_orientation(const Mesh& mesh, std::vector<std::string>& found) {
  const auto turned = sum_in_order<Turned>(mesh.tetrahedra.size(), [&](Turned& sum, std::size_t t) {
    const auto& [a, b, c, d] = mesh.tetrahedra[t];
    const int sign = orientation(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]);
    if (sign < 0) sum.inverted.add(t);
    if (sign == 0) sum.flat.add(t);
  });
  report("inverted tetrahedra", turned.inverted, found);
  report("flat tetrahedra", turned.flat, found);
}

int region_of(const Mesh& mesh, Index tet) {
  return mesh.tetrahedron_refs.empty() ? 0 : mesh.tetrahedron_refs[tet];
}

bool same_face(const Face& a, const Face& b) {
  return a.vertices == b.vertices;
}

// The face that two tetrahedra share, as the given one of them sees it: outward if it is positive.
std::array<Index, 3> seen_from(const std::array<Index, 4>& tet, const Face& face) {
  for (const auto& [i, j, k] : face_vertices) {
    std::array<Index, 3> sorted = {tet[i], tet[j], tet[k]};
    std::ranges::sort(sorted);
    if (sorted == face.vertices) return {tet[i], tet[j], tet[k]};
  }
  return face.vertices;
}

bool is_positive(const Mesh& mesh, Index t) {
  const auto& [a, b, c, d] = mesh.tetrahedra[t];
  return orientation(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]) > 0;
}

/// Whether two positive tetrahedra lie on the same side of their common face.
bool overlap(const Mesh& mesh, const Face& a, const Face& b) {
  return same_cycle(seen_from(mesh.tetrahedra[a.source], a), seen_from(mesh.tetrahedra[b.source], b)) &&
         is_positive(mesh, a.source) && is_positive(mesh, b.source);
}

struct FaceDefects {
  Places crowded, overlapping, bare, open, loose;

  FaceDefects& operator+=(const FaceDefects& other) {
    crowded += other.crowded;
    overlapping += other.overlapping;
    bare += other.bare;
    open += other.open;
    loose += other.loose;
    return *this;
  }

  /// Walks through the faces of tetrahedra and the triangles, both sorted, in parallel.
  void add(const Mesh& mesh, std::span<const Face> faces, std::span<const Face> triangles) {
    auto triangle = triangles.begin();
    for (auto face = faces.begin(); face != faces.end();) {
      const auto next = std::find_if(face, faces.end(), [&](const Face& f) { return !same_face(f, *face); });
      for (; triangle != triangles.end() && triangle->vertices < face->vertices; ++triangle)
        loose.add(triangle->source);
      const bool marked = triangle != triangles.end() && same_face(*triangle, *face);
      while (triangle != triangles.end() && same_face(*triangle, *face)) ++triangle;
      const auto sharing = next - face;
      if (sharing > 2) crowded.add(face->source);
      if (sharing == 2 && overlap(mesh, face[0], face[1])) overlapping.add(face->source);
      if (sharing == 1 && !marked) bare.add(face->source);
      if (sharing == 2 && !marked && region_of(mesh, face[0].source) != region_of(mesh, face[1].source))
        open.add(face->source);
      face = next;
    }
    for (; triangle != triangles.end(); ++triangle) loose.add(triangle->source);
  }
};

void check_faces(const Mesh& mesh, const Buckets<Face>& triangles, std::vector<std::string>& found) {
  const Buckets<Face> faces = faces_of(mesh.tetrahedra, mesh.points.size());
  const auto sum = sum_in_order<FaceDefects>(
      mesh.points.size(), [&](FaceDefects& own, std::size_t v) { own.add(mesh, faces[v], triangles[v]); });
  report("faces shared by more than two tetrahedra (numbers of tetrahedra)", sum.crowded, found);
  report("tetrahedra that overlap a neighbour", sum.overlapping, found);
  report("boundary faces without a triangle (numbers of tetrahedra)", sum.bare, found);
  report("faces between regions without a triangle (numbers of tetrahedra)", sum.open, found);
  report("triangles that are not a face of any tetrahedron", sum.loose, found);
}

/// Of two entities with the same vertices, the later one counts as the duplicate.
template <std::size_t n>
void check_duplicates(std::string_view what, const Buckets<Named<n>>& entities, std::vector<std::string>& found) {
  const auto duplicates = sum_in_order<Places>(entities.keys(), [&](Places& places, std::size_t v) {
    const std::span<const Named<n>> own = entities[v];
    for (std::size_t i = 1; i < own.size(); ++i)
      if (own[i].vertices == own[i - 1].vertices) places.add(own[i].source);
  });
  report(fmt::format("duplicate {}", what), duplicates, found);
}

void check_unused(const Mesh& mesh, std::vector<std::string>& found) {
  const auto tet_of_point = last_tet_of_points(mesh.tetrahedra, mesh.points.size());
  const auto is_unused = [&](std::size_t p) { return tet_of_point[p] == none; };
  report("points that belong to no tetrahedron", places_where(mesh.points.size(), is_unused), found);
}

}  // namespace

std::vector<std::string> defects(const Mesh& mesh) {
  std::vector<std::string> found;
  check_ranges(mesh, found);
  check_references(mesh, found);
  check_coordinates(mesh, found);
  // Nothing else can be checked unless these hold.
  if (!found.empty()) return found;
  check_orientation(mesh, found);
  const Buckets<Face> triangles = named(mesh.triangles, mesh.points.size());
  check_faces(mesh, triangles, found);
  check_duplicates("tetrahedra", named(mesh.tetrahedra, mesh.points.size()), found);
  check_duplicates("triangles", triangles, found);
  check_duplicates("edges", named(mesh.edges, mesh.points.size()), found);
  check_unused(mesh, found);
  return found;
}

}  // namespace taut
