#include "cavity/surface_cavity.hpp"

#include <algorithm>
#include <limits>

#include "geometry/fit.hpp"

namespace taut {

bool SurfaceCavity::remove(TriangleId t) {
  if (removed_size_ == capacity) return false;
  removed_[removed_size_++] = t;
  return true;
}

void SurfaceCavity::add_edge(const Edge& edge) {
  for (int i = 0; i < edge_size_; ++i) {
    Edge& e = edges_[i];
    if (e.patch == edge.patch && ((e.a == edge.b && e.b == edge.a) || (e.a == edge.a && e.b == edge.b))) {
      ++e.count;
      return;
    }
  }
  edges_[edge_size_++] = edge;
}

void SurfaceCavity::toggle_end(VertexId v, const Edge& edge, bool stays) {
  for (int i = 0; i < end_size_; ++i) {
    End& end = ends_[i];
    if (end.v == v && end.patch == edge.patch && end.line == edge.line) {
      end.open = !end.open;
      end.stays |= stays;
      end.missing = edge.count;
      return;
    }
  }
  ends_[end_size_++] = {v, edge.patch, edge.line, true, stays, edge.count};
}

// An edge of a line that runs through the apex. If the patch is on both sides of it and the cavity has only one of
// them, the edge stays, and must have the apex as an end.
bool SurfaceCavity::take_feature(const Model& model, const Edge& edge, VertexId apex) {
  const bool stays = edge.count < model.sides_of(edge.line, edge.patch);
  if (stays && edge.a != apex && edge.b != apex) return false;
  for (const VertexId v : {edge.a, edge.b})
    if (v != apex) toggle_end(v, edge, stays);
  return true;
}

// Ends that are open have been connected to the apex on each side; one at which an edge stays must be.
bool SurfaceCavity::ends_agree(VertexId gone) const {
  return std::all_of(ends_.begin(), ends_.begin() + end_size_,
                     [&](const End& end) { return end.open ? end.missing <= 0 && end.v != gone : !end.stays; });
}

LineId SurfaceCavity::line_to(VertexId v, PatchId patch) {
  for (int i = 0; i < end_size_; ++i) {
    End& end = ends_[i];
    if (!end.open || end.v != v || end.patch != patch) continue;
    --end.missing;
    return end.line;
  }
  return none;
}

int SurfaceCavity::find_border(VertexId a, VertexId b) const {
  for (int i = 0; i < border_size_; ++i)
    if ((border_[i].a == a && border_[i].b == b) || (border_[i].a == b && border_[i].b == a)) return i;
  return -1;
}

Outcome SurfaceCavity::rejoin(const TetMesh& mesh, const Model& model, const Apex& apex, VertexId gone) {
  for (TriangleId t : removed()) {
    const Triangle& triangle = mesh.triangles[t];
    for (int k = 0; k < 3; ++k)
      add_edge({triangle.v[(k + 1) % 3], triangle.v[(k + 2) % 3], triangle.patch, triangle.line[k], 1});
  }
  for (int i = 0; i < edge_size_; ++i) {
    const Edge& e = edges_[i];
    const bool at_apex = e.a == apex.id || e.b == apex.id;
    if (e.line != none && model.on_line(apex.tag, e.line)) {
      if (!take_feature(model, e, apex.id)) return Outcome::geometry;
      continue;
    }
    if (e.count > 2 || (e.line != none && (e.count == 2 || at_apex))) return Outcome::geometry;
    if (e.count == 2 || at_apex) continue;
    if (e.a == gone || e.b == gone) return Outcome::geometry;
    if (border_size_ == capacity || find_border(e.a, e.b) >= 0) return Outcome::geometry;
    border_[border_size_++] = {e.a, e.b, e.patch, e.line, none, none, none};
  }
  for (int i = 0; i < border_size_; ++i) {
    Border& b = border_[i];
    b.line_pa = line_to(b.a, b.patch);
    b.line_bp = line_to(b.b, b.patch);
  }
  if (!ends_agree(gone)) return Outcome::geometry;
  return !model.surface.exists() || fits(mesh, model, apex) ? Outcome::accepted : Outcome::surface;
}

// What is not fair must at least be no worse than the worst before.
bool SurfaceCavity::fits(const TetMesh& mesh, const Model& model, const Apex& apex) const {
  double worst = 0;
  SeatId near = apex.tag.is_on_patch() ? apex.seat : SeatId{none};
  for (const Border& b : std::span(border_.data(), static_cast<std::size_t>(border_size_)))
    worst = std::max(worst, misfit(model, b.patch, {apex.vertex.x, mesh.x(b.a), mesh.x(b.b)}, apex.vertex.m, near));
  if (worst <= 1) return true;
  double old = 0;
  for (const TriangleId t : removed()) {
    const auto& [a, b, c] = mesh.triangles[t].v;
    old = std::max(old, misfit(model, mesh.triangles[t].patch, {mesh.x(a), mesh.x(b), mesh.x(c)}, apex.vertex.m, near));
  }
  return worst <= old && worst < std::numeric_limits<double>::infinity();
}

}  // namespace taut
