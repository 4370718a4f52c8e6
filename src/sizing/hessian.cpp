#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/parallel.hpp"
#include "mesh/door.hpp"
#include "mesh/edges.hpp"
#include "sizing/double_projection.hpp"
#include "sizing/neighbourhood.hpp"
#include "sizing/nodal.hpp"
#include "sizing/quadratic_fit.hpp"
#include "taut/error.hpp"
#include "taut/sizing.hpp"

namespace taut {
namespace {

using Hessians = std::vector<std::optional<Sym3>>;

constexpr int fewest_rings = 2;  // one ring determines a quadratic function badly even where it does
constexpr int most_rings = 4;

Sym3 moment_of(std::span<const Point> points, Index centre, std::span<const Index> neighbours) {
  Sym3 sum{};
  for (const Index q : neighbours) sum = sum + outer(points[q] - points[centre]);
  return 1 / static_cast<double>(neighbours.size()) * sum;
}

// Where two rings lie close to a quadric, as next to a flat boundary, more are taken.
std::optional<Sym3> fitted_hessian(const Mesh& mesh, std::span<const double> values, std::span<const Index> neighbours,
                                   Index centre, Neighbourhood& around) {
  QuadraticFit fit(mesh.points[centre], values[centre], moment_of(mesh.points, centre, neighbours));
  around.start_at(centre);
  std::size_t added = 0;
  for (int ring = 1; ring <= most_rings; ++ring) {
    around.grow();
    if (ring < fewest_rings) continue;
    for (; added < around.vertices().size(); ++added) {
      const Index q = around.vertices()[added];
      fit.add(mesh.points[q], values[q]);
    }
    if (auto hessian = fit.hessian()) return hessian;
  }
  return {};
}

Hessians fit_all(const Mesh& mesh, std::span<const double> values, const Buckets<Index>& neighbours) {
  Hessians hessians(mesh.points.size());
  std::vector<std::optional<Neighbourhood>> scratch(static_cast<std::size_t>(worker_count()));
  const Chunks chunks(hessians.size(), 4096);
  for_each_task(chunks.size(), [&](std::size_t chunk, int worker) {
    auto& around = scratch[static_cast<std::size_t>(worker)];
    if (!around) around.emplace(neighbours);
    for (std::size_t v = chunks.begin(chunk); v < chunks.end(chunk); ++v) {
      if (neighbours[v].empty()) hessians[v] = Sym3{};
      if (!hessians[v]) hessians[v] = fitted_hessian(mesh, values, neighbours[v], static_cast<Index>(v), *around);
    }
  });
  return hessians;
}

std::optional<Sym3> mean_of_known(const Hessians& hessians, std::span<const Index> neighbours) {
  Sym3 sum{};
  double count = 0;
  for (const Index q : neighbours) {
    if (!hessians[q]) continue;
    sum = sum + *hessians[q];
    ++count;
  }
  return count > 0 ? std::optional(1 / count * sum) : std::nullopt;
}

// Where no quadratic function is determined, the mean of the neighbours is taken, from the known ones outwards.
void fill_from_neighbours(Hessians& hessians, const Buckets<Index>& neighbours) {
  auto unknown = indices_where(hessians.size(), [&](std::size_t v) { return !hessians[v]; });
  while (!unknown.empty()) {
    std::vector<std::optional<Sym3>> means(unknown.size());
    for_each_index(unknown.size(), [&](std::size_t i) { means[i] = mean_of_known(hessians, neighbours[unknown[i]]); });
    for (std::size_t i = 0; i < unknown.size(); ++i) hessians[unknown[i]] = means[i];
    const std::size_t filled = std::erase_if(unknown, [&](Index v) { return hessians[v].has_value(); });
    if (filled == 0)
      throw InputError(
          fmt::format("vertex {}: too few vertices are linked to it to recover a Hessian, expected 10 or more "
                      "that do not lie on a quadric",
                      unknown.front() + 1));
  }
}

Tensors hessians_by_least_squares(const Mesh& mesh, std::span<const double> values) {
  const auto neighbours = neighbours_of_vertices(edges_of(mesh.tetrahedra), mesh.points.size());
  Hessians hessians = fit_all(mesh, values, neighbours);
  fill_from_neighbours(hessians, neighbours);
  Tensors result(hessians.size());
  for_each_index(result.size(), [&](std::size_t v) { result[v] = *hessians[v]; });
  return result;
}

}  // namespace

Tensors recover_hessian(const Mesh& mesh, std::span<const double> values, Recovery recovery) {
  require_sound_arrays(mesh);
  require_values(values, mesh.points.size());
  return recovery == Recovery::least_squares ? hessians_by_least_squares(mesh, values)
                                             : hessians_by_double_projection(mesh, values);
}

}  // namespace taut
