#include "geometry/classify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "geometry/patches.hpp"
#include "geometry/surface_edges.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

// Planar and straight to so many times the size of the whole: coordinates written with ten digits pass.
constexpr double flatness = 1e-9;

// What the input says of one edge of the surface, and what its triangles say.
struct Feature {
  std::array<VertexId, 2> edge{};
  int ref = 0;
  bool sharp = false, required = false, implicit = false;
  std::vector<EdgeUse> uses;
};

class Classifier {
public:
  Classifier(const Mesh& input, Built& built, double ridge_angle)
      : input_(input),
        mesh_(built.mesh),
        built_(built),
        smooth_cosine_(std::cos(ridge_angle * std::numbers::pi / 180)),
        uses_(edge_uses(mesh_.triangles)) {}

  Model run() {
    for (std::size_t r = 0; r < built_.region_refs.size(); ++r)
      model_.regions.push_back({built_.region_refs[r], built_.region_required[r] != 0, built_.region_required[r] != 0});
    model_.corners.emplace_back();  // shared by the vertices of frozen patches
    mark_required();
    find_normals();
    find_features();
    find_patches();
    find_fixed_vertices();
    find_lines();
    tag_vertices();
    for (const Feature& f : inner_edges_)
      model_.inner_edges.push_back(
          {{mesh_.origin_of_vertex[f.edge[0]], mesh_.origin_of_vertex[f.edge[1]]}, f.ref, f.sharp, f.required});
    for (const Region& region : model_.regions) model_.has_frozen_region |= region.frozen;
    return std::move(model_);
  }

private:
  void mark_required() {
    required_triangle_.assign(mesh_.triangles.size(), 0);
    for (Index t : input_.required_triangles) required_triangle_[built_.triangle_of_input[t]] = 1;
  }

  void find_normals() {
    Vec3 low = mesh_.x(0), high = low;
    for (const Vertex& v : mesh_.vertices)
      for (int d = 0; d < 3; ++d) low[d] = std::min(low[d], v.x[d]), high[d] = std::max(high[d], v.x[d]);
    tolerance_ = flatness * norm(high - low);
    for (const Triangle& t : mesh_.triangles)
      area_normal_.push_back(cross(mesh_.x(t.v[1]) - mesh_.x(t.v[0]), mesh_.x(t.v[2]) - mesh_.x(t.v[0])));
  }

  // The edges of the input by their vertices. One that is no edge of the surface is kept by freezing its shell.
  std::map<std::array<VertexId, 2>, Feature> given_edges() const {
    std::map<std::array<VertexId, 2>, Feature> given;
    std::vector<const std::array<VertexId, 2>*> of_input;
    for (std::size_t e = 0; e < input_.edges.size(); ++e) {
      const auto [a, b] = std::minmax({vertex_of(e, 0), vertex_of(e, 1)});  // of values: no reference to them is kept
      auto& feature = given[{a, b}];
      feature.edge = {a, b};
      feature.ref = input_.edge_refs.empty() ? 0 : input_.edge_refs[e];
      of_input.push_back(&feature.edge);
    }
    for (Index e : input_.ridges) given[*of_input[e]].sharp = true;
    for (Index e : input_.required_edges) given[*of_input[e]].required = true;
    return given;
  }

  VertexId vertex_of(std::size_t edge, int k) const {
    const VertexId v = built_.vertex_of_point[input_.edges[edge][k]];
    if (v == none)
      throw InputError(fmt::format("edge {} ({} {}): vertex {} is of no tetrahedron", edge + 1,
                                   input_.edges[edge][0] + 1, input_.edges[edge][1] + 1, input_.edges[edge][k] + 1));
    return v;
  }

