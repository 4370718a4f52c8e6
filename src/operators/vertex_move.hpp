// A vertex that changes its place and nothing else: its ball gathered once, and evaluated with the vertex elsewhere.
#pragma once

#include <span>
#include <vector>

#include "operators/kernel.hpp"

namespace taut {

struct MoveRules {
  double still = 0.03;  ///< a move shorter than this, in the metric, does not affect the neighbours
  double drift = 0.1;   ///< moves that add up to more than this make it worthwhile to retry the swaps around
};

/// Use: gather(); then propose() places until one pleases; commit() it.
class VertexMove {
public:
  VertexMove(Kernel& kernel, VertexId v);

  /// Collects the ball and measures its edges. Refused if it has no room or is frozen.
  [[nodiscard]] Outcome gather();

  [[nodiscard]] const Vertex& old() const { return old_; }
  [[nodiscard]] Tag tag() const { return tag_; }
  [[nodiscard]] double old_quality() const { return old_quality_; }               ///< the worst 1/Q of the ball
  [[nodiscard]] std::span<const double> old_lengths() const { return lengths_; }  ///< valid until the first propose()

  /// The place nearest to old + step on the vertex's patch or line. Refused if it turns a tetrahedron of the ball over;
  /// otherwise the kernel's batch holds the ball's qualities there afterwards.
  [[nodiscard]] Outcome propose(const Vec3& step);

  /// The same at any place, which may be off the patch or line, however well the triangles fit there.
  [[nodiscard]] Outcome propose_at(const Vec3& place);

  /// The lengths of the edges from the place proposed; valid until the next propose().
  [[nodiscard]] std::span<const double> new_lengths();

  /// Moves the vertex to the place last proposed, unless a tetrahedron of the ball would not be positive there.
  [[nodiscard]] Outcome commit(const MoveRules& rules);

private:
  /// A triangle of the ball on a curved patch: the two vertices that follow v.
  struct Facet {
    PatchId patch;
    VertexId b, c;
  };
  void gather_facets();
  [[nodiscard]] double worst_misfit(const Vec3& x, SeatId near) const;
  [[nodiscard]] bool facets_fit();
  void evaluate();
  [[nodiscard]] bool all_positive() const;
  void write(const MoveRules& rules);
  void note_lengths();

  Kernel& k_;
  TetMesh& mesh_;
  const VertexId v_;
  const Vertex old_;
  const Tag tag_;
  Vertex moved_{};
  CellId host_ = none;
  SeatId seat_;
  std::span<const double> lengths_;  // at the old place, or at the new one if that is measured
  bool measured_ = false;            // whether it is
  double old_quality_ = 1, old_phi_ = 0;
  bool not_unit_ = false;
  std::vector<Facet> facets_;  // empty unless v is on a curved patch
  double old_misfit_ = -1;     // negative if it is not known
};

}  // namespace taut
