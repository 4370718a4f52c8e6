// Cuts a mesh into blocks for one round, and joins it again.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/tet_mesh.hpp"
#include "partition/block.hpp"

namespace taut {

class Blocks {
public:
  explicit Blocks(TetMesh& mesh) : mesh_(mesh) {}
  Blocks(const Blocks&) = delete;
  Blocks& operator=(const Blocks&) = delete;

  /// Cuts the mesh into blocks of about `block_size` vertices (0: a single block), at different places in every round.
  void cut(std::size_t block_size, unsigned round);

  /// Gives the blocks ids for new entities. No array grows until close().
  void lend(const std::vector<IdNeed>& needs);

  /// Returns the unused ids to the mesh, in the order of the blocks, and removes the blocks.
  void close();

  [[nodiscard]] std::size_t size() const { return blocks_.size(); }
  [[nodiscard]] Block& operator[](std::size_t i) { return blocks_[i]; }

  /// Living entities of the whole mesh.
  [[nodiscard]] std::size_t vertex_count() const;
  [[nodiscard]] std::size_t tet_count() const;

private:
  void assign_vertices(std::size_t block_size, unsigned round);
  void assign_tets();

  TetMesh& mesh_;
  std::vector<Block> blocks_;
  std::vector<std::uint16_t> owner_;   // of each vertex
  std::vector<std::uint8_t> at_seam_;  // of each vertex: whether one of its tetrahedra has several owners
};

}  // namespace taut
