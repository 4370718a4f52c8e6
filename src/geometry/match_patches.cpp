#include "geometry/match_patches.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "base/parallel.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

// Cosines of the angle between a triangle and a patch: less is perpendicular; and of planes, less is another plane.
constexpr double perpendicular = 0.25, nearly_parallel = 0.7;

// Share of the longest edge up to which a plane of the mesh may be away from the patch for which it stands.
constexpr double near_plane = 0.2;

// Costs are shares of the longest edge. Patches that differ by less are told apart by the neighbours.
constexpr double weight_of_turn = 0.5, cost_of_other_sense = 0.2, clearly_worse = 0.15;

struct Candidate {
  PatchId patch = none;
  double cost = std::numeric_limits<double>::infinity();
  double distance = 0;  // as a share of the longest edge
  double cosine = 1;
};

struct Choice {
  Candidate best, second;
  [[nodiscard]] bool is_sure() const { return second.cost > best.cost + clearly_worse; }

  void add(const Candidate& candidate) {
    if (candidate.cost < best.cost)
      second = std::exchange(best, candidate);
    else if (candidate.cost < second.cost)
      second = candidate;
  }
};

class Matcher {
public:
  Matcher(const ReferenceSurface& surface, const Built& built, const std::vector<Patch>& patches)
      : surface_(surface), mesh_(built.mesh), refs_(built.triangle_refs), patches_(patches) {
    for (const PatchId p : ids<PatchId>(surface.patches().size())) {
      all_.push_back(p);
      of_ref_[surface.patches()[p].ref].push_back(p);
    }
    choices_.resize(mesh_.triangles.size());
  }

  void choose() {
    for_each_index(choices_.size(), [&](std::size_t t) { choices_[t] = choice_of(static_cast<TriangleId>(t)); });
  }

  // What is unsure follows its neighbours, from those that are sure on.
  void vote(const std::vector<EdgeUse>& uses) {
    const auto neighbours = neighbours_of(uses);
    std::vector<std::uint8_t> is_sure(choices_.size());
    std::vector<TriangleId> unsure;
    for (const TriangleId t : mesh_.triangle_ids()) {
      is_sure[t] = choices_[t].is_sure() ? 1 : 0;
      if (is_sure[t] == 0) unsure.push_back(t);
    }
    for (std::size_t before = unsure.size() + 1; unsure.size() < before;) {
      before = unsure.size();
      std::vector<TriangleId> decided, rest;
      for (const TriangleId t : unsure) (decide(choices_[t], neighbours[t], is_sure) ? decided : rest).push_back(t);
      for (const TriangleId t : decided) is_sure[t] = 1;
      unsure = std::move(rest);
    }
  }

  // A plane of the mesh belongs to the surface if most of it lies there.
  void drop_other_planes() {
    std::vector<double> on(patches_.size(), 0), all(patches_.size(), 0);
    for (const TriangleId t : mesh_.triangle_ids()) {
      const double area = norm(area_normal(t));
      const Candidate& best = choices_[t].best;
      all[patch(t)] += area;
      if (best.distance <= near_plane && std::abs(best.cosine) >= nearly_parallel && best.patch != none)
        on[patch(t)] += area;
    }
    for (const TriangleId t : mesh_.triangle_ids())
      if (is_planar(t) && on[patch(t)] < 0.5 * all[patch(t)]) choices_[t] = {};
  }

  [[nodiscard]] std::vector<PatchMatch> matches() const {
    std::vector<PatchMatch> matches;
    for (const TriangleId t : mesh_.triangle_ids()) {
      const Candidate& best = choices_[t].best;
      if (best.patch == none && !is_planar(t) && !patches_[patch(t)].required) refuse(t);
      matches.push_back({best.patch, best.cosine < 0 ? -1.0 : 1.0});
    }
    return matches;
  }

private:
  // Across edges between two triangles of one reference.
  [[nodiscard]] std::vector<std::vector<TriangleId>> neighbours_of(const std::vector<EdgeUse>& uses) const {
    std::vector<std::vector<TriangleId>> neighbours(choices_.size());
    for_each_edge(uses, [&](std::span<const EdgeUse> at) {
      if (at.size() != 2 || refs_[at[0].triangle] != refs_[at[1].triangle]) return;
      neighbours[at[0].triangle].push_back(at[1].triangle);
      neighbours[at[1].triangle].push_back(at[0].triangle);
    });
    return neighbours;
  }

