#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "mesh/orientation.hpp"
#include "quality/faces.hpp"
#include "taut/quality.hpp"

namespace taut {
namespace {

/// Counts one kind of defect and remembers the first place.
class Tally {
public:
  explicit Tally(std::string kind) : kind_(std::move(kind)) {}

  void add(std::size_t place) {
    first_ = count_ == 0 ? place : std::min(first_, place);
    ++count_;
  }
  void report(std::vector<std::string>& to) const {
    if (count_ > 0) to.push_back(fmt::format("{}: {}, the first is number {}", kind_, count_, first_ + 1));
  }

private:
  std::string kind_;
  std::size_t count_ = 0, first_ = 0;
};

template <std::size_t n>
void check_range(std::string_view what, const std::vector<std::array<Index, n>>& entities, std::size_t bound,
                 std::vector<std::string>& found) {
  Tally tally(fmt::format("{} with an index out of range", what));
  for (std::size_t i = 0; i < entities.size(); ++i) {
    if (std::ranges::any_of(entities[i], [bound](Index v) { return v >= bound; })) tally.add(i);
  }
  tally.report(found);
}

void check_range(std::string_view what, const std::vector<Index>& list, std::size_t bound,
                 std::vector<std::string>& found) {
  Tally tally(fmt::format("{} with an index out of range", what));
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i] >= bound) tally.add(i);
  }
  tally.report(found);
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
    found.push_back(fmt::format("references of {}: {} for {}, expected as many or none", what, references, entities));
}

void check_references(const Mesh& mesh, std::vector<std::string>& found) {
  check_references("points", mesh.point_refs.size(), mesh.points.size(), found);
  check_references("tetrahedra", mesh.tetrahedron_refs.size(), mesh.tetrahedra.size(), found);
  check_references("triangles", mesh.triangle_refs.size(), mesh.triangles.size(), found);
  check_references("edges", mesh.edge_refs.size(), mesh.edges.size(), found);
}

void check_coordinates(const Mesh& mesh, std::vector<std::string>& found) {
  Tally tally("points with a coordinate that is not finite");
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (!std::ranges::all_of(mesh.points[i], [](double x) { return std::isfinite(x); })) tally.add(i);
  }
  tally.report(found);
}

void check_orientation(const Mesh& mesh, std::vector<std::string>& found) {
  Tally inverted("inverted tetrahedra"), flat("flat tetrahedra");
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    const auto& [a, b, c, d] = mesh.tetrahedra[t];
    const int sign = orientation(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]);
    if (sign < 0) inverted.add(t);
    if (sign == 0) flat.add(t);
  }
  inverted.report(found);
  flat.report(found);
}

int region_of(const Mesh& mesh, Index tet) {
  return mesh.tetrahedron_refs.empty() ? 0 : mesh.tetrahedron_refs[tet];
}

bool same_face(const Face& a, const Face& b) {
  return a.vertices == b.vertices;
}

/// Walks the faces of the tetrahedra and the triangles, both sorted, side by side.
void check_faces(const Mesh& mesh, std::vector<std::string>& found) {
  Tally crowded("faces shared by more than two tetrahedra (index of a tetrahedron)");
  Tally bare("boundary faces without triangle (index of the tetrahedron)");
  Tally open("faces between regions without triangle (index of a tetrahedron)");
  Tally loose("triangles that are no face of a tetrahedron");
  const std::vector<Face> faces = faces_of(mesh.tetrahedra, mesh.points.size());
  const std::vector<Face> triangles = faces_of(mesh.triangles);
  auto triangle = triangles.begin();
  for (auto face = faces.begin(); face != faces.end();) {
    const auto next = std::find_if(face, faces.end(), [&](const Face& f) { return !same_face(f, *face); });
    for (; triangle != triangles.end() && triangle->vertices < face->vertices; ++triangle) loose.add(triangle->source);
    const bool marked = triangle != triangles.end() && same_face(*triangle, *face);
    while (triangle != triangles.end() && same_face(*triangle, *face)) ++triangle;
    const auto sharing = next - face;
    if (sharing > 2) crowded.add(face->source);
    if (sharing == 1 && !marked) bare.add(face->source);
    if (sharing == 2 && !marked && region_of(mesh, face[0].source) != region_of(mesh, face[1].source))
      open.add(face->source);
    face = next;
  }
  for (; triangle != triangles.end(); ++triangle) loose.add(triangle->source);
  for (const Tally* tally : {&crowded, &bare, &open, &loose}) tally->report(found);
}

/// The later one of two entities with the same vertices counts as the duplicate.
template <std::size_t n>
void check_duplicates(std::string_view what, std::vector<std::array<Index, n>> entities,
                      std::vector<std::string>& found) {
  for (auto& entity : entities) std::ranges::sort(entity);
  std::vector<std::size_t> order(entities.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t i, std::size_t j) {
    return entities[i] != entities[j] ? entities[i] < entities[j] : i < j;
  });
  Tally tally(fmt::format("duplicate {}", what));
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (entities[order[i]] == entities[order[i - 1]]) tally.add(order[i]);
  }
  tally.report(found);
}

void check_unused(const Mesh& mesh, std::vector<std::string>& found) {
  std::vector<bool> used(mesh.points.size());
  for (const auto& tet : mesh.tetrahedra)
    for (const Index v : tet) used[v] = true;
  Tally tally("points of no tetrahedron");
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) tally.add(i);
  }
  tally.report(found);
}

}  // namespace

std::vector<std::string> defects(const Mesh& mesh) {
  std::vector<std::string> found;
  check_ranges(mesh, found);
  check_references(mesh, found);
  check_coordinates(mesh, found);
  // Nothing else can be looked at before these hold.
  if (!found.empty()) return found;
  check_orientation(mesh, found);
  check_faces(mesh, found);
  check_duplicates("tetrahedra", mesh.tetrahedra, found);
  check_duplicates("triangles", mesh.triangles, found);
  check_duplicates("edges", mesh.edges, found);
  check_unused(mesh, found);
  return found;
}

}  // namespace taut
