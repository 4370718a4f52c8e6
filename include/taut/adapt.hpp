// The adaptation: takes a mesh and a metric, returns a mesh whose edges have about unit length in the metric.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "taut/error.hpp"
#include "taut/export.hpp"
#include "taut/geometry.hpp"
#include "taut/host.hpp"
#include "taut/limits.hpp"
#include "taut/mesh.hpp"
#include "taut/metric.hpp"
#include "taut/quality.hpp"
#include "taut/surface.hpp"

namespace taut {

/// What one pass did. A pass applies one kind of operation to the whole mesh; a round is a sequence of passes.
struct Progress {
  int round = 0;               ///< counted from 0
  const char* pass = "";       ///< "insert", "collapse", "swap" (edges and faces), "repair", "relocate"
  std::size_t vertices = 0;    ///< of the mesh after the pass
  std::size_t tetrahedra = 0;  ///< of the mesh after the pass
  std::size_t accepted = 0;    ///< operations that the pass did
};

/// Called after each pass. If it returns false, the adaptation ends and returns the mesh as it is then, which is valid.
using ProgressCallback = std::function<bool(const Progress&)>;

/// How a mesh is adapted. The defaults suit most meshes.
struct AdaptOptions {
  Surface surface = Surface::adapt;  ///< what may change on the boundary and between regions
  /// Applied to the metric before the work starts. Gradation samples a metric function at the input's vertices only:
  /// the target is then the field on the input mesh, no longer the function.
  Limits limits{};
  /// Degrees; an edge is a ridge if the normals of its two triangles differ by this or more. Without it the shape of
  /// the surface decides (Geometry); between planar patches 45 degrees do.
  std::optional<double> ridge_angle{};
  /// Allowed distance between the triangles and the curved surface, in the unit of the mesh; 0: whatever the metric
  /// asks for. Above 0, with Surface::adapt only, the metric is intersected with that of curvature_metric() for half of
  /// it, with the curvatures of the surface that the vertices have to lie on, which like gradation makes a field of a
  /// metric function. Operations that would exceed it are refused.
  double deviation = 0;
  /// Where the vertices of the boundary and of interfaces have to lie, instead of on a surface made from this mesh:
  /// made once, it keeps them on one surface through any number of adaptations. It may come from a finer or coarser
  /// mesh. Each triangle belongs to the patch of its reference that is closest to it, or of any where references are 0.
  /// Vertices off the surface are moved onto it as far as the tetrahedra allow. Planes of the mesh that it does not
  /// hold stay planes. It has its own ridge angle. Needs Surface::adapt.
  std::optional<Geometry> geometry{};
  int max_rounds = 40;          ///< the adaptation ends earlier once a round gains less than it costs
  ProgressCallback progress{};  ///< may end the adaptation after each pass
  /// Called once before the first round, with about how many tetrahedra the result will have: more if a metric function
  /// is finer between the points of the input. If it returns false, the mesh is returned as it is.
  std::function<bool(double tetrahedra)> expecting{};
  /// Largest number of threads; 0: as many as the caller's oneTBB task arena has, by default one per core. The result
  /// does not depend on it.
  int threads = 0;
  /// Vertices per block, the part of the mesh that one thread works on at a time; 0: the whole mesh is one block. The
  /// result depends on it, but its quality hardly does.
  std::size_t block_size = 8192;
};

/// All passes of one kind: how many operations were tried, and what became of them.
struct PassReport {
  std::string name;                                          ///< as in Progress::pass
  std::size_t scanned = 0;                                   ///< vertices (relocate) or tetrahedra examined
  std::size_t tried = 0;                                     ///< operations proposed: accepted or refused
  std::size_t accepted = 0;                                  ///< operations done
  std::vector<std::pair<std::string, std::size_t>> refused;  ///< number of operations by reason of refusal
  std::size_t put_off = 0;  ///< left to a later round, because they reach beyond a block or its ids ran out
  double seconds = 0;       ///< elapsed time
  double busy_seconds = 0;  ///< working time summed over the threads: `threads` times `seconds` if none ever waits
};

/// What an adaptation did, and how good the result is.
struct Report {
  std::size_t rounds = 0;          ///< number of rounds done
  int threads = 1;                 ///< number of threads that the run could use
  std::size_t blocks = 0;          ///< number of blocks in the last round
  bool cancelled = false;          ///< a callback returned false
  std::vector<PassReport> passes;  ///< one entry per kind of pass
  /// Elapsed time by phase, in this order, outside the passes: "build" (checks, adjacency, first ordering), "geometry"
  /// (patches, ridges, corners), "metric" (evaluation, hmin and hmax, gradation), "cut" (into blocks, in all rounds),
  /// "order" (renumbering between rounds and at the end), "result" (arrays, hash and quality).
  std::vector<std::pair<std::string, double>> seconds;
  double expected_tetrahedra = 0;    ///< about how many the metric at the points of the input asks for
  std::size_t reoriented = 0;        ///< inverted tetrahedra of the input that were reoriented
  std::size_t triangles_built = 0;   ///< boundary and interface triangles that were missing from the input
  std::size_t edges_dropped = 0;     ///< edges of the input with a vertex that belongs to no tetrahedron
  std::size_t triangles_frozen = 0;  ///< triangles kept as they are: not planar, required, or all if Surface::fixed
  /// Vertices that are not on AdaptOptions::geometry at the end: they are required or corners of the input, or
  /// tetrahedra would turn over. 0 without one.
  std::size_t off_surface = 0;
  std::uint64_t hash = 0;  ///< of all arrays of the mesh and of its metric; equal hashes, equal bits
  Quality quality;         ///< of the result in `AdaptResult::metric`
};

/// The adapted mesh, and how it relates to the input.
struct AdaptResult {
  static constexpr Index gone = std::numeric_limits<Index>::max();  ///< the index of a point that was removed
  Mesh mesh;                                                        ///< the adapted mesh
  Tensors metric;                                                   ///< at the points of `mesh`
  std::vector<Host> hosts;        ///< of the points of `mesh` in the input: what interpolates any field on it
  std::vector<Index> new_of_old;  ///< for each point of the input its index in `mesh`, or `gone`
  Report report;                  ///< what the adaptation did
};

/// Adapts `mesh` to `metric` (Dobrzynski and Frey 2008, sections 3 and 4). Sizes and tensors are interpolated on the
/// input mesh, log-Euclidean; a function is called at each new place of a vertex, unless gradation is asked for. Throws
/// InputError if the mesh, the metric or the options cannot be used, one that begins with "geometry: " and names the
/// place where the mesh does not match the geometry: a reference without a patch, a corner without a vertex, a vertex
/// or triangle more than half an edge away. Throws Failure if the result needs more than 32-bit ids.
/// An exception thrown by the function or the callback reaches the caller.
[[nodiscard]] TAUT_EXPORT AdaptResult adapt(const Mesh& mesh, const Metric& metric, const AdaptOptions& options = {});

}  // namespace taut
