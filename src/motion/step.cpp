#include "motion/step.hpp"

#include <algorithm>
#include <span>

#include "base/parallel.hpp"
#include "mesh/orientation.hpp"
#include "metric/length.hpp"

namespace taut {
namespace {

constexpr double least_share = 1e-6;  // a step that goes through more edges than that is a mistake

std::vector<std::uint32_t> not_positive(const TetMesh& mesh, const std::vector<Vec3>& x) {
  return indices_where(mesh.tets.size(), [&](std::size_t t) {
    const auto& v = mesh.tets[t].v;
    return mesh.tets[t].alive() && orientation(x[v[0]], x[v[1]], x[v[2]], x[v[3]]) <= 0;
  });
}

// The largest change of an edge, in the metric: that of what moves without a change of shape is zero.
double change_of(const TetMesh& mesh, const Tet& tet, const std::vector<Vec3>& x) {
  double largest = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const VertexId a = tet.v[i], b = tet.v[j];
      const Vec3 change = (x[b] - x[a]) - (mesh.x(b) - mesh.x(a));
      largest = std::max(largest, length_in(mesh.vertices[a].m, change));
    }
  return largest;
}

}  // namespace

Reach reach_of(const TetMesh& mesh, const Places& places, double most, double smallest) {
  Reach reach;
  const auto is_worth_trying = [&](double share, std::span<const std::uint32_t> in_the_way, const auto& refused) {
    if (share >= smallest) return true;
    return share >= least_share && std::ranges::any_of(in_the_way, [&](std::uint32_t t) {
             return change_of(mesh, mesh.tets[t], refused) / 2 >= smallest;
           });
  };
  for (double share = most;; share /= 2) {
    std::vector<Vec3> x = places(share);
    const auto in_the_way = not_positive(mesh, x);
    if (in_the_way.empty()) {
      reach.share = share;
      reach.places = std::move(x);
      return reach;
    }
    reach.in_the_way = static_cast<TetId>(in_the_way.front());
    if (!is_worth_trying(share / 2, in_the_way, x)) return reach;
  }
}

}  // namespace taut
