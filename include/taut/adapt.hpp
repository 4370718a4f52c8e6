// The door: a mesh and a metric in, a mesh that is unit in the metric out.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "taut/error.hpp"
#include "taut/mesh.hpp"
#include "taut/metric.hpp"
#include "taut/quality.hpp"
#include "taut/surface.hpp"

namespace taut {

/// One round of the adaptation, as reported to the progress callback after each pass.
struct Progress {
  int round = 0;
  const char* pass = "";  ///< "insert", "collapse", "swap", "repair", "relocate"
  std::size_t vertices = 0, tetrahedra = 0;
  std::size_t accepted = 0;  ///< operations done by this pass
};

/// Called after each pass; returning false ends the adaptation with the mesh as it is then, which is valid.
using ProgressCallback = std::function<bool(const Progress&)>;

struct AdaptOptions {
  Surface surface = Surface::adapt;
  double hmin = 0;                                        ///< no wanted size below it
  double hmax = std::numeric_limits<double>::infinity();  ///< no wanted size above it
  std::optional<double> gradation{};  ///< sizes grow by at most this factor (> 1) per unit length; none: as given
  double ridge_angle = 45;            ///< degrees between the normals of two triangles from which their edge is a ridge
  int max_rounds = 40;  ///< fewer are done if two in a row gain less than they cost
  ProgressCallback progress{};
  /// At most; 0: those of the caller's oneTBB task arena, by default one a core. The result is the same.
  int threads = 0;
  /// Vertices of a block, the share of the mesh that one thread works on at a time; 0: the whole mesh. Unlike the
  /// number of threads it changes the result, though hardly its quality.
  std::size_t block_size = 8192;
};

/// Operations of one kind over the whole run: how many were looked at, and what became of them.
struct PassReport {
  std::string name;
  std::size_t scanned = 0;                                   ///< tetrahedra of blocks, or vertices, looked at
  std::size_t tried = 0;                                     ///< operations proposed and judged
  std::size_t accepted = 0;                                  ///< operations done
  std::vector<std::pair<std::string, std::size_t>> refused;  ///< count by reason
  std::size_t put_off = 0;  ///< not tried in this round: what reaches beyond one block, or found no id left
  double seconds = 0;       ///< from the pass's beginnings to its ends
  double busy_seconds = 0;  ///< of all threads together: `threads` times `seconds` if none ever waits for another
};

struct Report {
  std::size_t rounds = 0;
  int threads = 1;         ///< that could be had
  std::size_t blocks = 0;  ///< in the last round
  bool cancelled = false;
  std::vector<PassReport> passes;
  std::vector<std::pair<std::string, double>> seconds;  ///< phases outside the passes: setup, gradation, order, ...
  std::size_t reoriented = 0;                           ///< inverted tetrahedra of the input that were turned round
  std::size_t triangles_built = 0;                      ///< boundary and interface triangles missing from the input
  std::size_t triangles_frozen = 0;                     ///< triangles on patches that are not planar, kept as they are
  std::uint64_t hash = 0;                               ///< of the final mesh: equal hashes, equal bits
  Quality quality;                                      ///< of the result in the metric it was adapted to
};

/// Where a point of the result lies in the input.
struct Host {
  Index tetrahedron = 0;            ///< of the input
  std::array<double, 4> weights{};  ///< of its four points in their order: none negative, of sum 1
};

struct AdaptResult {
  static constexpr Index gone = std::numeric_limits<Index>::max();
  Mesh mesh;
  Tensors metric;                 ///< at the points of `mesh`
  std::vector<Host> hosts;        ///< of the points of `mesh`: what interpolates any field on the input
  std::vector<Index> new_of_old;  ///< for each point of the input its index in `mesh`, or `gone`
  Report report;
};

/// Adapts `mesh` to `metric` (Dobrzynski and Frey 2008, sections 3 and 4; the metric is interpolated on the input mesh,
/// log-Euclidean, or called). Throws InputError if the mesh, the metric or the options cannot be used.
[[nodiscard]] AdaptResult adapt(const Mesh& mesh, const Metric& metric, const AdaptOptions& options = {});

}  // namespace taut
