#include "locate/cell_tree.hpp"

#include "base/parallel.hpp"

namespace taut {

CellTree::CellTree(const Background& mesh) : cells_(mesh.cell_count()) {
  const Chunks leaves(cells_, cells_in_leaf);
  while (lowest_ < leaves.size()) lowest_ *= 2;
  boxes_.resize(2 * lowest_);
  for_each_index(leaves.size(), [&](std::size_t leaf) {
    for (std::size_t c = leaves.begin(leaf); c < leaves.end(leaf); ++c)
      for (const Vec3& corner : mesh.corners_of(static_cast<CellId>(c))) boxes_[lowest_ + leaf].include(corner);
  });
  for (std::size_t node = lowest_ - 1; node > 0; --node) {
    boxes_[node].include(boxes_[2 * node]);
    boxes_[node].include(boxes_[2 * node + 1]);
  }
}

}  // namespace taut