  [[nodiscard]] PatchId patch(TriangleId t) const { return mesh_.triangles[t].patch; }
  [[nodiscard]] bool is_planar(TriangleId t) const { return !patches_[patch(t)].frozen(); }

  [[nodiscard]] Vec3 area_normal(TriangleId t) const {
    const auto& [a, b, c] = mesh_.triangles[t].v;
    return cross(mesh_.x(b) - mesh_.x(a), mesh_.x(c) - mesh_.x(a));
  }

  [[nodiscard]] const std::vector<PatchId>& candidates(int ref) const {
    static const std::vector<PatchId> nothing;
    if (const auto found = of_ref_.find(ref); found != of_ref_.end()) return found->second;
    return ref == 0 || (of_ref_.size() == 1 && of_ref_.begin()->first == 0) ? all_ : nothing;
  }

  [[nodiscard]] Choice choice_of(TriangleId t) const {
    const auto& [a, b, c] = mesh_.triangles[t].v;
    const Vec3 centre = (1.0 / 3) * (mesh_.x(a) + mesh_.x(b) + mesh_.x(c));
    const double longest =
        std::max({norm(mesh_.x(b) - mesh_.x(a)), norm(mesh_.x(c) - mesh_.x(b)), norm(mesh_.x(a) - mesh_.x(c))});
    const Vec3 n = area_normal(t), normal = (1 / norm(n)) * n;
    Choice choice;
    for (const PatchId p : candidates(refs_[t])) {
      if (surface_.patches()[p].tree.distance_bound(centre) > farthest_share * longest) continue;
      const OnPatch at = surface_.closest_on(p, centre);
      const double distance = at.distance / longest, cosine = dot(normal, at.normal);
      if (distance > farthest_share || std::abs(cosine) < perpendicular) continue;
      const double turn = weight_of_turn * (1 - std::abs(cosine)) + (cosine < 0 ? cost_of_other_sense : 0);
      choice.add({p, distance + turn, distance, cosine});
    }
    return choice;
  }

  // By more neighbours; by itself if these are equal. False if no neighbour is sure.
  [[nodiscard]] bool decide(Choice& choice, const std::vector<TriangleId>& neighbours,
                            const std::vector<std::uint8_t>& sure) const {
    int best = 0, second = 0;
    for (const TriangleId u : neighbours) {
      if (sure[u] == 0) continue;
      best += choices_[u].best.patch == choice.best.patch ? 1 : 0;
      second += choices_[u].best.patch == choice.second.patch ? 1 : 0;
    }
    if (second > best) std::swap(choice.best, choice.second);
    return best + second > 0;
  }

  [[noreturn]] void refuse(TriangleId t) const {
    const std::string where = place_of(mesh_, mesh_.triangles[t].v);
    if (candidates(refs_[t]).empty())
      throw InputError(fmt::format("geometry: no patch of reference {} found, which triangle {} has", refs_[t], where));
    throw InputError(
        fmt::format("geometry: triangle {} does not lie along any patch of its reference {}, expected one within half "
                    "an edge of its centre",
                    where, refs_[t]));
  }

  const ReferenceSurface& surface_;
  const TetMesh& mesh_;
  const std::vector<int>& refs_;
  const std::vector<Patch>& patches_;
  std::vector<PatchId> all_;
  std::map<int, std::vector<PatchId>> of_ref_;
  std::vector<Choice> choices_;  // by triangle
};

}  // namespace

std::string place_of(const TetMesh& mesh, std::span<const VertexId> vertices) {
  std::vector<std::uint32_t> numbers;
  Vec3 centre{};
  for (const VertexId v : vertices) {
    numbers.push_back(mesh.origin_of_vertex[v] + 1);
    centre = centre + (1.0 / static_cast<double>(vertices.size())) * mesh.x(v);
  }
  return fmt::format("{} of the mesh at ({:.6g} {:.6g} {:.6g})", fmt::join(numbers, " "), centre[0], centre[1],
                     centre[2]);
}

std::vector<PatchMatch> match_patches(const ReferenceSurface& surface, const Built& built,
                                      const std::vector<Patch>& patches, const std::vector<EdgeUse>& uses) {
  Matcher matcher(surface, built, patches);
  matcher.choose();
  matcher.vote(uses);
  matcher.drop_other_planes();
  return matcher.matches();
}

}  // namespace taut
