// Changes by hand to a mesh under work.
#pragma once

#include "partition/block.hpp"

namespace taut::test {

/// Calls change(block), the whole mesh being one block with a few ids to spare.
template <class Change>
void change_whole(TetMesh& mesh, Change change) {
  Block block;
  block.borrow(mesh, {.vertices = 2, .tets = 1, .triangles = 1});
  change(block);
  block.give_back(mesh);
}

}  // namespace taut::test