  void find_features() {
    auto given = given_edges();
    for_each_edge(uses_, [&](std::span<const EdgeUse> uses) {
      const auto found = given.find(uses[0].edge);
      auto feature = feature_of(uses, found != given.end());
      if (!feature) return;
      if (found != given.end()) {
        feature->ref = found->second.ref;
        feature->required = found->second.required;
        feature->sharp |= found->second.sharp;
        feature->implicit = false;
        found->second.uses.push_back(uses[0]);
      }
      feature->uses.assign(uses.begin(), uses.end());
      features_.push_back(std::move(*feature));
    });
    for (const auto& [edge, feature] : given)
      if (feature.uses.empty()) inner_edges_.push_back(feature);
    for (const Feature& feature : inner_edges_) freeze_shell(feature.edge);
  }

  std::optional<Feature> feature_of(std::span<const EdgeUse> uses, bool given) const {
    Feature feature;
    feature.edge = uses[0].edge;
    if (uses.size() != 2) {
      feature.sharp = true;
      return feature;
    }
    const TriangleId s = uses[0].triangle, t = uses[1].triangle;
    const Vec3 &n = area_normal_[s], &m = area_normal_[t];
    // Interfaces may be oriented either way: compare with the orientation in which the edge is run through oppositely.
    const double sign = runs_forward(uses[0]) != runs_forward(uses[1]) ? 1 : -1;
    if (sign * dot(n, m) <= smooth_cosine_ * norm(n) * norm(m) || built_.triangle_refs[s] != built_.triangle_refs[t]) {
      feature.sharp = true;
      return feature;
    }
    feature.implicit = required_triangle_[s] != required_triangle_[t];
    if (feature.implicit || given) return feature;
    return std::nullopt;
  }

  bool runs_forward(const EdgeUse& use) const {
    return mesh_.triangles[use.triangle].v[(use.corner + 1) % 3] == use.edge[0];
  }

  // Tetrahedra at an edge inside the volume that must stay go to frozen twins of their regions.
  void freeze_shell(const std::array<VertexId, 2>& edge) {
    bool found = false;
    for (TetId t = 0; t < mesh_.tets.size(); ++t) {
      if (!mesh_.tets[t].has(edge[0]) || !mesh_.tets[t].has(edge[1])) continue;
      found = true;
      mesh_.region_of_tet[t] = frozen_twin(mesh_.region_of_tet[t]);
    }
    if (!found)
      throw InputError(fmt::format("edge ({} {}) is no edge of a tetrahedron", mesh_.origin_of_vertex[edge[0]] + 1,
                                   mesh_.origin_of_vertex[edge[1]] + 1));
  }

  RegionId frozen_twin(RegionId region) {
    auto& regions = model_.regions;
    if (regions[region].frozen) return region;
    for (std::size_t r = 0; r < regions.size(); ++r)
      if (regions[r].frozen && !regions[r].required && regions[r].ref == regions[region].ref)
        return static_cast<RegionId>(r);
    regions.push_back({regions[region].ref, true, false});
    return static_cast<RegionId>(regions.size() - 1);
  }

  // Triangles are of one patch where no feature parts them.
  void find_patches() {
    std::vector<std::array<TriangleId, 2>> joined;
    std::size_t next_feature = 0;
    for_each_edge(uses_, [&](std::span<const EdgeUse> uses) {
      if (next_feature < features_.size() && features_[next_feature].edge == uses[0].edge)
        ++next_feature;
      else
        joined.push_back({uses[0].triangle, uses[1].triangle});
    });
    model_.patches = make_patches(mesh_, joined, built_.triangle_refs, required_triangle_, tolerance_);
  }

  void find_fixed_vertices() {
    fixed_.assign(mesh_.vertices.size(), 0);
    for (Index p : input_.corners) fix_point(p);
    for (Index p : input_.required_points) fix_point(p);
    for (const Feature& f : inner_edges_) fixed_[f.edge[0]] = fixed_[f.edge[1]] = 1;
    for (TetId t = 0; t < mesh_.tets.size(); ++t)
      if (model_.regions[mesh_.region_of_tet[t]].frozen)
        for (VertexId v : mesh_.tets[t].v) fixed_[v] = 1;
    for (const Triangle& t : mesh_.triangles)
      if (model_.patches[t.patch].frozen)
        for (VertexId v : t.v) fixed_[v] = 1;
    for (const Feature& f : features_)
      if (stays(f)) fixed_[f.edge[0]] = fixed_[f.edge[1]] = 1;
    fix_pinched_vertices();
  }

