// Manual changes to a working mesh.
#pragma once

#include "partition/block.hpp"

namespace taut::test {

/// Calls change(block) with the whole mesh as one block, which has a few spare ids.
template <class Change>
void change_whole(TetMesh& mesh, Change change) {
  Block block;
  block.borrow(mesh, {.vertices = 2, .tets = 1, .triangles = 1});
  change(block);
  block.give_back(mesh);
}

}  // namespace taut::test
