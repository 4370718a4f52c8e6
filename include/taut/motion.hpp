// Moving domains: bodies that travel and turn through a mesh (Dobrzynski and Frey 2008, 4.3).
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "taut/adapt.hpp"
#include "taut/export.hpp"
#include "taut/field.hpp"
#include "taut/rigid_motion.hpp"
#include "taut/transfer.hpp"

namespace taut {

/// What may change besides the places of the vertices.
enum class MeshChanges {
  nothing,  ///< vertices move, and the mesh ends where one would turn over
  flips,    ///< edges and faces are swapped and vertices relocated: all vertices stay, with their numbers
  all,      ///< vertices come and go too
};

/// How the inside of the mesh follows its boundary.
enum class Following {
  elastic,  ///< as an elastic body
  /// Each vertex takes part in a share of the rigid motion, which is harmonic. Keeps the angles around bodies that
  /// turn, and costs a third; for rigid motions only.
  share,
};

/// How a mesh follows moving bodies. The defaults suit most.
struct MotionOptions {
  MeshChanges changes = MeshChanges::all;    ///< see there
  Following following = Following::elastic;  ///< see there
  /// Surface, limits, ridge angle, threads and size of blocks. Curved surfaces are adapted as they move: that of a body
  /// goes along with it if all its vertices move by one rigid motion, and stays as it is from then on if they do not.
  /// Surface::planar keeps the triangles of all curved surfaces. A geometry is where
  /// the boundary is at the beginning, and is carried along in the same way. `max_rounds` is for the beginning: the
  /// mesh is taken as it is if 0, and vertices are moved onto a geometry after the first step.
  AdaptOptions adaptation{.max_rounds = 0};
  int rounds = 3;              ///< of optimisation after each step, or part of a step, 0 or more
  double stiffening = 1.5;     ///< stiffness of a tetrahedron is 1 / volume to this power, 0 or more
  double poisson_ratio = 0.3;  ///< of the elastic body, above -1 and below 1/2
  int shell = 2;               ///< layers of vertices around a body that move as it does, 0 or more
  double tolerance = 1e-3;     ///< of the linear solver, relative, above 0
  /// What is tried before bodies count as stopped, in (0, 1]: this share of a step, and smaller ones down to a
  /// millionth as long as edges in the way change by more than this share of an edge of the metric.
  double smallest_share = 1.0 / 64;
  std::vector<int> sliding{};  ///< references of triangles of planar walls on which vertices may slide
  /// The metric is that of a place in space. Or it follows the body with this reference.
  std::optional<int> metric_follows{};
  Transfer transfer = Transfer::conservative;  ///< of registered fields, where the mesh has changed
};

/// What the triangles with one reference do in a step. All others stay where they are, or slide. A vertex where bodies
/// meet moves with that which comes first among them.
struct BodyMotion {
  int reference = 0;     ///< of its triangles
  RigidMotion motion{};  ///< in this step
};

/// Where a point of the boundary goes in a step.
struct PointMotion {
  Index point = 0;  ///< on the boundary
  Point by{};       ///< its displacement in this step
};

/// Why bodies cannot pass, and where.
struct Obstacle {
  /// What kind of obstacle it is.
  enum class Reason {
    contact,  ///< two surfaces are nearer to each other than an edge of the metric
    tangle,   ///< there is room between the surfaces, but the tetrahedra there do not follow
  };
  Reason reason = Reason::contact;  ///< see there
  Point place{};    ///< the middle of the gap; of the tetrahedron that would turn over, if it is a tangle
  int body = 0;     ///< reference of the nearest triangles that move in the step
  int other = 0;    ///< reference of the nearest triangles that move differently or stay; that of the body if none do
  double gap = 0;   ///< the least distance between the two near the place; 0 if none move differently
  double size = 0;  ///< of an edge of the metric across the gap
};

/// In one line, with everything that the obstacle holds.
[[nodiscard]] TAUT_EXPORT std::string description(const Obstacle& obstacle);

/// What a step did.
struct Advance {
  double share = 0;                  ///< of the step that was done: 1 unless bodies cannot pass
  std::optional<Obstacle> obstacle;  ///< if they cannot
  int parts = 0;                     ///< in which the step was done
  int iterations = 0;                ///< of the linear solver, in all parts
  bool is_changed = false;           ///< whether anything but places of vertices has changed: tetrahedra, numbers
  std::size_t off_surface = 0;       ///< vertices that are not on the geometry that was given, as Report::off_surface
  std::vector<Index> new_of_old;     ///< for each point before, its index now, or AdaptResult::gone
  std::vector<PassReport> passes;    ///< of optimisation, in all parts
  std::vector<std::pair<std::string, double>> seconds;  ///< by phase: "solve", "move", "optimise", "transfer", "result"
};

class MovingState;

/// A mesh that lives through the steps of a simulation. Between two steps it is valid, and near to the metric.
class TAUT_EXPORT MovingMesh {
public:
  /// Throws InputError if the mesh, the metric or an option cannot be used.
  MovingMesh(const Mesh& mesh, const Metric& metric, const MotionOptions& options = {});
  MovingMesh(MovingMesh&&) noexcept;  ///< leaves nothing behind that can be used
  /// Leaves nothing behind that can be used.
  MovingMesh& operator=(MovingMesh&&) noexcept;
  ~MovingMesh();

  /// Moves bodies. If they cannot pass, Advance::obstacle says why, Advance::share is below 1, and the mesh is the last
  /// valid one: bodies are where that share has taken them. Throws InputError
  /// for a reference that no triangle has, or that comes twice, and for a motion with a number that is not finite or
  /// above 1e100; nothing has changed then. Throws Failure if the solver does not converge: the mesh is then that after
  /// the last part of the step.
  Advance advance(std::span<const BodyMotion> bodies);

  /// Moves points of the boundary; the others stay where they are, or slide. Likewise. Throws InputError for a point
  /// that is not on the boundary, that comes twice, or whose displacement has such a number.
  Advance advance(std::span<const PointMotion> points);

  /// The mesh as it is now. Points keep their numbers unless MotionOptions::changes is `all`.
  [[nodiscard]] const Mesh& mesh() const;
  /// Of the mesh as it is now.
  [[nodiscard]] const std::vector<Point>& points() const { return mesh().points; }
  /// At the points of the mesh: of the place where each is now.
  [[nodiscard]] const Tensors& metric() const;

  /// The velocity of the mesh in the last step, which took `duration`, at the points as they are now: what an ALE
  /// solver subtracts from that of the fluid. The motion of the points by optimisation is not part of it, because
  /// fields are transferred there.
  [[nodiscard]] std::vector<Point> velocities(double duration) const;

  /// A new metric in space, at the points as they are now or as a function. Throws InputError if it cannot be used.
  void set_metric(const Metric& metric);

  /// Registers fields at the points: they are carried along with moving vertices, and transferred where the mesh
  /// changes. They replace those registered before. Throws InputError if one does not fit.
  void set_fields(std::vector<Field> fields);
  /// The registered fields, at the points as they are now.
  [[nodiscard]] const std::vector<Field>& fields() const;

private:
  std::unique_ptr<MovingState> state_;
};

}  // namespace taut
