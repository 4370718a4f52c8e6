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

enum class Role {
  once,      ///< a second block would contradict the first
  repeated,  ///< the entities of several blocks follow one another: meshio writes a block per surface
  // Taut does not take these elements, and without them the mesh would have holes or be another one.
  other_shape,
  curved,
};

struct Keyword {
  Code code;
  std::string_view name;  ///< in text files
  Role role = Role::once;
};

inline constexpr auto keywords = std::to_array<Keyword>({
    {Code::version, "MeshVersionFormatted"},
    {Code::dimension, "Dimension"},
    {Code::vertices, "Vertices"},
    {Code::edges, "Edges", Role::repeated},
    {Code::triangles, "Triangles", Role::repeated},
    {Code::quadrilaterals, "Quadrilaterals", Role::other_shape},
    {Code::tetrahedra, "Tetrahedra", Role::repeated},
    {Code::prisms, "Prisms", Role::other_shape},
    {Code::hexahedra, "Hexahedra", Role::other_shape},
    {Code::required_tetrahedra, "RequiredTetrahedra", Role::repeated},
    {Code::corners, "Corners", Role::repeated},
    {Code::ridges, "Ridges", Role::repeated},
    {Code::required_vertices, "RequiredVertices", Role::repeated},
    {Code::required_edges, "RequiredEdges", Role::repeated},
    {Code::required_triangles, "RequiredTriangles", Role::repeated},
    {Code::pyramids, "Pyramids", Role::other_shape},
    {Code::end, "End"},
    {Code::solution, "SolAtVertices"},
    // Old names of the above.
    {Code::prisms, "Pentahedra", Role::other_shape},
    {Code::hexahedra, "Hexaedra", Role::other_shape},
    // These need no name of their own in the code.
    {Code{46}, "Polyhedra", Role::other_shape},
    {Code{207}, "PolyhedraHeaders", Role::other_shape},
    {Code{24}, "TrianglesP2", Role::curved},
    {Code{25}, "EdgesP2", Role::curved},
    {Code{27}, "QuadrilateralsQ2", Role::curved},
    {Code{30}, "TetrahedraP2", Role::curved},
    {Code{33}, "HexahedraQ2", Role::curved},
    {Code{34}, "ExtraVerticesAtEdges", Role::curved},
    {Code{35}, "ExtraVerticesAtTriangles", Role::curved},
    {Code{36}, "ExtraVerticesAtQuadrilaterals", Role::curved},
    {Code{37}, "ExtraVerticesAtTetrahedra", Role::curved},
    {Code{38}, "ExtraVerticesAtPrisms", Role::curved},
    {Code{39}, "ExtraVerticesAtHexahedra", Role::curved},
    {Code{86}, "PrismsP2", Role::curved},
    {Code{87}, "PyramidsP2", Role::curved},
    {Code{88}, "QuadrilateralsQ3", Role::curved},
    {Code{89}, "QuadrilateralsQ4", Role::curved},
    {Code{90}, "TrianglesP3", Role::curved},
    {Code{91}, "TrianglesP4", Role::curved},
    {Code{92}, "EdgesP3", Role::curved},
    {Code{93}, "EdgesP4", Role::curved},
    {Code{96}, "TetrahedraP3", Role::curved},
    {Code{97}, "TetrahedraP4", Role::curved},
    {Code{98}, "HexahedraQ3", Role::curved},
    {Code{99}, "HexahedraQ4", Role::curved},
    {Code{100}, "PyramidsP3", Role::curved},
    {Code{101}, "PyramidsP4", Role::curved},
    {Code{102}, "PrismsP3", Role::curved},
    {Code{103}, "PrismsP4", Role::curved},
    {Code{200}, "Prisms9", Role::curved},
    {Code{201}, "Hexahedra12", Role::curved},
    {Code{202}, "Quadrilaterals6", Role::curved},
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

constexpr Role role_of(Code code) {
  return find_keyword(static_cast<std::int64_t>(code))->role;
}

/// What one entity of a keyword is made of: its reals come first, in both encodings.
struct Row {
  std::size_t reals = 0, integers = 0;

  [[nodiscard]] constexpr std::size_t values() const { return reals + integers; }
};

}  // namespace taut::gmf