  // Where parts of the mesh touch in no more than a vertex, a walk round it would find one part only.
  void fix_pinched_vertices() {
    std::vector<std::uint32_t> degree(mesh_.vertices.size(), 0);
    for (const Tet& tet : mesh_.tets)
      for (VertexId v : tet.v) ++degree[v];
    std::vector<std::uint8_t> seen(mesh_.vertices.size(), 0);
    for (const Triangle& t : mesh_.triangles) {
      if (t.side[1] != outside) continue;
      for (VertexId v : t.v) {
        if (std::exchange(seen[v], 1) != 0 || fixed_[v] != 0) continue;
        if (connected_degree(v) != degree[v]) fixed_[v] = 1;
      }
    }
  }

  // Tetrahedra at v that are reached from one of them without leaving v.
  [[nodiscard]] std::size_t connected_degree(VertexId v) const {
    std::vector<TetId> reached{mesh_.tet_of_vertex[v]};
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const TetId t = reached[i];
      for (int f = 0; f < 4; ++f) {
        const FaceLink link = mesh_.tets[t].v[f] == v ? outside : mesh_.beyond(t, f);
        if (link != outside && std::find(reached.begin(), reached.end(), link.tet()) == reached.end())
          reached.push_back(link.tet());
      }
    }
    return reached.size();
  }

  // Where parts touch in an edge, more than two of its triangles bound the domain: a shell would be one part only.
  [[nodiscard]] bool is_pinched(const Feature& f) const {
    return std::count_if(f.uses.begin(), f.uses.end(),
                         [&](const EdgeUse& use) { return mesh_.triangles[use.triangle].side[1] == outside; }) > 2;
  }

  [[nodiscard]] bool stays(const Feature& f) const { return f.required || is_dangling(f) || is_pinched(f); }

  void fix_point(Index point) {
    if (built_.vertex_of_point[point] != none) fixed_[built_.vertex_of_point[point]] = 1;
  }

  // An edge with one patch on both sides cannot be told from the patch's inside by counting sides: it stays as it is.
  [[nodiscard]] bool is_dangling(const Feature& f) const {
    for (std::size_t i = 0; i < f.uses.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (patch_of(f.uses[i]) == patch_of(f.uses[j])) return true;
    return false;
  }

  [[nodiscard]] PatchId patch_of(const EdgeUse& use) const { return mesh_.triangles[use.triangle].patch; }

  [[nodiscard]] std::vector<PatchId> patches_of(const Feature& f) const {
    std::vector<PatchId> patches;
    for (const EdgeUse& use : f.uses) patches.push_back(patch_of(use));
    std::sort(patches.begin(), patches.end());
    patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
    return patches;
  }

  // Whether the two features at v are one line: collinear, of one kind, and nothing else fixes v.
  [[nodiscard]] bool is_on_line(VertexId v) const {
    const auto& at = features_at_[v];
    if (fixed_[v] != 0 || at.size() != 2) return false;
    const Feature &f = features_[at[0]], &g = features_[at[1]];
    if (f.ref != g.ref || f.sharp != g.sharp || f.required != g.required || f.implicit != g.implicit) return false;
    if (patches_of(f) != patches_of(g)) return false;
    const Vec3 a = mesh_.x(other_end(f, v)) - mesh_.x(v), b = mesh_.x(other_end(g, v)) - mesh_.x(v);
    return dot(a, b) < 0 && norm(cross(a, b)) <= tolerance_ * std::max(norm(a), norm(b));
  }

  [[nodiscard]] static VertexId other_end(const Feature& f, VertexId v) {
    return f.edge[0] == v ? f.edge[1] : f.edge[0];
  }

  void find_lines() {
    features_at_.resize(mesh_.vertices.size());
    for (std::uint32_t f = 0; f < features_.size(); ++f)
      for (VertexId v : features_[f].edge) features_at_[v].push_back(f);
    line_of_feature_.assign(features_.size(), none);
    for (std::uint32_t f = 0; f < features_.size(); ++f)
      if (line_of_feature_[f] == none) add_line(f);
  }

  void add_line(std::uint32_t first) {
    const Feature& f = features_[first];
    const auto line = static_cast<LineId>(model_.lines.size());
    line_of_feature_[first] = line;
    VertexId ends[2];
    for (int k = 0; k < 2; ++k) {  // follow the chain both ways
      VertexId v = f.edge[k];
      for (std::uint32_t at = first; is_on_line(v);) {
        at = features_at_[v][0] == at ? features_at_[v][1] : features_at_[v][0];
        line_of_feature_[at] = line;
        v = other_end(features_[at], v);
      }
      ends[k] = v;
    }
    const Vec3 along = mesh_.x(ends[1]) - mesh_.x(ends[0]);
    model_.lines.push_back(
        {f.ref, stays(f), f.sharp, f.required, f.implicit, mesh_.x(ends[0]), (1 / norm(along)) * along, patches_of(f)});
  }

  void tag_vertices() {
    for (Tag& tag : mesh_.tag_of_vertex) tag = {};
    for (Triangle& t : mesh_.triangles)
      for (VertexId v : t.v) mesh_.tag_of_vertex[v] = {2, t.patch};
    for (std::uint32_t f = 0; f < features_.size(); ++f)
      for (const EdgeUse& use : features_[f].uses) mesh_.triangles[use.triangle].line[use.corner] = line_of_feature_[f];
    for (VertexId v = 0; v < mesh_.vertices.size(); ++v) {
      if (fixed_[v] == 0 && features_at_[v].empty()) continue;
      if (is_on_line(v))
        mesh_.tag_of_vertex[v] = {1, line_of_feature_[features_at_[v][0]]};
      else
        mesh_.tag_of_vertex[v] = {0, corner_at(v)};
    }
  }

  std::uint32_t corner_at(VertexId v) {
    Corner corner;
    if (mesh_.tag_of_vertex[v].dimension == 2) corner.patches.push_back(mesh_.tag_of_vertex[v].id);
    for (std::uint32_t f : features_at_[v]) {
      corner.lines.push_back(line_of_feature_[f]);
      for (PatchId p : patches_of(features_[f])) corner.patches.push_back(p);
    }
    std::erase_if(corner.patches, [&](PatchId p) { return model_.patches[p].frozen; });
    std::erase_if(corner.lines, [&](LineId l) { return model_.lines[l].frozen; });
    for (auto* ids : {&corner.patches, &corner.lines}) {
      std::sort(ids->begin(), ids->end());
      ids->erase(std::unique(ids->begin(), ids->end()), ids->end());
    }
    if (corner.patches.empty() && corner.lines.empty()) return 0;
    model_.corners.push_back(std::move(corner));
    return static_cast<std::uint32_t>(model_.corners.size() - 1);
  }

  const Mesh& input_;
  TetMesh& mesh_;
  Built& built_;
  double smooth_cosine_, tolerance_ = 0;
  std::vector<EdgeUse> uses_;
  Model model_;
  std::vector<std::uint8_t> required_triangle_, fixed_;
  std::vector<Vec3> area_normal_;
  std::vector<Feature> features_, inner_edges_;
  std::vector<std::vector<std::uint32_t>> features_at_;
  std::vector<LineId> line_of_feature_;
};

void freeze_surface(Model& model, TetMesh& mesh) {
  for (Patch& patch : model.patches) patch.frozen = true;
  for (Line& line : model.lines) line.frozen = true;
  for (Tag& tag : mesh.tag_of_vertex)
    if (tag.dimension < 3) tag = {0, 0};
}

}  // namespace

Model classify(const Mesh& input, Built& built, Surface surface, double ridge_angle) {
  Model model = Classifier(input, built, ridge_angle).run();
  if (surface == Surface::fixed) freeze_surface(model, built.mesh);
  return model;
}

}  // namespace taut
