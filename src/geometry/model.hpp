// The boundary that must be preserved: patches, lines and corners, and how they are connected.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

#include "base/ids.hpp"
#include "base/vec3.hpp"
#include "geometry/placed_surface.hpp"

namespace taut {

/// A patch on which nothing changes.
struct Frozen {};

/// normal . x = offset.
struct Plane {
  Vec3 normal{};  ///< of unit length
  double offset = 0;
};

/// A connected set of triangles of one reference between feature lines.
struct Patch {
  int ref = 0;
  bool required = false;
  std::variant<Frozen, Plane, Curved> shape{};

  [[nodiscard]] bool frozen() const { return std::holds_alternative<Frozen>(shape); }
  [[nodiscard]] const Curved* curved() const { return std::get_if<Curved>(&shape); }
};

struct Straight {
  Vec3 origin{}, direction{};
};

/// A smooth chain of feature edges between two corners, or a closed one.
struct Line {
  int ref = 0;
  bool frozen = false;
  bool sharp = false;  ///< written as a ridge
  bool required = false;
  bool implicit = false;  ///< separates required triangles from others: not written
  std::variant<Straight, Bent> shape{};
  std::vector<PatchId> patches;  ///< of the triangles at each of its edges: twice if a patch is on both sides
};

/// A vertex that is kept. Corners of only frozen patches share one entry without patches and lines.
struct Corner {
  std::vector<PatchId> patches;
  std::vector<LineId> lines;
  std::optional<Vec3> place{};  ///< of the corner of a given surface, where the vertex has to go
};

/// The tetrahedra of one reference. Those of a frozen region are kept, because the input requires them or an edge
/// inside the volume.
struct Region {
  int ref = 0;
  bool frozen = false;
  bool required = false;
};

/// An edge of the input inside the volume. The tetrahedra around it are kept as they are.
struct InnerEdge {
  std::array<std::uint32_t, 2> points;  ///< of the input
  int ref = 0;
  bool sharp = false, required = false;
};

inline constexpr CornerId shared_corner{0};

class Model {
public:
  std::vector<Patch> patches;
  std::vector<Line> lines;
  std::vector<Corner> corners{1};  ///< the first is the one shared
  std::vector<Region> regions;
  std::vector<InnerEdge> inner_edges;
  bool has_frozen_region = false;
  PlacedSurface surface;                                       ///< there is none unless a patch is curved
  double deviation = std::numeric_limits<double>::infinity();  ///< allowed between triangles and curved patches
  bool has_contacts = false;      ///< bodies may be driven against surfaces, which must not become flat there
  bool surface_is_given = false;  ///< made from another mesh: vertices may be off it at first

  /// A corner of those of its patches and lines that may change.
  CornerId add_corner(Corner corner);

  /// Whether a vertex with this tag lies on the patch or its border, and the patch may change.
  [[nodiscard]] bool on_patch(Tag tag, PatchId patch) const;
  /// Whether a vertex with this tag lies on the line or its ends, and the line may change.
  [[nodiscard]] bool on_line(Tag tag, LineId line) const;
  /// How many triangles of the patch meet at each edge of the line.
  [[nodiscard]] int sides_of(LineId line, PatchId patch) const;
  /// Calls visit(patch), more than once perhaps, for each patch that may change and on which or on whose border a
  /// vertex with this tag lies.
  template <class Visit>
  void for_each_patch_at(Tag tag, Visit visit) const {
    if (tag.is_on_patch() && !patches[tag.patch()].frozen()) visit(tag.patch());
    if (tag.is_on_line() || tag.is_at_corner())
      for (const PatchId p : tag.is_on_line() ? lines[tag.line()].patches : corners[tag.corner()].patches)
        if (!patches[p].frozen()) visit(p);
  }

  /// The point of the vertex's patch or line nearest to x, and the place of its corner if it has to go there; x itself
  /// in the volume, at any other corner and on what is frozen.
  [[nodiscard]] Vec3 project(Tag tag, const Vec3& x) const {
    SeatId seat = none;
    return project(tag, x, seat);
  }
  /// The same; a good `seat`, such as that of a place nearby, makes it faster. It becomes that of the place found.
  [[nodiscard]] Vec3 project(Tag tag, const Vec3& x, SeatId& seat) const;
  /// The unit normal of the vertex's patch at the point nearest to x, in the sense of its triangles. Zero where there
  /// is no one normal: in the volume, on lines, at corners, on what is frozen.
  [[nodiscard]] Vec3 normal(Tag tag, const Vec3& x) const;
};

}  // namespace taut
