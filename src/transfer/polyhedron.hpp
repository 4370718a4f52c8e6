// The intersection of two tetrahedra.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace taut {

using Weights4 = std::array<double, 4>;

/// A convex polyhedron in a tetrahedron, as a graph whose vertices have three neighbours each (Powell and Abel 2015,
/// "An exact general remeshing scheme applied to physically conservative voxelization"). Clipping decides by the signs
/// at the vertices alone, so rounding can make it imprecise, never inconsistent.
class Polyhedron {
public:
  /// A vertex has weights in two tetrahedra: the `own` one that the polyhedron was cut from, the `other` one that cut
  /// it. They are not negative in the end: integrals of their products have no cancellation.
  struct Vertex {
    Weights4 own, other;
    std::array<std::uint8_t, 3> next;  ///< neighbours, clockwise from outside
  };

  /// A whole tetrahedron, whose corners have the weights `other` in another one.
  explicit Polyhedron(const std::array<Weights4, 4>& other);

  /// Removes what lies outside the other tetrahedron. False if nothing is left.
  [[nodiscard]] bool clip();

  [[nodiscard]] std::span<const Vertex> vertices() const { return {vertices_.data(), count_}; }

  /// Calls visit(first, second, third) with the vertices of triangles that make up all faces, except those at vertex 0.
  template <class Visit>
  void for_each_triangle_seen_from_first(Visit visit) const;

  /// The intersection has at most 12 vertices. Before the clipped ones are removed there may be more: at most 43, even
  /// if rounding made all signs random.
  static constexpr std::size_t most = 48;

private:
  [[nodiscard]] bool clip_by(std::size_t weight);
  void cut_edges(std::size_t weight, const std::array<bool, most>& clipped);
  void link_cut(std::size_t first);
  void compress(const std::array<bool, most>& clipped, std::size_t old_count);
  [[nodiscard]] std::size_t index_in(std::size_t of, std::size_t neighbour) const {
    const auto& next = vertices_[of].next;
    return next[0] == neighbour ? 0 : next[1] == neighbour ? 1 : 2;
  }

  std::array<Vertex, most> vertices_;
  std::size_t count_ = 4;
};

// Each face is walked once, from each of its directed edges that has not been walked.
template <class Visit>
void Polyhedron::for_each_triangle_seen_from_first(Visit visit) const {
  std::array<std::uint8_t, most> walked;  // one bit for each of the three edges
  std::fill_n(walked.begin(), count_, std::uint8_t{0});
  for (std::size_t start = 0; start < count_; ++start) {
    for (std::size_t edge = 0; edge < 3; ++edge) {
      if ((walked[start] >> edge & 1) != 0) continue;
      std::array<std::uint8_t, most> loop;
      std::size_t length = 0;
      bool at_first = false;
      std::size_t at = start, along = edge;
      do {
        walked[at] = static_cast<std::uint8_t>(walked[at] | 1U << along);
        at_first |= at == 0;
        loop[length++] = static_cast<std::uint8_t>(at);
        const std::size_t next = vertices_[at].next[along];
        along = (index_in(next, at) + 1) % 3;
        at = next;
      } while (at != start || along != edge);
      if (at_first) continue;
      for (std::size_t i = 2; i < length; ++i) visit(loop[0], loop[i - 1], loop[i]);
    }
  }
}

}  // namespace taut
