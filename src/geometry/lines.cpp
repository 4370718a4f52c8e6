#include "geometry/lines.hpp"

#include <algorithm>
#include <utility>

#include "geometry/frozen.hpp"

namespace taut {
namespace {

using FeatureIndex = FeatureGraph::FeatureIndex;

bool are_of_one_kind(const Feature& f, const Feature& g) {
  return f.ref == g.ref && f.sharp == g.sharp && f.required == g.required && f.implicit == g.implicit;
}

// Follows the chain of features from one end of `f` as far as it is one line, or back to f; they all become part of it.
// Returns the last vertex.
VertexId follow(const FeatureGraph& graph, FeatureIndex f, VertexId v, LineId line, std::vector<LineId>& line_of) {
  const FeatureIndex first = f;
  while (graph.is_on_line(v)) {
    f = graph.at(v)[0] == f ? graph.at(v)[1] : graph.at(v)[0];
    if (f == first) break;
    line_of[f] = line;
    v = graph.other_end(f, v);
  }
  return v;
}

Straight straight_through(const Vec3& begin, const Vec3& end) {
  const Vec3 along = end - begin;
  return {begin, (1 / norm(along)) * along};
}

}  // namespace

FeatureGraph::FeatureGraph(const TetMesh& mesh, std::span<const Feature> features,
                           const std::vector<std::uint8_t>& fixed, double tolerance, const Reference* reference)
    : mesh_(mesh),
      features_(features),
      fixed_(fixed),
      tolerance_(tolerance),
      reference_(reference),
      features_at_(mesh.vertices.size()) {
  for (FeatureIndex f = 0; f < features.size(); ++f)
    for (VertexId v : features[f].edge) features_at_[v].push_back(f);
}

bool FeatureGraph::is_on_line(VertexId v) const {
  const auto& at = features_at_[v];
  if (fixed_[v] != 0 || at.size() != 2) return false;
  if (!are_of_one_kind(features_[at[0]], features_[at[1]]) || patches_of(at[0]) != patches_of(at[1])) return false;
  if (bent_along(at[0]) != none || bent_along(at[1]) != none) return bent_along(at[0]) == bent_along(at[1]);
  const Vec3 a = mesh_.x(other_end(at[0], v)) - mesh_.x(v), b = mesh_.x(other_end(at[1], v)) - mesh_.x(v);
  return dot(a, b) < 0 && norm(cross(a, b)) <= tolerance_ * std::max(norm(a), norm(b));
}

LineId FeatureGraph::bent_along(FeatureIndex f) const {
  const LineId curve = reference_ != nullptr ? reference_->curve_of(features_[f].edge) : LineId{none};
  return curve != none && !reference_->is_straight(curve) ? curve : LineId{none};
}

std::vector<PatchId> FeatureGraph::patches_of(FeatureIndex f) const {
  std::vector<PatchId> patches;
  for (const EdgeUse& use : features_[f].uses) patches.push_back(mesh_.triangles[use.triangle].patch);
  std::ranges::sort(patches);
  return patches;
}

Lines find_lines(const TetMesh& mesh, const FeatureGraph& graph) {
  Lines found;
  found.line_of_feature.assign(graph.features().size(), none);
  for (FeatureIndex first = 0; first < graph.features().size(); ++first) {
    if (found.line_of_feature[first] != none) continue;
    const Feature& f = graph.features()[first];
    const auto line = static_cast<LineId>(found.lines.size());
    found.line_of_feature[first] = line;
    const VertexId begin = follow(graph, first, f.edge[0], line, found.line_of_feature);
    const VertexId end = follow(graph, first, f.edge[1], line, found.line_of_feature);
    Line made{f.ref, stays(mesh, f), f.sharp, f.required, f.implicit, {}, graph.patches_of(first)};
    if (const LineId curve = graph.bent_along(first); curve != none)
      made.shape = Bent{.curve = curve};
    else
      made.shape = straight_through(mesh.x(begin), mesh.x(end));
    found.lines.push_back(std::move(made));
  }
  return found;
}

}  // namespace taut
