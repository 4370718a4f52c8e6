#include "geometry/model.hpp"

#include <algorithm>
#include <utility>

#include "base/each_once.hpp"

namespace taut {
namespace {

template <class Id>
bool contains(const std::vector<Id>& ids, Id id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

struct Projection {
  const PlacedSurface& surface;
  const Vec3& x;
  SeatId& seat;
  Vec3 operator()(const Frozen&) const { return x; }
  Vec3 operator()(const Plane& plane) const { return x - (dot(plane.normal, x) - plane.offset) * plane.normal; }
  Vec3 operator()(const Curved& curved) const { return surface.closest_on(curved, x, seat).point; }
  Vec3 operator()(const Straight& line) const {
    return line.origin + dot(x - line.origin, line.direction) * line.direction;
  }
  Vec3 operator()(const Bent& line) const { return surface.closest_on(line, x, seat).point; }
};

struct Normal {
  const PlacedSurface& surface;
  const Vec3& x;
  Vec3 operator()(const Frozen&) const { return {}; }
  Vec3 operator()(const Plane& plane) const { return plane.normal; }
  Vec3 operator()(const Curved& curved) const { return curved.sign * surface.closest_on(curved, x).normal; }
};

}  // namespace

CornerId Model::add_corner(Corner corner) {
  std::erase_if(corner.patches, [&](PatchId p) { return patches[p].frozen(); });
  std::erase_if(corner.lines, [&](LineId l) { return lines[l].frozen; });
  keep_each_once(corner.patches);
  keep_each_once(corner.lines);
  if (corner.patches.empty() && corner.lines.empty()) return shared_corner;
  corners.push_back(std::move(corner));
  return static_cast<CornerId>(corners.size() - 1);
}

bool Model::on_patch(Tag tag, PatchId patch) const {
  if (tag.is_in_volume() || patches[patch].frozen()) return false;
  if (tag.is_on_patch()) return tag.patch() == patch;
  return contains(tag.is_on_line() ? lines[tag.line()].patches : corners[tag.corner()].patches, patch);
}

bool Model::on_line(Tag tag, LineId line) const {
  if (tag.is_in_volume() || tag.is_on_patch() || lines[line].frozen) return false;
  return tag.is_on_line() ? tag.line() == line : contains(corners[tag.corner()].lines, line);
}

int Model::sides_of(LineId line, PatchId patch) const {
  return static_cast<int>(std::ranges::count(lines[line].patches, patch));
}

Vec3 Model::project(Tag tag, const Vec3& x, SeatId& seat) const {
  if (tag.is_on_patch()) return std::visit(Projection{surface, x, seat}, patches[tag.patch()].shape);
  if (tag.is_on_line()) return std::visit(Projection{surface, x, seat}, lines[tag.line()].shape);
  return tag.is_at_corner() ? corners[tag.corner()].place.value_or(x) : x;
}

Vec3 Model::normal(Tag tag, const Vec3& x) const {
  return tag.is_on_patch() ? std::visit(Normal{surface, x}, patches[tag.patch()].shape) : Vec3{};
}

}  // namespace taut
