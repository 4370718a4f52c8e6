#include "geometry/model.hpp"

#include <algorithm>

namespace taut {
namespace {

bool contains(const std::vector<std::uint32_t>& ids, std::uint32_t id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

}  // namespace

bool Model::on_patch(Tag tag, PatchId patch) const {
  if (tag.dimension == 3 || patches[patch].frozen) return false;
  if (tag.dimension == 2) return tag.id == patch;
  return contains(tag.dimension == 1 ? lines[tag.id].patches : corners[tag.id].patches, patch);
}

bool Model::on_line(Tag tag, LineId line) const {
  if (tag.dimension > 1 || lines[line].frozen) return false;
  return tag.dimension == 1 ? tag.id == line : contains(corners[tag.id].lines, line);
}

Vec3 Model::project(Tag tag, const Vec3& x) const {
  if (tag.dimension == 2) {
    const Patch& patch = patches[tag.id];
    return x - (dot(patch.normal, x) - patch.offset) * patch.normal;
  }
  if (tag.dimension == 1) {
    const Line& line = lines[tag.id];
    return line.origin + dot(x - line.origin, line.direction) * line.direction;
  }
  return x;
}

}  // namespace taut
