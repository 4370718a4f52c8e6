// The cavity operator: removes a set of tetrahedra and connects the faces of its hull to one vertex, the apex
// (Dobrzynski and Frey 2008, section 3: T <- T - C(p) + B(p); Loseille and Loehner's cavity operator).
#pragma once

#include <array>
#include <span>

#include "cavity/face_batch.hpp"
#include "cavity/outcome.hpp"
#include "cavity/surface_cavity.hpp"
#include "cavity/tet_set.hpp"
#include "cavity/vertex_batch.hpp"
#include "partition/block.hpp"

namespace taut {

/// What becomes of vertices in the volume all of whose tetrahedra are in a cavity.
enum class Enclosed { stay, go };

/// A worker's scratch. Use: fill `tets`, then rejoin(); or propose() until the proposal is star-shaped, then
/// conclude().
class Cavity {
public:
  TetSet tets;      ///< collected
  FaceBatch batch;  ///< the hull's faces that get a new tetrahedron, evaluated from the apex

  /// The whole operation: proposes, judges, validates and commits. judge() looks at `batch` and lengths(), changes
  /// nothing and returns an Outcome. `gone` is the vertex that a collapse removes.
  template <class Judge>
  Outcome rejoin(TetMesh& mesh, const Model& model, Block& block, const Apex& apex, VertexId gone, Judge judge) {
    const Outcome outcome = propose(mesh, model, apex, gone);
    return outcome == Outcome::accepted ? conclude(mesh, block, judge) : outcome;
  }

  /// Finds the hull seen from the apex and evaluates its faces. Faces that contain the apex stay; triangles on a patch
  /// of the apex go. Refused for geometry, or for lack of room.
  [[nodiscard]] Outcome propose(const TetMesh& mesh, const Model& model, const Apex& apex, VertexId gone = none);

  /// All that follows a proposal. Vertices in the volume that the cavity encloses may go only if the caller says so.
  template <class Judge>
  Outcome conclude(TetMesh& mesh, Block& block, Judge judge, Enclosed enclosed = Enclosed::stay) {
    if (const Outcome outcome = judge(); outcome != Outcome::accepted) return outcome;
    const Permit permit = validate(mesh, block, enclosed);
    if (permit.outcome() == Outcome::accepted) commit(mesh, block, permit);
    return permit.outcome();
  }

  /// The tetrahedron that owns face i of the batch, as an index into `tets`.
  [[nodiscard]] int owner(int i) const { return faces_[i].owner; }
  /// Its number there.
  [[nodiscard]] int face(int i) const { return faces_[i].face; }

  /// Whether face i of the batch sees the apex: its new tetrahedron is exactly positive.
  [[nodiscard]] bool sees(int i) const;

  [[nodiscard]] double worst_old_quality(const TetMesh& mesh) const;

  /// Fast edge lengths from the apex to the hull's vertices; valid until the next call.
  [[nodiscard]] std::span<const double> lengths() { return vertices_.lengths(apex_.vertex); }

  /// The tetrahedra created by the last commit().
  [[nodiscard]] std::span<const TetId> made() const { return {made_.data(), static_cast<std::size_t>(batch.size())}; }

private:
  /// What validate() found. Only that makes one, and nothing is committed without.
  class Permit {
  public:
    [[nodiscard]] Outcome outcome() const { return outcome_; }

  private:
    friend class Cavity;
    explicit Permit(Outcome outcome) : outcome_(outcome) {}
    Outcome outcome_;
  };

  static constexpr int most_lost = 8;

  struct HullFace {
    std::array<VertexId, 3> v;
    std::array<std::uint8_t, 3> local;
    int owner;
    int face;  ///< of the owner
  };
  struct ApexFace {  ///< contains the apex: its link is connected to a new tetrahedron at edge bc
    VertexId b, c;
    std::uint8_t local_b, local_c;
    int owner, face;
  };

  /// All new tetrahedra are positive, their side faces match, no vertex is lost but those that may go, and the block
  /// has ids enough.
  [[nodiscard]] Permit validate(const TetMesh& mesh, const Block& block, Enclosed enclosed);
  /// Re-joins the hull to the apex, made if it does not exist yet.
  void commit(TetMesh& mesh, Block& block, const Permit& permit);

  Outcome add_face(const TetMesh& mesh, int owner, int face);
  Outcome add_triangle(const TetMesh& mesh, const Model& model, int owner, int face);
  [[nodiscard]] bool all_positive() const;
  [[nodiscard]] bool match(const TetMesh& mesh);
  bool enter_edges();
  [[nodiscard]] bool borders_are_on_hull() const;
  bool sides_agree(const TetMesh& mesh) const;
  [[nodiscard]] bool find_lost(const TetMesh& mesh, Enclosed enclosed);
  [[nodiscard]] bool is_owned(const TetMesh& mesh, const Block& block) const;
  void clear_matching();
  [[nodiscard]] bool has_ids(const Block& block) const;
  void take_ids(Block& block);
  void make_apex(TetMesh& mesh, Block& block) const;
  void make_triangles(TetMesh& mesh, Block& block);
  void make_tet(TetMesh& mesh, int i);
  void glue_side(TetMesh& mesh, int i, int k);
  void relink(TetMesh& mesh, FaceLink link, FaceLink old_face, FaceLink new_face) const;
  void release(TetMesh& mesh, Block& block);

  Apex apex_;
  VertexId gone_ = none;
  int apex_face_count_ = 0;
  VertexBatch vertices_;
  SurfaceCavity surface_;
  std::array<HullFace, FaceBatch::capacity> faces_{};
  std::array<ApexFace, FaceBatch::capacity> apex_faces_{};
  std::array<VertexId, most_lost> lost_{};  ///< vertices of the cavity that are not on its hull
  int lost_count_ = 0;

  // Maps a directed edge (a, b) of a hull face, in local numbers, to 1 + 3 face + edge, or to apex_base + apex face.
  static constexpr int apex_base = 1 + 3 * FaceBatch::capacity;
  std::array<std::array<std::uint16_t, VertexBatch::capacity>, VertexBatch::capacity> edge_{};

  // Filled while committing.
  std::array<TetId, FaceBatch::capacity> made_{};
  std::array<std::array<FaceLink, 4>, TetSet::capacity> old_links_{};
  std::array<RegionId, TetSet::capacity> old_regions_{};
};

}  // namespace taut
