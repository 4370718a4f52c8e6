// What an integer indexes, and how links and tags are packed. Packed integers live in this room only.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace taut {

// Enumerations without enumerators: they index arrays as integers do, but none converts into another.
enum VertexId : std::uint32_t {};
enum TetId : std::uint32_t {};
enum TriangleId : std::uint32_t {};
enum CellId : std::uint32_t {};  ///< of a tetrahedron of the background mesh
enum SeatId : std::uint32_t {};  ///< of a triangle of the reference surface, or a segment of one of its curves
enum PatchId : std::uint32_t {};
enum LineId : std::uint32_t {};
enum CornerId : std::uint32_t {};
enum RegionId : std::uint16_t {};

template <class T>
concept Identifier = (std::is_enum_v<T> || std::same_as<T, std::uint32_t>)&&sizeof(T) == sizeof(std::uint32_t);

/// What an id is that stands for no entity.
struct None {
  template <Identifier Id>
  constexpr operator Id() const {  // NOLINT(google-explicit-constructor): every id may be `none`
    return static_cast<Id>(~std::uint32_t{0});
  }
  template <Identifier Id>
  friend constexpr bool operator==(Id id, None none) {
    return id == static_cast<Id>(none);
  }
};
inline constexpr None none{};

/// A range of ids, ascending. (The views of the standard library do not compile with clang 14 and libstdc++ 12.)
template <class Id>
class IdRange {
public:
  class Iterator {
  public:
    constexpr explicit Iterator(std::uint32_t at) : at_(at) {}
    constexpr Id operator*() const { return static_cast<Id>(at_); }
    constexpr Iterator& operator++() {
      ++at_;
      return *this;
    }
    constexpr bool operator==(const Iterator&) const = default;

  private:
    std::uint32_t at_;
  };

  constexpr explicit IdRange(std::size_t count) : count_(static_cast<std::uint32_t>(count)) {}
  [[nodiscard]] constexpr Iterator begin() const { return Iterator(0); }
  [[nodiscard]] constexpr Iterator end() const { return Iterator(count_); }

private:
  std::uint32_t count_;
};

/// The ids 0 to count - 1.
template <class Id>
[[nodiscard]] constexpr IdRange<Id> ids(std::size_t count) {
  return IdRange<Id>(count);
}

/// The ids as plain numbers.
template <class Id, std::size_t n>
[[nodiscard]] constexpr std::array<std::uint32_t, n> indices(const std::array<Id, n>& ids_of) {
  std::array<std::uint32_t, n> result{};
  for (std::size_t k = 0; k < n; ++k) result[k] = ids_of[k];
  return result;
}

/// Where a face of a tetrahedron leads: to a face of another tetrahedron, or to a triangle. There is no third case.
class FaceLink {
public:
  constexpr FaceLink() = default;
  static constexpr FaceLink to_face(TetId tet, int face) {
    return FaceLink{4 * std::uint32_t{tet} + static_cast<std::uint32_t>(face)};
  }
  static constexpr FaceLink to_triangle(TriangleId triangle) { return FaceLink{triangle | triangle_bit}; }

  [[nodiscard]] constexpr bool is_triangle() const { return (bits_ & triangle_bit) != 0; }
  [[nodiscard]] constexpr TetId tet() const { return TetId{bits_ >> 2}; }
  [[nodiscard]] constexpr int face() const { return static_cast<int>(bits_ & 3); }
  [[nodiscard]] constexpr TriangleId triangle() const { return TriangleId{bits_ & ~triangle_bit}; }
  /// For sorting: triangles come after faces.
  [[nodiscard]] constexpr std::uint32_t bits() const { return bits_; }
  constexpr bool operator==(const FaceLink&) const = default;

private:
  static constexpr std::uint32_t triangle_bit = 0x80000000U;
  explicit constexpr FaceLink(std::uint32_t bits) : bits_(bits) {}
  std::uint32_t bits_ = ~std::uint32_t{0};
};

/// As a side of a triangle: no tetrahedron is there.
inline constexpr FaceLink outside{};

/// Where a vertex lies on the geometry, and therefore where it may move: in the volume, on a patch, on a line, at a
/// corner.
class Tag {
public:
  constexpr Tag() = default;  ///< in the volume
  static constexpr Tag on_patch(PatchId patch) { return {2, patch}; }
  static constexpr Tag on_line(LineId line) { return {1, line}; }
  static constexpr Tag at_corner(CornerId corner) { return {0, corner}; }

  /// Of what the vertex lives on: 3 the volume, 2 a patch, 1 a line, 0 a corner.
  [[nodiscard]] constexpr int dimension() const { return static_cast<int>(dimension_); }
  [[nodiscard]] constexpr bool is_in_volume() const { return dimension_ == 3; }
  [[nodiscard]] constexpr bool is_on_patch() const { return dimension_ == 2; }
  [[nodiscard]] constexpr bool is_on_line() const { return dimension_ == 1; }
  [[nodiscard]] constexpr bool is_at_corner() const { return dimension_ == 0; }
  [[nodiscard]] constexpr PatchId patch() const { return PatchId{id_}; }
  [[nodiscard]] constexpr LineId line() const { return LineId{id_}; }
  [[nodiscard]] constexpr CornerId corner() const { return CornerId{id_}; }
  constexpr bool operator==(const Tag&) const = default;

private:
  constexpr Tag(std::uint32_t dimension, std::uint32_t id) : dimension_(dimension & 3U), id_(id & 0x3fffffffU) {}
  std::uint32_t dimension_ : 2 = 3;
  std::uint32_t id_ : 30 = 0;
};

/// Vertices of the face opposite to each vertex, outward for a positive tetrahedron.
inline constexpr std::array<std::array<int, 3>, 4> face_vertices = {{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// End points of each edge.
inline constexpr std::array<std::array<int, 2>, 6> edge_vertices = {{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// The edge between two different vertices.
inline constexpr std::array<std::array<std::uint8_t, 4>, 4> edge_between = {
    {{9, 0, 1, 2}, {0, 9, 3, 4}, {1, 3, 9, 5}, {2, 4, 5, 9}}};

/// Whether two triples list the same vertices in the same sense of rotation.
template <class Id>
constexpr bool same_cycle(const std::array<Id, 3>& a, const std::array<Id, 3>& b) {
  return (a[0] == b[0] && a[1] == b[1] && a[2] == b[2]) || (a[0] == b[1] && a[1] == b[2] && a[2] == b[0]) ||
         (a[0] == b[2] && a[1] == b[0] && a[2] == b[1]);
}

}  // namespace taut
