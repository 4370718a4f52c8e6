#include "mesh/incidence.hpp"

#include <algorithm>

#include "base/parallel.hpp"

namespace taut {

// Few parts of the tetrahedra, each with its own array over all points, because the tetrahedra of a point may be in any
// part.
std::vector<TetId> last_tet_of_points(std::span<const std::array<Index, 4>> tets, std::size_t points) {
  constexpr std::size_t most_parts = 16;
  const Chunks parts(tets.size(), std::max(std::size_t{1} << 14, tets.size() / most_parts + 1));
  std::vector<std::vector<TetId>> last(std::max(parts.size(), std::size_t{1}));
  for_each_task(last.size(), [&](std::size_t part, int) {
    last[part].assign(points, none);
    for (std::size_t t = parts.begin(part); t < parts.end(part); ++t)
      for (Index p : tets[t]) last[part][p] = static_cast<TetId>(t);
  });
  std::vector<TetId>& found = last.back();
  for_each_index(points, [&](std::size_t p) {
    for (std::size_t part = last.size() - 1; part-- > 0 && found[p] == none;) found[p] = last[part][p];
  });
  return std::move(found);
}

Buckets<Index> tets_of_points(std::span<const std::array<Index, 4>> tets, std::size_t points) {
  return gather<Index>(tets.size(), points, [&](std::size_t t, auto put) {
    for (const Index p : tets[t]) put(p, static_cast<Index>(t));
  });
}

}  // namespace taut
