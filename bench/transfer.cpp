// The cost of taking a field from one mesh to another.
#include "taut/transfer.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "mesh/shapes.hpp"
#include "transfer/overlap.hpp"

namespace taut {
namespace {

Mesh shaken_grid(Index n, unsigned seed) {
  Mesh mesh = test::grid(n);
  test::jitter(mesh, 0.2 / n, seed);
  return mesh;
}

std::array<Vec3, 4> corners_of(const Mesh& mesh, const std::array<Index, 4>& t) {
  return {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]};
}

// Items are pairs of tetrahedra that do overlap, of about the same size.
void overlaps(benchmark::State& state) {
  const Mesh from = shaken_grid(5, 1), to = shaken_grid(5, 2);
  std::vector<std::pair<TetFrame, std::array<Vec3, 4>>> pairs;
  for (std::size_t t = 0; t < to.tetrahedra.size(); t += 7)
    for (const auto& s : from.tetrahedra)
      if (const TetFrame frame(corners_of(to, to.tetrahedra[t])); overlap(frame, corners_of(from, s)))
        pairs.emplace_back(frame, corners_of(from, s));
  for (auto _ : state)
    for (const auto& [target, source] : pairs) benchmark::DoNotOptimize(overlap(target, source));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(pairs.size()));
}
BENCHMARK(overlaps);

// Items are tetrahedra of the target.
void transfers(benchmark::State& state, Transfer method) {
  const Mesh from = shaken_grid(16, 1), to = shaken_grid(17, 2);
  Field field;
  for (const Point& p : from.points) field.values.push_back(std::sin(5 * p[0]) * p[1]);
  for (auto _ : state) benchmark::DoNotOptimize(transfer(from, {field}, to, {.method = method, .threads = 1}));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(to.tetrahedra.size()));
}
BENCHMARK_CAPTURE(transfers, linear, Transfer::linear)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(transfers, conservative, Transfer::conservative)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace taut
