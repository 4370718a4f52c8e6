// The keywords of the Gamma Mesh Format that taut knows: one table for text and binary, reading and writing.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace taut::gmf {

/// The number of a keyword in binary files.
enum class Code : std::int32_t {
  version = 1,
  dimension = 3,
  vertices = 4,
  edges = 5,
  triangles = 6,
  quadrilaterals = 7,
  tetrahedra = 8,
  prisms = 9,
  hexahedra = 10,
  required_tetrahedra = 12,
  corners = 13,
  ridges = 14,
  required_vertices = 15,
  required_edges = 16,
  required_triangles = 17,
  pyramids = 49,
  end = 54,
  solution = 62,
};

struct Keyword {
  Code code;
  std::string_view name;         ///< in text files
  bool foreign_element = false;  ///< elements without which the mesh would have holes, and which taut does not take
};

inline constexpr auto keywords = std::to_array<Keyword>({
    {Code::version, "MeshVersionFormatted"},
    {Code::dimension, "Dimension"},
    {Code::vertices, "Vertices"},
    {Code::edges, "Edges"},
    {Code::triangles, "Triangles"},
    {Code::quadrilaterals, "Quadrilaterals", true},
    {Code::tetrahedra, "Tetrahedra"},
    {Code::prisms, "Prisms", true},
    {Code::hexahedra, "Hexahedra", true},
    {Code::required_tetrahedra, "RequiredTetrahedra"},
    {Code::corners, "Corners"},
    {Code::ridges, "Ridges"},
    {Code::required_vertices, "RequiredVertices"},
    {Code::required_edges, "RequiredEdges"},
    {Code::required_triangles, "RequiredTriangles"},
    {Code::pyramids, "Pyramids", true},
    {Code::end, "End"},
    {Code::solution, "SolAtVertices"},
});

/// The row of the table, or null if taut does not know the keyword.
constexpr const Keyword* find_keyword(std::int64_t code) {
  for (const Keyword& keyword : keywords) {
    if (static_cast<std::int64_t>(keyword.code) == code) return &keyword;
  }
  return nullptr;
}

constexpr const Keyword* find_keyword(std::string_view name) {
  for (const Keyword& keyword : keywords) {
    if (keyword.name == name) return &keyword;
  }
  return nullptr;
}

constexpr std::string_view name_of(Code code) {
  return find_keyword(static_cast<std::int64_t>(code))->name;
}

/// What one entity of a keyword is made of: its reals come first, in both encodings.
struct Row {
  std::size_t reals = 0, integers = 0;

  [[nodiscard]] constexpr std::size_t values() const { return reals + integers; }
};

}  // namespace taut::gmf
