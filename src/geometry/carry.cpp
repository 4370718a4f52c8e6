#include "geometry/carry.hpp"

#include <algorithm>
#include <optional>

namespace taut {
namespace {

// The motion that all vertices of a patch have in common, for each patch; `none` if there is none.
std::vector<std::uint32_t> motions_of_patches(const Model& model, const TetMesh& mesh, const RigidMoves& moves) {
  std::vector<std::optional<std::uint32_t>> common(model.patches.size());
  for (const Triangle& t : mesh.triangles) {
    if (!t.alive()) continue;
    std::optional<std::uint32_t>& motion = common[t.patch];
    for (const VertexId v : t.v)
      if (motion.value_or(moves.of_vertex[v]) == moves.of_vertex[v])
        motion = moves.of_vertex[v];
      else
        motion = std::uint32_t{none};
  }
  std::vector<std::uint32_t> motions;
  motions.reserve(common.size());
  for (const auto& motion : common) motions.push_back(motion.value_or(std::uint32_t{none}));
  return motions;
}

// That of all patches of a line.
std::uint32_t motion_of(const Line& line, const std::vector<std::uint32_t>& of_patch) {
  if (line.patches.empty()) return none;
  const std::uint32_t first = of_patch[line.patches[0]];
  return std::ranges::all_of(line.patches, [&](PatchId p) { return of_patch[p] == first; }) ? first : none;
}

}  // namespace

Carried carry(Model& model, const TetMesh& mesh, const RigidMoves& moves) {
  Carried carried{std::vector<std::uint8_t>(model.patches.size(), 0), std::vector<std::uint8_t>(model.lines.size(), 0)};
  if (moves.motions.empty() || !model.surface.exists()) return carried;
  const std::vector<std::uint32_t> of_patch = motions_of_patches(model, mesh, moves);
  for (std::size_t p = 0; p < of_patch.size(); ++p) {
    auto* const curved = std::get_if<Curved>(&model.patches[p].shape);
    if (curved == nullptr || of_patch[p] == none) continue;
    curved->placement.move(moves.motions[of_patch[p]]);
    carried.patch[p] = 1;
  }
  for (std::size_t l = 0; l < model.lines.size(); ++l) {
    auto* const bent = std::get_if<Bent>(&model.lines[l].shape);
    const std::uint32_t motion = motion_of(model.lines[l], of_patch);
    if (bent == nullptr || motion == none) continue;
    bent->placement.move(moves.motions[motion]);
    carried.line[l] = 1;
  }
  return carried;
}

}  // namespace taut
