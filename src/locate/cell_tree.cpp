#include "locate/cell_tree.hpp"

#include "base/parallel.hpp"

namespace taut {

void Box::include(const Vec3& x) {
  for (std::size_t d = 0; d < 3; ++d) {
    low[d] = std::min(low[d], x[d]);
    high[d] = std::max(high[d], x[d]);
  }
}

void Box::include(const Box& other) {
  for (std::size_t d = 0; d < 3; ++d) {
    low[d] = std::min(low[d], other.low[d]);
    high[d] = std::max(high[d], other.high[d]);
  }
}

bool Box::meets(const Box& other) const {
  for (std::size_t d = 0; d < 3; ++d)
    if (low[d] > other.high[d] || high[d] < other.low[d]) return false;
  return true;
}

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
