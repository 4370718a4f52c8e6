#include "motion/step.hpp"

#include "base/parallel.hpp"
#include "mesh/orientation.hpp"

namespace taut {
namespace {

std::optional<TetId> first_not_positive(const TetMesh& mesh, const std::vector<Vec3>& x) {
  const auto found = indices_where(mesh.tets.size(), [&](std::size_t t) {
    const auto& v = mesh.tets[t].v;
    return mesh.tets[t].alive() && orientation(x[v[0]], x[v[1]], x[v[2]], x[v[3]]) <= 0;
  });
  return found.empty() ? std::nullopt : std::optional<TetId>(static_cast<TetId>(found.front()));
}

}  // namespace

Reach reach_of(const TetMesh& mesh, const Places& places, double most, double least) {
  Reach reach;
  double share = most;
  do {
    reach.places = places(share);
    const auto in_the_way = first_not_positive(mesh, reach.places);
    if (!in_the_way) {
      reach.share = share;
      return reach;
    }
    reach.in_the_way = in_the_way;
    share /= 2;
  } while (share >= least);
  return reach;
}

}  // namespace taut
