// The closest point on a set of triangles.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/vec3.hpp"
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

  /// At least one triangle; indices in range and finite coordinates. Triangles may be flat, or single points.
  TriangleTree(std::span<const Vec3> points, std::span<const std::array<Index, 3>> triangles);

  /// The minimum over all triangles, to the last bit: the boxes pass over only what is farther. A good `guess`, such as
  /// the triangle found for a point nearby, makes the search faster and does not change the answer.
  [[nodiscard]] Nearest closest(const Vec3& x, Index guess = 0) const;

private:
  struct Box {
    Vec3 low, high;
  };
  struct Leaf {
    std::array<Vec3, 3> corners;
    Index triangle;
  };
  struct Centre;

  /// The leaves below a node of the tree. All branches have the same depth, so that no node stores links.
  struct Range {
    std::size_t begin, end;
  };

  [[nodiscard]] Range range_of(std::size_t level, std::size_t place) const;
  void split(std::vector<Centre>& centres) const;
  void set_leaves(std::span<const Vec3> points, std::span<const std::array<Index, 3>> triangles,
                  const std::vector<Centre>& centres);
  void set_boxes();
  void try_leaf(const Vec3& x, std::size_t leaf, Nearest& best) const;

  std::size_t count_, depth_;   ///< number of triangles, level of the lowest nodes
  std::vector<Box> boxes_;      ///< node 1 is the root, 2 k and 2 k + 1 are below node k
  std::vector<Leaf> leaves_;    ///< in the order of the lowest nodes
  std::vector<Index> leaf_of_;  ///< of each triangle
};

}  // namespace taut
