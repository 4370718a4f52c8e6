// Which cells of a mesh may contain a point or meet a box: a search that no boundary can stop.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "base/box.hpp"
#include "locate/background.hpp"

namespace taut {

/// A binary tree of bounding boxes over the cells. The cells of a mesh in Hilbert order are compact in runs, so the
/// tree takes them in their order and needs no sort.
class CellTree {
public:
  explicit CellTree(const Background& mesh);

  /// The box around the whole mesh.
  [[nodiscard]] const Box& around() const { return boxes_[1]; }

  /// Calls visit(cell) for each cell whose bounding box may meet `box`, in ascending order.
  template <class Visit>
  void for_each_near(const Box& box, Visit visit) const;

private:
  static constexpr std::size_t cells_in_leaf = 8;
  static constexpr std::size_t most_levels = 40;

  std::size_t cells_;
  std::size_t lowest_ = 1;  ///< number of the first of the lowest nodes
  std::vector<Box> boxes_;  ///< node 1 is the root; 2 k and 2 k + 1 are below node k
};

template <class Visit>
void CellTree::for_each_near(const Box& box, Visit visit) const {
  std::array<std::size_t, most_levels> stack;
  std::size_t height = 0;
  stack[height++] = 1;
  while (height > 0) {
    const std::size_t node = stack[--height];
    if (!boxes_[node].meets(box)) continue;
    if (node < lowest_) {
      stack[height++] = 2 * node + 1;
      stack[height++] = 2 * node;
      continue;
    }
    const std::size_t first = (node - lowest_) * cells_in_leaf;
    for (std::size_t c = first; c < std::min(first + cells_in_leaf, cells_); ++c) visit(static_cast<CellId>(c));
  }
}

}  // namespace taut
