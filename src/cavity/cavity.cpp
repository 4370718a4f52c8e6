#include "cavity/cavity.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/orientation.hpp"

namespace taut {

Outcome Cavity::add_face(const TetMesh& mesh, int owner, int face) {
  const auto v = mesh.face(tets[owner], face);
  // In the ball of a collapse, the hull faces at the removed vertex lie on patches that do not contain the apex.
  if (gone_ != none && (v[0] == gone_ || v[1] == gone_ || v[2] == gone_)) return Outcome::geometry;
  for (int k = 0; k < 3; ++k) {
    if (v[k] != apex_.id) continue;
    if (apex_face_count_ == FaceBatch::capacity) return Outcome::too_large;
    const VertexId b = v[(k + 1) % 3], c = v[(k + 2) % 3];
    const int lb = vertices_.add(mesh, b), lc = vertices_.add(mesh, c);
    if (lb < 0 || lc < 0) return Outcome::too_large;
    apex_faces_[apex_face_count_++] = {b, c, static_cast<std::uint8_t>(lb), static_cast<std::uint8_t>(lc), owner, face};
    return Outcome::accepted;
  }
  if (batch.full()) return Outcome::too_large;
  HullFace& hull = faces_[batch.size()];
  hull = {v, {}, owner, face};
  for (int k = 0; k < 3; ++k) {
    const int l = vertices_.add(mesh, v[k]);
    if (l < 0) return Outcome::too_large;
    hull.local[k] = static_cast<std::uint8_t>(l);
  }
  batch.push(mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]]);
  return Outcome::accepted;
}

Outcome Cavity::add_triangle(const TetMesh& mesh, const Model& model, int owner, int face) {
  const TriangleId t = mesh.tets[tets[owner]].n[face].triangle();
  const Triangle& triangle = mesh.triangles[t];
  const FaceLink here = FaceLink::to_face(tets[owner], face);
  const FaceLink other = mesh.other_side(t, here);
  const bool goes = model.on_patch(apex_.tag, triangle.patch);
  if (other != outside && tets.contains(other.tet())) {  // between two tetrahedra of the cavity
    if (!goes) return Outcome::geometry;
    if (triangle.side[0] != here) return Outcome::accepted;  // recorded from the other side
    return surface_.remove(t) ? Outcome::accepted : Outcome::too_large;
  }
  if (goes && other == outside) return surface_.remove(t) ? Outcome::accepted : Outcome::too_large;
  return add_face(mesh, owner, face);
}

Outcome Cavity::propose(const TetMesh& mesh, const Model& model, const Apex& apex, VertexId gone) {
  apex_ = apex;
  gone_ = gone;
  apex_face_count_ = 0;
  batch.clear();
  surface_.clear();
  vertices_.clear();
  for (int i = 0; i < tets.size(); ++i) {
    const Tet& tet = mesh.tets[tets[i]];
    for (int f = 0; f < 4; ++f) {
      Outcome outcome = Outcome::accepted;
      if (tet.n[f].is_triangle())
        outcome = add_triangle(mesh, model, i, f);
      else if (!tets.contains(tet.n[f].tet()))
        outcome = add_face(mesh, i, f);
      if (outcome != Outcome::accepted) return outcome;
    }
  }
  if (batch.size() == 0) return Outcome::topology;
  batch.evaluate(apex_.vertex);
  return surface_.empty() ? Outcome::accepted : surface_.rejoin(mesh, model, apex_, gone);
}

bool Cavity::sees(int i) const {
  if (batch.volume[i] > batch.doubtful_volume[i]) return true;
  if (batch.volume[i] < -batch.doubtful_volume[i]) return false;
  const auto& l = faces_[i].local;
  return orientation(apex_.vertex.x, vertices_.x(l[0]), vertices_.x(l[1]), vertices_.x(l[2])) > 0;
}

bool Cavity::all_positive() const {
  for (int i = 0; i < batch.size(); ++i)
    if (!sees(i)) return false;
  return true;
}

double Cavity::worst_old_quality(const TetMesh& mesh) const {
  float worst = 1e9F;
  for (TetId t : tets.span()) worst = std::min(worst, mesh.tets[t].state.quality);
  return worst;
}

