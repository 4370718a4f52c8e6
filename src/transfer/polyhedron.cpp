#include "transfer/polyhedron.hpp"

#include <algorithm>
#include <cassert>

namespace taut {
namespace {

// The point where a weight that is `a` > 0 at one vertex and -b <= 0 at the other is 0. No term is subtracted, so what
// is 0 or not negative at both vertices is so here.
Weights4 between(const Weights4& x, const Weights4& y, double a, double b) {
  const double scale = 1 / (a + b);
  Weights4 mean;
  for (std::size_t k = 0; k < 4; ++k) mean[k] = (x[k] * b + y[k] * a) * scale;
  return mean;
}

}  // namespace

Polyhedron::Polyhedron(const std::array<Weights4, 4>& other) {
  constexpr std::array<std::array<std::uint8_t, 3>, 4> next = {{{1, 3, 2}, {2, 3, 0}, {0, 3, 1}, {1, 2, 0}}};
  for (std::size_t k = 0; k < 4; ++k) {
    vertices_[k] = {{}, other[k], next[k]};
    vertices_[k].own[k] = 1;
  }
}

bool Polyhedron::clip() {
  for (std::size_t weight = 0; weight < 4; ++weight)
    if (!clip_by(weight)) return false;
  return true;
}

bool Polyhedron::clip_by(std::size_t weight) {
  std::array<bool, most> clipped;
  bool any_clipped = false, any_inside = false;
  for (std::size_t v = 0; v < count_; ++v) {
    clipped[v] = vertices_[v].other[weight] < 0;
    any_clipped |= clipped[v];
    any_inside |= vertices_[v].other[weight] > 0;
  }
  if (!any_inside) return false;
  if (!any_clipped) return true;
  const std::size_t old_count = count_;
  cut_edges(weight, clipped);
  link_cut(old_count);
  compress(clipped, old_count);
  return true;
}

// A new vertex, linked to the vertex that is kept, on each edge from a vertex that is kept to one that is clipped.
void Polyhedron::cut_edges(std::size_t weight, const std::array<bool, most>& clipped) {
  const std::size_t old_count = count_;
  for (std::size_t v = 0; v < old_count; ++v) {
    if (clipped[v]) continue;
    for (std::uint8_t& next : vertices_[v].next) {
      if (!clipped[next]) continue;
      const Vertex &kept = vertices_[v], &lost = vertices_[next];
      const double a = kept.other[weight], b = -lost.other[weight];
      assert(count_ < most);
      Vertex& cut = vertices_[count_];
      cut.own = between(kept.own, lost.own, a, b);
      cut.other = between(kept.other, lost.other, a, b);
      cut.other[weight] = 0;
      cut.next[0] = static_cast<std::uint8_t>(v);
      next = static_cast<std::uint8_t>(count_++);
    }
  }
}

// Each new vertex is linked to the next one around its face, across the vertices that are kept.
void Polyhedron::link_cut(std::size_t first) {
  for (std::size_t start = first; start < count_; ++start) {
    std::size_t from = start, at = vertices_[start].next[0];
    while (at < first) {
      const std::size_t next = vertices_[at].next[(index_in(at, from) + 1) % 3];
      from = at;
      at = next;
    }
    vertices_[start].next[2] = static_cast<std::uint8_t>(at);
    vertices_[at].next[1] = static_cast<std::uint8_t>(start);
  }
}

void Polyhedron::compress(const std::array<bool, most>& clipped, std::size_t old_count) {
  std::array<std::uint8_t, most> renumbered;
  std::size_t kept = 0;
  for (std::size_t v = 0; v < count_; ++v) {
    if (v < old_count && clipped[v]) continue;
    renumbered[v] = static_cast<std::uint8_t>(kept);
    if (kept != v) vertices_[kept] = vertices_[v];
    ++kept;
  }
  count_ = kept;
  for (std::size_t v = 0; v < count_; ++v)
    for (std::uint8_t& next : vertices_[v].next) next = renumbered[next];
}

}  // namespace taut
