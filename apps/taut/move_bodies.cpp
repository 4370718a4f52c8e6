#include "move_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <string_view>

#include "files.hpp"
#include "solution.hpp"

namespace taut::program {
namespace {

bool moves_by_displacements(const MovingBody& body) {
  return !body.displacements.empty();
}

bool has_reference(const MovingBody& body, int reference) {
  return std::ranges::find(body.references, reference) != body.references.end();
}

void require_displacements_everywhere(const std::string& file, const std::vector<MovingBody>& bodies) {
  const auto other = std::ranges::find_if_not(bodies, moves_by_displacements);
  if (other != bodies.end())
    throw InputError(
        fmt::format("{}: bodies[{}]: displacements expected, as another body has them", file, other - bodies.begin()));
}

// Displacements belong to the vertices of the input.
void require_kept_numbers(const std::string& file, const MotionOptions& options) {
  const auto refuse = [&](std::string_view found, std::string_view expected) {
    throw InputError(fmt::format("{}: displacements found, for which {}, expected {}", file, found, expected));
  };
  if (options.changes == MeshChanges::all) refuse("--mode all would change the vertices", "--mode move or flips");
  if (options.following == Following::share) refuse("--follow share has no meaning", "--follow elastic");
  if (options.metric_follows) refuse("--metric-follows has no meaning", "a metric that stays");
}

/// Throws InputError for a reference of the list that no triangle has.
void require_found(const std::vector<int>& list, const std::set<int>& found, const std::string& place,
                   const std::string& mesh_file) {
  for (std::size_t i = 0; i < list.size(); ++i)
    if (!found.contains(list[i]))
      throw InputError(
          fmt::format("{}[{}]: reference {} found, but no triangle of {} has it", place, i, list[i], mesh_file));
}

Field read_displacements(const std::string& file, std::size_t points) {
  std::vector<Field> fields = read_fields({&file, 1}, points);
  if (fields.size() != 1 || fields[0].kind != Field::Kind::vector)
    throw InputError(fmt::format("{}: expected one vector per vertex", file));
  return std::move(fields[0]);
}

/// The vertices of the body's triangles that no earlier body has taken.
std::vector<Index> take_points(const Mesh& mesh, const MovingBody& body, std::vector<std::uint8_t>& is_taken) {
  std::vector<Index> points;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!has_reference(body, mesh.triangle_refs[t])) continue;
    for (const Index v : mesh.triangles[t]) {
      if (is_taken[v] == 0) points.push_back(v);
      is_taken[v] = 1;
    }
  }
  return points;
}

}  // namespace

MovingBodies::MovingBodies(const std::string& file, const MotionOptions& options)
    : file_(file), motion_(read_motion(file)) {
  if (std::ranges::any_of(motion_.bodies, moves_by_displacements)) {
    require_displacements_everywhere(file_, motion_.bodies);
    require_kept_numbers(file_, options);
  }
  if (!options.metric_follows) return;
  const int reference = *options.metric_follows;
  if (std::ranges::none_of(motion_.bodies, [&](const MovingBody& body) { return has_reference(body, reference); }))
    throw InputError(
        fmt::format("--metric-follows: reference {} found, expected one of a body in {}", reference, file_));
}

std::vector<std::string> MovingBodies::files() const {
  std::vector<std::string> files;
  for (const MovingBody& body : motion_.bodies)
    if (moves_by_displacements(body)) files.push_back(body.displacements.string());
  return files;
}

void MovingBodies::fit(const Mesh& mesh, const std::string& mesh_file) {
  const std::set<int> found(mesh.triangle_refs.begin(), mesh.triangle_refs.end());
  for (std::size_t i = 0; i < motion_.bodies.size(); ++i)
    require_found(motion_.bodies[i].references, found, fmt::format("{}: bodies[{}].references", file_, i), mesh_file);
  require_found(motion_.fixed, found, file_ + ": fixed", mesh_file);
  require_found(motion_.sliding, found, file_ + ": sliding", mesh_file);

  std::vector<std::uint8_t> is_taken(mesh.points.size(), 0);
  for (const MovingBody& body : motion_.bodies) {
    if (!moves_by_displacements(body)) continue;
    const Field by = read_displacements(body.displacements.string(), mesh.points.size());
    for (const Index v : take_points(mesh, body, is_taken))
      points_.push_back({v, {by.values[3 * v], by.values[3 * v + 1], by.values[3 * v + 2]}});
  }
}

Advance MovingBodies::advance(MovingMesh& mesh, std::size_t step) const {
  return with_files(file_, {{"motion: ", file_}},
                    [&] { return points_.empty() ? mesh.advance(motions_in(step)) : mesh.advance(points_); });
}

// From where a body was before the step. The places are computed from the beginning, so that errors do not add up.
std::vector<BodyMotion> MovingBodies::motions_in(std::size_t step) const {
  const auto n = static_cast<double>(step);
  std::vector<BodyMotion> motions;
  for (const MovingBody& body : motion_.bodies) {
    const RigidMotion motion = body.place_after(n) * body.place_after(n - 1).inverse();
    for (const int reference : body.references) motions.push_back({reference, motion});
  }
  return motions;
}

}  // namespace taut::program
