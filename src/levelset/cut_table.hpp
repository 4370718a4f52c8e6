// How a level set cuts a tetrahedron, for all signs that a linear function can have at its four vertices.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "base/ids.hpp"

namespace taut {

/// Of the difference to the level at each vertex: -1, 0 or 1.
using Signs = std::array<int, 4>;

/// A polygon in a tetrahedron whose vertices are on different sides of the level. Its normal points to larger values if
/// the tetrahedron is positive.
struct Cut {
  std::size_t count = 0;  ///< of corners: 0, 3 or 4
  /// The corners lie on edges (0 to 5, the places in edge_vertices) and at vertices on the level (6 to 9), in turn.
  std::array<std::size_t, 4> corners{};
};

namespace detail {

using Steps = std::array<int, 3>;

/// The vertices between which a corner lies; twice the same for one that lies at a vertex.
constexpr std::array<int, 2> ends_of(std::size_t corner) {
  if (corner < 6) return edge_vertices[corner];
  return {static_cast<int>(corner) - 6, static_cast<int>(corner) - 6};
}

/// Twice the place of a corner in the tetrahedron (0 0 0), (1 0 0), (0 1 0), (0 0 1), if edges are cut in the middle.
constexpr Steps place_of(std::size_t corner) {
  Steps place{};
  for (const int v : ends_of(corner))
    if (v > 0) ++place[static_cast<std::size_t>(v) - 1];
  return place;
}

constexpr bool share_a_vertex(std::size_t corner, std::size_t other) {
  for (const int v : ends_of(corner))
    for (const int w : ends_of(other))
      if (v == w) return true;
  return false;
}

/// Twice the volume of the tetrahedron of the first three corners and their first moved along the gradient.
constexpr int towards_larger(const Cut& cut, const Signs& s) {
  const Steps a = place_of(cut.corners[0]), b = place_of(cut.corners[1]), c = place_of(cut.corners[2]);
  const Steps u = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  return (u[1] * v[2] - u[2] * v[1]) * (s[1] - s[0]) + (u[2] * v[0] - u[0] * v[2]) * (s[2] - s[0]) +
         (u[0] * v[1] - u[1] * v[0]) * (s[3] - s[0]);
}

constexpr Cut corners_on_level(const Signs& s) {
  Cut cut;
  for (std::size_t corner = 0; corner < 10; ++corner) {
    const auto [i, j] = ends_of(corner);
    if (corner < 6 ? s[i] * s[j] < 0 : s[i] == 0) cut.corners[cut.count++] = corner;
  }
  return cut;
}

constexpr Cut cut_at(const Signs& s) {
  const bool is_cut = std::ranges::find(s, -1) != s.end() && std::ranges::find(s, 1) != s.end();
  if (!is_cut) return {};
  Cut cut = corners_on_level(s);
  // Neighbours in a quadrilateral lie on a common face, so their edges share a vertex; opposite corners do not.
  if (cut.count == 4 && !share_a_vertex(cut.corners[0], cut.corners[1])) std::swap(cut.corners[1], cut.corners[2]);
  if (cut.count == 4 && !share_a_vertex(cut.corners[1], cut.corners[2])) std::swap(cut.corners[2], cut.corners[3]);
  if (towards_larger(cut, s) < 0) std::reverse(cut.corners.begin(), cut.corners.begin() + cut.count);
  return cut;
}

}  // namespace detail

inline constexpr std::size_t sign_patterns = 81;

/// The row of the table.
constexpr std::size_t pattern_of(const Signs& s) {
  const int pattern = s[0] + 1 + 3 * (s[1] + 1) + 9 * (s[2] + 1) + 27 * (s[3] + 1);
  return static_cast<std::size_t>(pattern);
}

constexpr Signs signs_of(std::size_t pattern) {
  const int p = static_cast<int>(pattern);
  return {p % 3 - 1, p / 3 % 3 - 1, p / 9 % 3 - 1, p / 27 - 1};
}

/// The cut for each pattern of signs.
inline constexpr std::array<Cut, sign_patterns> cuts = [] {
  std::array<Cut, sign_patterns> table;
  for (std::size_t pattern = 0; pattern < sign_patterns; ++pattern) table[pattern] = detail::cut_at(signs_of(pattern));
  return table;
}();

}  // namespace taut
