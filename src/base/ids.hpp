// What an integer indexes, and how a face link is packed. Packed integers live here only.
#pragma once

#include <array>
#include <cstdint>

namespace taut {

using VertexId = std::uint32_t;
using TetId = std::uint32_t;
using TriangleId = std::uint32_t;

inline constexpr std::uint32_t none = ~std::uint32_t{0};

/// Where a face of a tetrahedron leads: to a face of another tetrahedron, or to a triangle. There is no third case.
class FaceLink {
public:
  constexpr FaceLink() = default;
  static constexpr FaceLink to_face(TetId tet, int face) {
    return FaceLink{4 * tet + static_cast<std::uint32_t>(face)};
  }
  static constexpr FaceLink to_triangle(TriangleId triangle) { return FaceLink{triangle | triangle_bit}; }

  [[nodiscard]] constexpr bool is_triangle() const { return (bits_ & triangle_bit) != 0; }
  [[nodiscard]] constexpr TetId tet() const { return bits_ >> 2; }
  [[nodiscard]] constexpr int face() const { return static_cast<int>(bits_ & 3); }
  [[nodiscard]] constexpr TriangleId triangle() const { return bits_ & ~triangle_bit; }
  /// For sorting: triangles come after faces.
  [[nodiscard]] constexpr std::uint32_t bits() const { return bits_; }
  constexpr bool operator==(const FaceLink&) const = default;

private:
  static constexpr std::uint32_t triangle_bit = 0x80000000U;
  explicit constexpr FaceLink(std::uint32_t bits) : bits_(bits) {}
  std::uint32_t bits_ = none;
};

/// As a side of a triangle: no tetrahedron there.
inline constexpr FaceLink outside{};

/// Vertices of the face opposite to each vertex, outward for a positive tetrahedron.
inline constexpr std::array<std::array<int, 3>, 4> face_vertices = {{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// End points of each edge.
inline constexpr std::array<std::array<int, 2>, 6> edge_vertices = {{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// The edge between two different vertices.
inline constexpr std::array<std::array<std::uint8_t, 4>, 4> edge_between = {
    {{9, 0, 1, 2}, {0, 9, 3, 4}, {1, 3, 9, 5}, {2, 4, 5, 9}}};

}  // namespace taut
