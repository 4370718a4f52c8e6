#include "geometry/refit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "geometry/patches.hpp"

namespace taut {
namespace {

using Marks = std::vector<std::uint8_t>;

// Whether a vertex of each patch, or of each line, has moved; but for those that were carried along.
struct Touched {
  Marks patch, line;
};

// Visits the two vertices of each edge of a triangle that lies on a line.
template <class Visit>
void for_each_line_edge(const TetMesh& mesh, Visit visit) {
  for (const Triangle& t : mesh.triangles)
    for (int k = 0; k < 3; ++k)
      if (t.line[k] != none) visit(t.line[k], std::array{t.v[(k + 1) % 3], t.v[(k + 2) % 3]});
}

Touched touched_otherwise(const Model& model, const TetMesh& mesh, const Marks& has_moved, const Carried& carried) {
  Touched touched{Marks(model.patches.size(), 0), Marks(model.lines.size(), 0)};
  for (const Triangle& t : mesh.triangles)
    for (VertexId v : t.v) touched.patch[t.patch] |= has_moved[v];
  for_each_line_edge(mesh, [&](LineId line, const std::array<VertexId, 2>& edge) {
    for (VertexId v : edge) touched.line[line] |= has_moved[v];
  });
  for (std::size_t p = 0; p < touched.patch.size(); ++p)
    if (carried.patch[p] != 0) touched.patch[p] = 0;
  for (std::size_t l = 0; l < touched.line.size(); ++l)
    if (carried.line[l] != 0) touched.line[l] = 0;
  return touched;
}

// Lines through their two vertices that are farthest apart: first the one farthest from any, then from that.
std::vector<Line> fitted_lines(const TetMesh& mesh, std::vector<Line> lines, const Marks& touched) {
  const auto farthest_from = [&](const std::vector<Vec3>& from) {
    std::vector<Vec3> found = from;
    for_each_line_edge(mesh, [&](LineId line, const std::array<VertexId, 2>& edge) {
      for (VertexId v : edge)
        if (norm(mesh.x(v) - from[line]) > norm(found[line] - from[line])) found[line] = mesh.x(v);
    });
    return found;
  };
  std::vector<Vec3> any(lines.size());
  for_each_line_edge(mesh, [&](LineId line, const std::array<VertexId, 2>& edge) { any[line] = mesh.x(edge[0]); });
  const auto begin = farthest_from(any), end = farthest_from(begin);
  for (std::size_t l = 0; l < lines.size(); ++l) {
    if (touched[l] == 0 || !std::holds_alternative<Straight>(lines[l].shape)) continue;
    const Vec3 along = end[l] - begin[l];
    lines[l].shape = Straight{begin[l], (1 / norm(along)) * along};
  }
  return lines;
}

// The place of a given surface's corner goes along with its vertex. If that has moved otherwise, it has none any more.
void carry_corners(Model& model, const TetMesh& mesh, const Marks& has_moved, const RigidMoves& rigid) {
  for (const VertexId v : mesh.vertex_ids()) {
    if (!mesh.is_vertex_alive(v) || !mesh.tag_of_vertex[v].is_at_corner()) continue;
    std::optional<Vec3>& place = model.corners[mesh.tag_of_vertex[v].corner()].place;
    if (!place) continue;
    const std::uint32_t motion = rigid.motions.empty() ? std::uint32_t{none} : rigid.of_vertex[v];
    if (motion != none)
      place = rigid.motions[motion](*place);
    else if (has_moved[v] != 0)
      place.reset();
  }
}

// Whether one is found that is not straight any more, or that has left its curve.
bool freeze_lines(Model& model, const TetMesh& mesh, const Marks& touched, double tolerance) {
  bool froze = false;
  for_each_line_edge(mesh, [&](LineId id, const std::array<VertexId, 2>& edge) {
    Line& line = model.lines[id];
    const auto* straight = std::get_if<Straight>(&line.shape);
    if (touched[id] == 0 || line.frozen) return;
    line.frozen = straight == nullptr || std::ranges::any_of(edge, [&](VertexId v) {
                    return norm(cross(mesh.x(v) - straight->origin, straight->direction)) > tolerance;
                  });
    froze |= line.frozen;
  });
  return froze;
}

// Whether one is found that is not planar.
bool refit_patches(Model& model, const TetMesh& mesh, const Marks& touched, double tolerance) {
  std::vector<Patch> found = model.patches;
  find_shapes(mesh, found, tolerance);
  bool froze = false;
  for (std::size_t p = 0; p < found.size(); ++p) {
    if (touched[p] == 0 || model.patches[p].frozen()) continue;
    model.patches[p].shape = found[p].shape;
    froze |= found[p].frozen();
  }
  return froze;
}

// What vertices become that stay from now on: corners of what they lay on. One for each patch or line.
class Fixing {
public:
  explicit Fixing(Model& model) : model_(model) {}

  [[nodiscard]] Tag operator()(Tag tag) {
    if (tag.is_on_patch()) return at(tag, {{tag.patch()}, {}});
    if (tag.is_on_line()) return at(tag, {model_.lines[tag.line()].patches, {tag.line()}});
    return tag;
  }

private:
  Tag at(Tag tag, Corner corner) {
    const auto key = std::pair{tag.is_on_patch(), tag.is_on_patch() ? std::uint32_t{tag.patch()} : tag.line()};
    const auto known = corners_.find(key);
    if (known != corners_.end()) return Tag::at_corner(known->second);
    return Tag::at_corner(corners_[key] = model_.add_corner(std::move(corner)));
  }

  Model& model_;
  std::map<std::pair<bool, std::uint32_t>, CornerId> corners_;
};

// No vertex of what is frozen moves any more.
void fix_vertices(Model& model, TetMesh& mesh) {
  Fixing fixed(model);
  for (const Triangle& t : mesh.triangles) {
    const bool all = model.patches[t.patch].frozen();
    for (VertexId v : t.v) {
      Tag& tag = mesh.tag_of_vertex[v];
      if (all || (tag.is_on_line() && model.lines[tag.line()].frozen)) tag = fixed(tag);
    }
  }
}

}  // namespace

void refit(Model& model, TetMesh& mesh, const Marks& has_moved, const RigidMoves& rigid) {
  const Touched touched = touched_otherwise(model, mesh, has_moved, carry(model, mesh, rigid));
  carry_corners(model, mesh, has_moved, rigid);
  const double tolerance = flatness_tolerance(mesh);
  bool froze = refit_patches(model, mesh, touched.patch, tolerance);
  model.lines = fitted_lines(mesh, std::move(model.lines), touched.line);
  froze |= freeze_lines(model, mesh, touched.line, tolerance);
  if (froze) fix_vertices(model, mesh);
}

}  // namespace taut
