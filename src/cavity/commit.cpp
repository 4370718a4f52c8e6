// The part of the cavity operator that writes to the mesh.
#include <algorithm>
#include <cassert>

#include "cavity/cavity.hpp"
#include "mesh/invariants.hpp"

namespace taut {
namespace {

// The face of a new tetrahedron (apex, a, b, c) that contains edge k of its base abc.
constexpr std::array<int, 3> side_at_edge = {3, 1, 2};

}  // namespace

void Cavity::commit(TetMesh& mesh, Block& block, [[maybe_unused]] const Permit& permit) {
  assert(permit.outcome() == Outcome::accepted && is_owned(mesh, block));
  for (int i = 0; i < tets.size(); ++i) {
    old_links_[i] = mesh.tets[tets[i]].n;
    old_regions_[i] = mesh.region_of_tet[tets[i]];
  }
  make_apex(mesh, block);
  take_ids(block);
  if (!surface_.empty()) make_triangles(mesh, block);
  for (int i = 0; i < batch.size(); ++i) make_tet(mesh, i);
  for (int i = 0; i < batch.size(); ++i)
    for (int k = 0; k < 3; ++k) glue_side(mesh, i, k);
  clear_matching();
  release(mesh, block);
  assert(first_broken_invariant(mesh, made()).empty());
}

// Nobody else may touch what the operation changes.
bool Cavity::is_owned(const TetMesh& mesh, const Block& block) const {
  const auto owned = [&](VertexId v) { return block.owns(v); };
  return owned(apex_.id) &&
         std::ranges::all_of(tets.span(), [&](TetId t) { return std::ranges::all_of(mesh.tets[t].v, owned); });
}

void Cavity::make_apex(TetMesh& mesh, Block& block) const {
  if (!mesh.is_vertex_alive(apex_.id)) block.add_vertex(mesh, apex_.vertex, apex_.tag, apex_.host, apex_.seat);
}

// New tetrahedra first take the ids of the removed ones, so that neighbours in space stay neighbours in memory.
void Cavity::take_ids(Block& block) {
  for (int i = 0; i < batch.size(); ++i) made_[i] = i < tets.size() ? tets[i] : block.tets.take();
}

void Cavity::make_triangles(TetMesh& mesh, Block& block) {
  const auto removed = surface_.removed();
  for (int i = 0; i < surface_.border_size(); ++i) {
    auto& border = surface_.border(i);
    border.made = i < static_cast<int>(removed.size()) ? removed[i] : block.triangles.take();
  }
  for (int i = surface_.border_size(); i < static_cast<int>(removed.size()); ++i)
    block.remove_triangle(mesh, removed[i]);
  for (int i = 0; i < surface_.border_size(); ++i) {
    const auto& border = surface_.border(i);
    mesh.triangles[border.made] = {{apex_.id, border.a, border.b},
                                   border.patch,
                                   {outside, outside},
                                   {border.line_ab, border.line_bp, border.line_pa}};
  }
}

void Cavity::make_tet(TetMesh& mesh, int i) {
  const HullFace& face = faces_[i];
  const TetId t = made_[i];
  Tet& tet = mesh.tets[t];
  tet.v = {apex_.id, face.v[0], face.v[1], face.v[2]};
  tet.state = {.quality = static_cast<float>(batch.quality[i]), .tried = {}};
  mesh.region_of_tet[t] = old_regions_[face.owner];
  tet.n[0] = old_links_[face.owner][face.face];
  relink(mesh, tet.n[0], FaceLink::to_face(tets[face.owner], face.face), FaceLink::to_face(t, 0));
  for (VertexId v : tet.v) {
    mesh.tet_of_vertex[v] = t;
    mesh.state_of_vertex[v].restless = true;
  }
}

// Links what was behind `old_face` of a removed tetrahedron to `new_face`.
void Cavity::relink(TetMesh& mesh, FaceLink link, FaceLink old_face, FaceLink new_face) const {
  if (!link.is_triangle()) {
    mesh.tets[link.tet()].n[link.face()] = new_face;
    return;
  }
  auto& side = mesh.triangles[link.triangle()].side;
  side[side[0] == old_face ? 0 : 1] = new_face;
}

void Cavity::glue_side(TetMesh& mesh, int i, int k) {
  const HullFace& face = faces_[i];
  const FaceLink here = FaceLink::to_face(made_[i], side_at_edge[k]);
  FaceLink& link = mesh.tets[made_[i]].n[side_at_edge[k]];
  const int k_next = (k + 1) % 3;
  if (!surface_.empty()) {
    const int found = surface_.find_border(face.v[k], face.v[k_next]);
    if (found >= 0) {  // seen from side 0, where the face's edge runs from b to a, the triangle points outward
      const auto& border = surface_.border(found);
      link = FaceLink::to_triangle(border.made);
      mesh.triangles[border.made].side[face.v[k] == border.b ? 0 : 1] = here;
      return;
    }
  }
  const int partner = edge_[face.local[k_next]][face.local[k]];
  if (partner >= apex_base) {
    const ApexFace& apex_face = apex_faces_[partner - apex_base];
    link = old_links_[apex_face.owner][apex_face.face];
    relink(mesh, link, FaceLink::to_face(tets[apex_face.owner], apex_face.face), here);
  } else {
    link = FaceLink::to_face(made_[(partner - 1) / 3], side_at_edge[(partner - 1) % 3]);
  }
}

void Cavity::release(TetMesh& mesh, Block& block) {
  for (int i = batch.size(); i < tets.size(); ++i) block.remove_tet(mesh, tets[i]);
  for (int i = 0; i < lost_count_; ++i) block.remove_vertex(mesh, lost_[i]);
}

}  // namespace taut
