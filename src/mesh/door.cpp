#include "mesh/door.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>
#include <span>

#include "base/parallel.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

// Users count from 1, as their files do.
template <std::size_t n>
std::string listed(std::array<Index, n> v) {
  for (Index& i : v) ++i;
  return fmt::format("{}", fmt::join(v, " "));
}

void require_length(const char* what, std::size_t found, std::size_t expected) {
  if (found == 0 || found == expected) return;
  throw InputError(fmt::format("{} references found, expected {}, one for each of the {}", found, expected, what));
}

template <std::size_t n>
void require_range(const char* what, const std::vector<std::array<Index, n>>& entities, std::size_t points) {
  for_each_index(entities.size(), [&](std::size_t e) {
    const auto& v = entities[e];
    for (std::size_t k = 0; k < n; ++k) {
      if (v[k] >= points)
        throw InputError(
            fmt::format("{} {}: vertex {} found, expected 1..{}", what, e + 1, std::size_t{v[k]} + 1, points));
      for (std::size_t j = 0; j < k; ++j)
        if (v[j] == v[k])
          throw InputError(fmt::format("{} {} ({}) repeats vertex {}", what, e + 1, listed(v), v[k] + 1));
    }
  });
}

void require_marks(const char* what, std::span<const Index> marks, std::size_t size) {
  for (std::size_t i = 0; i < marks.size(); ++i)
    if (marks[i] >= size)
      throw InputError(fmt::format("{} {}: {} found, expected 1..{}", what, i + 1, std::size_t{marks[i]} + 1, size));
}

void require_finite(const std::vector<Point>& points) {
  for_each_index(points.size(), [&](std::size_t i) {
    for (double x : points[i])
      if (!std::isfinite(x)) throw InputError(fmt::format("vertex {}: coordinate {} is not finite", i + 1, x));
  });
}

}  // namespace

void require_sound_arrays(const Mesh& m) {
  if (m.tetrahedra.empty()) throw InputError("the mesh has no tetrahedra");
  require_sound_entities(m);
}

void require_sound_entities(const Mesh& m) {
  if (m.points.size() >= std::numeric_limits<Index>::max())
    throw InputError(fmt::format("{} vertices found, more than 32-bit ids can number", m.points.size()));
  require_length("vertices", m.point_refs.size(), m.points.size());
  require_length("tetrahedra", m.tetrahedron_refs.size(), m.tetrahedra.size());
  require_length("triangles", m.triangle_refs.size(), m.triangles.size());
  require_length("edges", m.edge_refs.size(), m.edges.size());
  require_finite(m.points);
  require_range("tetrahedron", m.tetrahedra, m.points.size());
  require_range("triangle", m.triangles, m.points.size());
  require_range("edge", m.edges, m.points.size());
  require_marks("corner", m.corners, m.points.size());
  require_marks("required vertex", m.required_points, m.points.size());
  require_marks("ridge", m.ridges, m.edges.size());
  require_marks("required edge", m.required_edges, m.edges.size());
  require_marks("required triangle", m.required_triangles, m.triangles.size());
  require_marks("required tetrahedron", m.required_tetrahedra, m.tetrahedra.size());
}

void require_region_count(std::size_t regions) {
  constexpr std::size_t most = std::numeric_limits<std::uint16_t>::max();
  if (regions > most) throw InputError(fmt::format("{} regions found, expected at most {}", regions, most));
}

void throw_flat(std::size_t tet, const std::array<Index, 4>& v) {
  throw InputError(fmt::format("tetrahedron {} ({}) is flat: its volume is exactly zero", tet + 1, listed(v)));
}

void throw_overlap(std::size_t tet, const std::array<Index, 4>& v, std::size_t neighbour,
                   const std::array<Index, 4>& w) {
  throw InputError(
      fmt::format("tetrahedron {} ({}) overlaps its neighbour, tetrahedron {} ({}): both lie on the same side of their "
                  "common face, the mesh is tangled",
                  tet + 1, listed(v), neighbour + 1, listed(w)));
}

void throw_no_face(std::size_t triangle, const std::array<Index, 3>& v) {
  throw InputError(fmt::format("triangle {} ({}) is not a face of any tetrahedron", triangle + 1, listed(v)));
}

void throw_duplicate(std::size_t triangle, std::size_t other) {
  throw InputError(fmt::format("triangle {} repeats triangle {}", triangle + 1, other + 1));
}

void throw_crowded_face(const std::array<Index, 3>& v) {
  throw InputError(fmt::format("face ({}) is shared by more than two tetrahedra", listed(v)));
}

}  // namespace taut
