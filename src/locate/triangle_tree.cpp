#include "locate/triangle_tree.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

#include "base/parallel.hpp"

namespace taut {
namespace {

constexpr std::size_t most_in_leaf = 2;

std::size_t depth_for(std::size_t leaves) {
  std::size_t depth = 0;
  while (leaves > (most_in_leaf << depth)) ++depth;
  return depth;
}

}  // namespace

struct TriangleTree::Centre {
  Vec3 x;
  Index triangle;
};

TriangleTree::TriangleTree(std::span<const Vec3> points, std::span<const std::array<Index, 3>> triangles,
                           std::span<const double> slack)
    : count_(triangles.size()), depth_(depth_for(count_)) {
  assert(!triangles.empty());
  std::vector<Centre> centres(triangles.size());
  for_each_index(centres.size(), [&](std::size_t t) {
    const auto& [a, b, c] = triangles[t];
    centres[t] = {(1.0 / 3) * (points[a] + points[b] + points[c]), static_cast<Index>(t)};
  });
  split(centres);
  set_leaves(points, triangles, slack, centres);
  set_boxes();
}

// Halves differ by at most one leaf.
TriangleTree::Range TriangleTree::range_of(std::size_t level, std::size_t place) const {
  return {(count_ * place) >> level, (count_ * (place + 1)) >> level};
}

// Sorts the centres into the order of the leaves: level by level, each node is halved across the longest side of the
// box around its centres.
void TriangleTree::split(std::vector<Centre>& centres) const {
  const auto at = [&](std::size_t i) { return centres.begin() + static_cast<std::ptrdiff_t>(i); };
  for (std::size_t level = 0; level < depth_; ++level) {
    for_each_task(std::size_t{1} << level, [&](std::size_t place, int) {
      const auto [begin, end] = range_of(level, place);
      Box around;
      for (std::size_t i = begin; i < end; ++i) around.include(centres[i].x);
      const Vec3 sides = around.high - around.low;
      const auto axis = static_cast<std::size_t>(std::max_element(sides.begin(), sides.end()) - sides.begin());
      const auto is_before = [axis](const Centre& a, const Centre& b) {
        return a.x[axis] != b.x[axis] ? a.x[axis] < b.x[axis] : a.triangle < b.triangle;
      };
      std::nth_element(at(begin), at(range_of(level + 1, 2 * place).end), at(end), is_before);
    });
  }
}

void TriangleTree::set_leaves(std::span<const Vec3> points, std::span<const std::array<Index, 3>> triangles,
                              std::span<const double> slack, const std::vector<Centre>& centres) {
  leaves_.resize(count_);
  leaf_of_.resize(count_);
  for_each_index(count_, [&](std::size_t leaf) {
    const Index triangle = centres[leaf].triangle;
    const auto& [a, b, c] = triangles[triangle];
    leaves_[leaf] = {{points[a], points[b], points[c]}, slack.empty() ? 0 : slack[triangle], triangle};
    leaf_of_[triangle] = static_cast<Index>(leaf);
  });
}

void TriangleTree::set_boxes() {
  const std::size_t lowest = std::size_t{1} << depth_;
  boxes_.resize(2 * lowest);
  for_each_index(lowest, [&](std::size_t place) {
    const auto [begin, end] = range_of(depth_, place);
    Box box;
    for (std::size_t i = begin; i < end; ++i)
      for (const Vec3& corner : leaves_[i].corners) {
        const Vec3 margin = {leaves_[i].slack, leaves_[i].slack, leaves_[i].slack};
        box.include(Box{corner - margin, corner + margin});
      }
    boxes_[lowest + place] = box;
  });
  for (std::size_t node = lowest - 1; node > 0; --node) {
    boxes_[node].include(boxes_[2 * node]);
    boxes_[node].include(boxes_[2 * node + 1]);
  }
}

TriangleTree::Nearest TriangleTree::closest(const Vec3& x, Index guess) const {
  Nearest best{.squared_distance = std::numeric_limits<double>::infinity()};
  try_leaf(x, leaf_of_[guess], best);
  descend(x, best.squared_distance, [&](std::size_t leaf) { try_leaf(x, leaf, best); });
  return best;
}

void TriangleTree::try_leaf(const Vec3& x, std::size_t leaf, Nearest& best) const {
  const Leaf& of = leaves_[leaf];
  const OnTriangle at = closest_on_triangle(x, of.corners);
  if (at.squared_distance > best.squared_distance) return;
  if (at.squared_distance == best.squared_distance && of.triangle >= best.triangle) return;
  best = {of.triangle, at.point, at.weights, at.squared_distance};
}

}  // namespace taut
