// The closest point on a set of triangles.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/box.hpp"
#include "base/vec3.hpp"
#include "locate/closest_on_triangle.hpp"
#include "taut/mesh.hpp"

namespace taut {

/// A tree of bounding boxes over triangles. It keeps what it needs: the arrays that it is built from may go.
class TriangleTree {
public:
  /// The place on the triangles that is closest to some point.
  struct Nearest {
    Index triangle = 0;               ///< of several equally close ones the first
    Vec3 point{};                     ///< on it
    std::array<double, 3> weights{};  ///< of its vertices: none negative, of sum 1
    double squared_distance = 0;
  };

  /// At least one triangle; indices in range and finite coordinates. Triangles may be flat, or single points. `slack`
  /// says for each triangle how far what it stands for, a curved patch, may be from it; without it: not at all.
  TriangleTree(std::span<const Vec3> points, std::span<const std::array<Index, 3>> triangles,
               std::span<const double> slack = {});

  /// The minimum over all triangles, to the last bit: the boxes pass over only what is farther. A good `guess`, such as
  /// the triangle found for a point nearby, makes the search faster and does not change the answer.
  [[nodiscard]] Nearest closest(const Vec3& x, Index guess = 0) const;

  /// Finds what the triangles stand for: calls visit(triangle, OnTriangle), which returns its distance from x, for all
  /// triangles for which this may be the least and at most `bound`, those that are flat near first. A good guess
  /// makes it faster.
  template <class Visit>
  void search(const Vec3& x, std::optional<Index> guess, double bound, Visit visit) const;

  /// A lower bound of the distance of x from all triangles and what they stand for.
  [[nodiscard]] double distance_bound(const Vec3& x) const { return std::sqrt(squared_distance(x, boxes_[1])); }

private:
  struct Leaf {
    std::array<Vec3, 3> corners;
    double slack;
    Index triangle;
  };
  struct Centre;
  template <class Visit>
  class Search;

  static constexpr std::size_t most_levels = 40;

  /// The squared distance of x from a box. It has the operations and the order of OnTriangle::squared_distance, and
  /// rounding is monotone: it never exceeds the distance of a point in the box.
  [[nodiscard]] static double squared_distance(const Vec3& x, const Box& box) {
    Vec3 away;
    for (std::size_t d = 0; d < 3; ++d) away[d] = x[d] - std::clamp(x[d], box.low[d], box.high[d]);
    return dot(away, away);
  }

  /// The leaves below a node of the tree. All branches have the same depth, so that no node stores links.
  struct Range {
    std::size_t begin, end;
  };

  [[nodiscard]] Range range_of(std::size_t level, std::size_t place) const;
  void split(std::vector<Centre>& centres) const;
  void set_leaves(std::span<const Vec3> points, std::span<const std::array<Index, 3>> triangles,
                  std::span<const double> slack, const std::vector<Centre>& centres);
  void set_boxes();
  void try_leaf(const Vec3& x, std::size_t leaf, Nearest& best) const;
  template <class Try>
  void descend(const Vec3& x, const double& squared_bound, Try try_leaf) const;

  std::size_t count_, depth_;   ///< number of triangles, level of the lowest nodes
  std::vector<Box> boxes_;      ///< node 1 is the root, 2 k and 2 k + 1 are below node k
  std::vector<Leaf> leaves_;    ///< in the order of the lowest nodes
  std::vector<Index> leaf_of_;  ///< of each triangle
};

/// Calls try_leaf(leaf) where boxes are not farther than the bound, which may fall meanwhile; near boxes first.
template <class Try>
void TriangleTree::descend(const Vec3& x, const double& squared_bound, Try try_leaf) const {
  struct Open {
    std::size_t node;
    double squared_distance;
  };
  const auto open = [&](std::size_t node) { return Open{node, squared_distance(x, boxes_[node])}; };
  std::array<Open, most_levels> stack;
  std::size_t height = 0;
  stack[height++] = open(1);
  while (height > 0) {
    const auto [node, distance] = stack[--height];
    if (distance > squared_bound) continue;
    if (node >> depth_ != 0) {
      const auto [begin, end] = range_of(depth_, node - (std::size_t{1} << depth_));
      for (std::size_t leaf = begin; leaf < end; ++leaf) try_leaf(leaf);
      continue;
    }
    Open near = open(2 * node), far = open(2 * node + 1);
    if (far.squared_distance < near.squared_distance) std::swap(near, far);
    stack[height++] = far;
    stack[height++] = near;
  }
}

/// Visits cost more than flat triangles do: candidates are gathered first, so that the nearest one rules out most.
template <class Visit>
class TriangleTree::Search {
public:
  Search(const Vec3& x, double bound, Visit& visit)
      : x_(x), visit_(visit), bound_(bound), squared_bound_(bound * bound) {}

  /// The least distance is no larger.
  [[nodiscard]] const double& squared_bound() const { return squared_bound_; }

  void consider(const Leaf& leaf) {
    const OnTriangle at = closest_on_triangle(x_, leaf.corners);
    const double flat = std::sqrt(at.squared_distance);
    if (flat - leaf.slack > bound_) return;
    limit(flat + leaf.slack);
    if (count_ == candidates_.size()) visit_all();
    std::size_t place = count_++;
    for (; place > 0 && candidates_[place - 1].flat > flat; --place) candidates_[place] = candidates_[place - 1];
    candidates_[place] = {flat, leaf.slack, leaf.triangle, at};
  }

  void visit_all() {
    for (std::size_t i = 0; i < count_; ++i) {
      const Candidate& c = candidates_[i];
      if (c.flat - c.slack <= bound_) limit(visit_(c.triangle, c.at));
    }
    count_ = 0;
  }

private:
  struct Candidate {
    double flat, slack;
    Index triangle;
    OnTriangle at;
  };

  void limit(double distance) {
    bound_ = std::min(bound_, distance);
    squared_bound_ = bound_ * bound_;
  }

  const Vec3& x_;
  Visit& visit_;
  std::array<Candidate, 8> candidates_;
  std::size_t count_ = 0;
  double bound_, squared_bound_;
};

template <class Visit>
void TriangleTree::search(const Vec3& x, std::optional<Index> guess, double bound, Visit visit) const {
  Search<Visit> search(x, bound, visit);
  const std::size_t known = guess ? leaf_of_[*guess] : count_;
  if (guess) search.consider(leaves_[known]);
  descend(x, search.squared_bound(), [&](std::size_t leaf) {
    if (leaf != known) search.consider(leaves_[leaf]);
  });
  search.visit_all();
}

}  // namespace taut
