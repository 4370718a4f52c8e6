#include "partition/blocks.hpp"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <limits>
#include <utility>

#include "base/grouping.hpp"
#include "base/parallel.hpp"
#include "partition/bisection.hpp"

namespace taut {
namespace {

constexpr std::uint32_t nobody = none;
constexpr std::size_t most_blocks = std::numeric_limits<std::uint16_t>::max();  // this number itself means no block

// Several workers may mark the same vertex: they write the same value.
void mark(std::uint8_t& flag) {
  std::atomic_ref(flag).store(1, std::memory_order_relaxed);
}

}  // namespace

void Blocks::cut(std::size_t block_size, unsigned round) {
  assert(blocks_.empty());
  assign_vertices(block_size, round);
  assign_tets();
}

void Blocks::assign_vertices(std::size_t block_size, unsigned round) {
  const std::size_t count = mesh_.vertices.size();
  const std::size_t least = count / most_blocks + 1;
  const Bisection bisection(mesh_, block_size == 0 ? count + 1 : std::max(block_size, least), round);
  for (std::uint32_t b = 0; b < bisection.parts(); ++b) blocks_.emplace_back(b, owner_, at_seam_);
  std::vector<std::uint32_t> owner(count, nobody);
  owner_.resize(count);
  for_each_index(count, [&](std::size_t v) {
    if (mesh_.is_vertex_alive(static_cast<VertexId>(v))) owner[v] = bisection.part_of(mesh_.vertices[v].x);
    owner_[v] = static_cast<std::uint16_t>(owner[v]);
  });
  at_seam_.assign(count, 0);
  auto groups = group<VertexId>(owner, blocks_.size());
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const std::size_t used = groups[b].size();
    blocks_[b].vertices = IdPool<VertexId>(std::move(groups[b]), used);
  }
}

// Tetrahedra with several owners form a second group, by the owner of their first vertex.
void Blocks::assign_tets() {
  const auto parts = static_cast<std::uint32_t>(blocks_.size());
  std::vector<std::uint32_t> group_of(mesh_.tets.size(), nobody);
  for_each_index(mesh_.tets.size(), [&](std::size_t t) {
    const Tet& tet = mesh_.tets[t];
    if (!tet.alive()) return;
    const std::uint32_t first = owner_[tet.v[0]];
    const bool shared = owner_[tet.v[1]] != first || owner_[tet.v[2]] != first || owner_[tet.v[3]] != first;
    group_of[t] = first + (shared ? parts : 0);
    if (!shared) return;
    for (VertexId v : tet.v) mark(at_seam_[v]);
  });
  auto groups = group<TetId>(group_of, std::size_t{2} * parts);
  for (std::uint32_t b = 0; b < parts; ++b) {
    const std::size_t used = groups[b].size();
    blocks_[b].tets = IdPool<TetId>(std::move(groups[b]), used);
    blocks_[b].shared_tets = std::move(groups[b + parts]);
  }
}

void Blocks::lend(const std::vector<IdNeed>& needs) {
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    Block& block = blocks_[b];
    block.borrow(mesh_, needs[b]);
    owner_.resize(mesh_.vertices.size());
    at_seam_.resize(mesh_.vertices.size(), 0);
    for (VertexId v : block.vertices.unused()) {
      owner_[v] = static_cast<std::uint16_t>(b);
      at_seam_[v] = 0;
    }
  }
}

// The last block comes first, so that the ids of the first block are on top for the next first block.
void Blocks::close() {
  for (auto block = blocks_.rbegin(); block != blocks_.rend(); ++block) block->give_back(mesh_);
  blocks_.clear();
}

std::size_t Blocks::vertex_count() const {
  std::size_t count = mesh_.vertex_count();
  for (const Block& block : blocks_) count -= block.vertices.available();
  return count;
}

std::size_t Blocks::tet_count() const {
  std::size_t count = mesh_.tet_count();
  for (const Block& block : blocks_) count -= block.tets.available();
  return count;
}

}  // namespace taut