Cavity::Permit Cavity::validate(const TetMesh& mesh, const Block& block, Enclosed enclosed) {
  if (!all_positive()) return Permit(Outcome::inverted);
  if (!find_lost(mesh, enclosed) || !match(mesh)) return Permit(Outcome::topology);
  if (has_ids(block)) return Permit(Outcome::accepted);
  clear_matching();
  return Permit(Outcome::put_off);
}

bool Cavity::has_ids(const Block& block) const {
  const auto enough = [](const auto& ids, int made, int gone) {
    return made <= gone || ids.available() >= static_cast<std::size_t>(made - gone);
  };
  return enough(block.tets, batch.size(), tets.size()) &&
         enough(block.triangles, surface_.border_size(), static_cast<int>(surface_.removed().size()));
}

// False if one of them must stay.
bool Cavity::find_lost(const TetMesh& mesh, Enclosed enclosed) {
  lost_count_ = 0;
  for (TetId t : tets.span())
    for (VertexId v : mesh.tets[t].v) {
      if (v == apex_.id || vertices_.contains(v)) continue;
      const auto known = lost_.begin() + lost_count_;
      if (std::find(lost_.begin(), known, v) != known) continue;
      const bool may_go = v == gone_ || (enclosed == Enclosed::go && mesh.tag_of_vertex[v].is_in_volume());
      if (!may_go || lost_count_ == most_lost) return false;
      lost_[lost_count_++] = v;
    }
  return true;
}

bool Cavity::match(const TetMesh& mesh) {
  const bool ok = enter_edges() && borders_are_on_hull() && sides_agree(mesh);
  if (!ok) clear_matching();
  return ok;
}

bool Cavity::enter_edges() {
  for (int i = 0; i < batch.size(); ++i) {
    const auto& l = faces_[i].local;
    for (int k = 0; k < 3; ++k) {
      std::uint16_t& entry = edge_[l[k]][l[(k + 1) % 3]];
      if (entry != 0) return false;
      entry = static_cast<std::uint16_t>(1 + 3 * i + k);
    }
  }
  for (int i = 0; i < apex_face_count_; ++i) {
    std::uint16_t& entry = edge_[apex_faces_[i].local_b][apex_faces_[i].local_c];
    if (entry != 0) return false;
    entry = static_cast<std::uint16_t>(apex_base + i);
  }
  return true;
}

// Each new triangle will be a side of new tetrahedra. It would be none at the free border of a surface that ends inside
// the volume, if the cavity holds all tetrahedra around an edge of this border.
bool Cavity::borders_are_on_hull() const {
  for (int i = 0; i < surface_.border_size(); ++i) {
    const int a = vertices_.find(surface_.border(i).a), b = vertices_.find(surface_.border(i).b);
    if (a < 0 || b < 0) return false;
    const auto is_on_face = [](std::uint16_t entry) { return entry != 0 && entry < apex_base; };
    if (!is_on_face(edge_[a][b]) && !is_on_face(edge_[b][a])) return false;
  }
  return true;
}

// Every side face of a new tetrahedron meets another new tetrahedron, a face at the apex, or a new triangle; triangles
// separate regions.
bool Cavity::sides_agree(const TetMesh& mesh) const {
  for (int i = 0; i < batch.size(); ++i) {
    const auto& l = faces_[i].local;
    for (int k = 0; k < 3; ++k) {
      const int partner = edge_[l[(k + 1) % 3]][l[k]];
      if (!surface_.empty() && surface_.find_border(faces_[i].v[k], faces_[i].v[(k + 1) % 3]) >= 0) {
        if (partner >= apex_base) return false;
        continue;
      }
      if (partner == 0) return false;
      if (partner >= apex_base) continue;
      const RegionId here = mesh.region_of_tet[tets[faces_[i].owner]];
      const RegionId there = mesh.region_of_tet[tets[faces_[(partner - 1) / 3].owner]];
      if (here != there) return false;
    }
  }
  for (int i = 0; i < apex_face_count_; ++i) {
    const int partner = edge_[apex_faces_[i].local_c][apex_faces_[i].local_b];
    if (partner == 0 || partner >= apex_base) return false;
  }
  return true;
}

void Cavity::clear_matching() {
  for (int i = 0; i < batch.size(); ++i) {
    const auto& l = faces_[i].local;
    for (int k = 0; k < 3; ++k) edge_[l[k]][l[(k + 1) % 3]] = 0;
  }
  for (int i = 0; i < apex_face_count_; ++i) edge_[apex_faces_[i].local_b][apex_faces_[i].local_c] = 0;
}

}  // namespace taut
