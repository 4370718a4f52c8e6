#include "sizing/derivatives.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/parallel.hpp"
#include "mesh/door.hpp"
#include "mesh/edges.hpp"
#include "mesh/neighbourhood.hpp"
#include "sizing/double_projection.hpp"
#include "sizing/nodal.hpp"
#include "taut/error.hpp"
#include "taut/sizing.hpp"

namespace taut {
namespace {

using Fits = std::vector<std::optional<Derivatives>>;

constexpr int fewest_rings = 2;  // one ring determines a quadratic function badly even where it does
constexpr int most_rings = 4;

Sym3 moment_of(std::span<const Point> points, Index centre, std::span<const Index> neighbours) {
  Sym3 sum{};
  for (const Index q : neighbours) sum = sum + outer(points[q] - points[centre]);
  return 1 / static_cast<double>(neighbours.size()) * sum;
}

// Where two rings lie close to a quadric, as next to a flat boundary, more are taken.
std::optional<Derivatives> fit_around(const Mesh& mesh, std::span<const double> values,
                                      std::span<const Index> neighbours, Index centre, Neighbourhood& around) {
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
    if (auto found = fit.derivatives()) return found;
  }
  return {};
}

Fits fit_all(const Mesh& mesh, std::span<const double> values, const Buckets<Index>& neighbours) {
  Fits fits(mesh.points.size());
  std::vector<std::optional<Neighbourhood>> scratch(static_cast<std::size_t>(worker_count()));
  const Chunks chunks(fits.size(), 4096);
  for_each_task(chunks.size(), [&](std::size_t chunk, int worker) {
    auto& around = scratch[static_cast<std::size_t>(worker)];
    if (!around) around.emplace(neighbours);
    for (std::size_t v = chunks.begin(chunk); v < chunks.end(chunk); ++v) {
      if (neighbours[v].empty()) fits[v] = Derivatives{};
      if (!fits[v]) fits[v] = fit_around(mesh, values, neighbours[v], static_cast<Index>(v), *around);
    }
  });
  return fits;
}

std::optional<Derivatives> mean_of_known(const Fits& fits, std::span<const Index> neighbours) {
  Derivatives sum{};
  double count = 0;
  for (const Index q : neighbours) {
    if (!fits[q]) continue;
    sum = {sum.gradient + fits[q]->gradient, sum.hessian + fits[q]->hessian};
    ++count;
  }
  if (count == 0) return {};
  return Derivatives{1 / count * sum.gradient, 1 / count * sum.hessian};
}

[[noreturn]] void throw_undetermined(Index vertex) {
  throw InputError(fmt::format(
      "vertex {}: too few vertices around it to recover derivatives, expected 10 or more that do not lie on a quadric",
      vertex + 1));
}

// Where no quadratic function is determined, the mean of the neighbours is taken, from the known ones outwards.
void fill_from_neighbours(Fits& fits, const Buckets<Index>& neighbours) {
  auto unknown = indices_where(fits.size(), [&](std::size_t v) { return !fits[v]; });
  while (!unknown.empty()) {
    std::vector<std::optional<Derivatives>> means(unknown.size());
    for_each_index(unknown.size(), [&](std::size_t i) { means[i] = mean_of_known(fits, neighbours[unknown[i]]); });
    for (std::size_t i = 0; i < unknown.size(); ++i) fits[unknown[i]] = means[i];
    if (std::erase_if(unknown, [&](Index v) { return fits[v].has_value(); }) == 0) throw_undetermined(unknown.front());
  }
}

}  // namespace

std::vector<Derivatives> derivatives_of(const Mesh& mesh, std::span<const double> values) {
  const auto neighbours = neighbours_of_vertices(edges_of(mesh.tetrahedra), mesh.points.size());
  Fits fits = fit_all(mesh, values, neighbours);
  fill_from_neighbours(fits, neighbours);
  std::vector<Derivatives> result(fits.size());
  for_each_index(result.size(), [&](std::size_t v) { result[v] = *fits[v]; });
  return result;
}

Tensors recover_hessian(const Mesh& mesh, std::span<const double> values, Recovery recovery) {
  require_sound_arrays(mesh);
  require_values(values, mesh.points.size());
  if (recovery == Recovery::double_projection) return hessians_by_double_projection(mesh, values);
  const std::vector<Derivatives> derivatives = derivatives_of(mesh, values);
  Tensors hessians(derivatives.size());
  for_each_index(hessians.size(), [&](std::size_t v) { hessians[v] = derivatives[v].hessian; });
  return hessians;
}

}  // namespace taut
