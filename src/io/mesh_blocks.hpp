// Which array of a mesh goes with which keyword: one list for reading and writing, text and binary.
#pragma once

#include <array>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "io/keywords.hpp"
#include "taut/mesh.hpp"

namespace taut::gmf {

template <class Points, class Refs>
struct PointRows {
  static constexpr Row row{.reals = 3, .integers = 1};
  Points& points;
  Refs& refs;

  [[nodiscard]] std::size_t size() const { return points.size(); }
};

template <class Elements, class Refs>
struct ElementRows {
  using Element = typename std::remove_cvref_t<Elements>::value_type;
  static constexpr Row row{.reals = 0, .integers = std::tuple_size_v<Element> + 1};
  Elements& elements;
  Refs& refs;
  std::size_t limit;  ///< every index lies below

  [[nodiscard]] std::size_t size() const { return elements.size(); }
};

template <class Indices>
struct IndexRows {
  static constexpr Row row{.reals = 0, .integers = 1};
  Indices& indices;
  std::size_t limit;
  std::string_view what;  ///< that the indices count; for messages

  [[nodiscard]] std::size_t size() const { return indices.size(); }
};

template <class Points, class Refs>
PointRows(Points&, Refs&) -> PointRows<Points, Refs>;
template <class Elements, class Refs>
ElementRows(Elements&, Refs&, std::size_t) -> ElementRows<Elements, Refs>;
template <class Indices>
IndexRows(Indices&, std::size_t, std::string_view) -> IndexRows<Indices>;

/// Calls visit(code, rows) for each array of `mesh` (const or not), each one after those that its indices refer to: the
/// limits are right while a mesh is being filled.
template <class AnyMesh, class Visitor>
void for_each_block(AnyMesh& mesh, Visitor&& visit) {
  visit(Code::vertices, PointRows{mesh.points, mesh.point_refs});
  const std::size_t points = mesh.points.size();
  visit(Code::edges, ElementRows{mesh.edges, mesh.edge_refs, points});
  visit(Code::triangles, ElementRows{mesh.triangles, mesh.triangle_refs, points});
  visit(Code::tetrahedra, ElementRows{mesh.tetrahedra, mesh.tetrahedron_refs, points});
  visit(Code::corners, IndexRows{mesh.corners, points, "vertex"});
  visit(Code::required_vertices, IndexRows{mesh.required_points, points, "vertex"});
  visit(Code::ridges, IndexRows{mesh.ridges, mesh.edges.size(), "edge"});
  visit(Code::required_edges, IndexRows{mesh.required_edges, mesh.edges.size(), "edge"});
  visit(Code::required_triangles, IndexRows{mesh.required_triangles, mesh.triangles.size(), "triangle"});
  visit(Code::required_tetrahedra, IndexRows{mesh.required_tetrahedra, mesh.tetrahedra.size(), "tetrahedron"});
}

/// Without vertices and elements of this kind a file is no mesh for taut; all else may be absent.
enum class Needs { tetrahedra, triangles, edges };

constexpr Code code_of(Needs needs) {
  return needs == Needs::tetrahedra ? Code::tetrahedra : needs == Needs::triangles ? Code::triangles : Code::edges;
}

constexpr bool is_required(Code code, Needs needs = Needs::tetrahedra) {
  return code == Code::vertices || code == code_of(needs);
}

}  // namespace taut::gmf
