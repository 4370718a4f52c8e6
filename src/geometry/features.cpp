#include "geometry/features.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "taut/error.hpp"

namespace taut {
namespace {

using GivenEdges = std::map<std::array<VertexId, 2>, Feature>;

// What has to be kept cannot be dropped.
void require_in_volume(const Mesh& input, const Built& built, std::size_t edge) {
  const auto& e = input.edges[edge];
  for (const Index p : e)
    if (built.vertex_of_point[p] == none)
      throw InputError(fmt::format("edge {} ({} {}) is required, but vertex {} belongs to no tetrahedron", edge + 1,
                                   e[0] + 1, e[1] + 1, p + 1));
}

// The edges of the input by their vertices.
GivenEdges given_edges(const Mesh& input, const Built& built) {
  for (const Index e : input.required_edges) require_in_volume(input, built, e);
  GivenEdges given;
  std::vector<Feature*> of_input(input.edges.size(), nullptr);
  for (std::size_t e = 0; e < input.edges.size(); ++e) {
    if (!is_in_volume(input, built, e)) continue;
    const auto& [p, q] = input.edges[e];
    const auto [a, b] = std::minmax({built.vertex_of_point[p], built.vertex_of_point[q]});
    Feature& feature = given[{a, b}];
    feature.edge = {a, b};
    feature.ref = input.edge_refs.empty() ? 0 : input.edge_refs[e];
    of_input[e] = &feature;
  }
  for (Index e : input.ridges)
    if (of_input[e] != nullptr) of_input[e]->sharp = true;
  for (Index e : input.required_edges) of_input[e]->required = true;
  return given;
}

class FeatureFinder {
public:
  FeatureFinder(const Built& built, const std::vector<std::uint8_t>& required, const RidgeTest& ridges)
      : mesh_(built.mesh),
        refs_(built.triangle_refs),
        required_(required),
        reference_(ridges.reference),
        smooth_cosine_(std::cos(ridges.angle * std::numbers::pi / 180)) {
    for (const Triangle& t : mesh_.triangles)
      area_normal_.push_back(cross(mesh_.x(t.v[1]) - mesh_.x(t.v[0]), mesh_.x(t.v[2]) - mesh_.x(t.v[0])));
  }

  // What the triangles at an edge say of it.
  [[nodiscard]] std::optional<Feature> at(std::span<const EdgeUse> uses, const Feature* given) const {
    Feature feature;
    feature.edge = uses[0].edge;
    feature.sharp = uses.size() != 2 || is_ridge(uses[0], uses[1]);
    if (feature.sharp) return feature;
    feature.implicit = required_[uses[0].triangle] != required_[uses[1].triangle];
    if (feature.implicit || (given != nullptr && parts(*given, uses))) return feature;
    return std::nullopt;
  }

private:
  [[nodiscard]] bool is_ridge(const EdgeUse& s, const EdgeUse& t) const {
    if (refs_[s.triangle] != refs_[t.triangle]) return true;
    if (reference_ != nullptr && knows(s, t))
      return reference_->patch_of(s.triangle) != reference_->patch_of(t.triangle) ||
             reference_->curve_of(s.edge) != none;
    const Vec3 &n = area_normal_[s.triangle], &m = area_normal_[t.triangle];
    // Interfaces may have either orientation: compare the normals as if both triangles traversed the edge in opposite
    // directions.
    const double sign = runs_forward(corners_of(s), s) != runs_forward(corners_of(t), t) ? 1 : -1;
    return sign * dot(n, m) <= smooth_cosine_ * norm(n) * norm(m);
  }

  [[nodiscard]] bool knows(const EdgeUse& s, const EdgeUse& t) const {
    return reference_->patch_of(s.triangle) != none || reference_->patch_of(t.triangle) != none;
  }

  [[nodiscard]] bool parts(const Feature& given, std::span<const EdgeUse> uses) const {
    return given.sharp || given.required || reference_ == nullptr || reference_->is_planar(uses[0].triangle);
  }

  [[nodiscard]] const Corners& corners_of(const EdgeUse& use) const { return mesh_.triangles[use.triangle].v; }

  const TetMesh& mesh_;
  const std::vector<int>& refs_;
  const std::vector<std::uint8_t>& required_;
  const Reference* reference_;
  double smooth_cosine_;
  std::vector<Vec3> area_normal_;
};

}  // namespace

bool is_in_volume(const Mesh& input, const Built& built, std::size_t edge) {
  return std::ranges::none_of(input.edges[edge], [&](Index p) { return built.vertex_of_point[p] == none; });
}

Features find_features(const Mesh& input, const Built& built, const std::vector<EdgeUse>& uses_of_edges,
                       const std::vector<std::uint8_t>& required, const RidgeTest& ridges) {
  GivenEdges given = given_edges(input, built);
  const FeatureFinder finder(built, required, ridges);
  Features features;
  for_each_edge(uses_of_edges, [&](std::span<const EdgeUse> uses) {
    const auto found = given.find(uses[0].edge);
    const Feature* const known = found != given.end() ? &found->second : nullptr;
    auto feature = finder.at(uses, known);
    if (feature && known != nullptr) {
      feature->ref = known->ref;
      feature->required = known->required;
      feature->sharp |= known->sharp;
      feature->implicit = false;
    }
    if (known != nullptr) given.erase(found);
    if (!feature) return;
    feature->uses.assign(uses.begin(), uses.end());
    features.surface.push_back(std::move(*feature));
  });
  for (auto& [edge, feature] : given) features.inner.push_back(std::move(feature));
  return features;
}

}  // namespace taut
