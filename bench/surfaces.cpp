// The cost of looking for the closest point on a large surface.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

#include "locate/triangle_tree.hpp"

namespace taut {
namespace {

/// A wavy square of a million triangles.
struct Waves {
  std::vector<Vec3> points;
  std::vector<std::array<Index, 3>> triangles;

  Waves() {
    constexpr Index n = 707;
    const auto at = [](Index i) { return static_cast<double>(i) / n; };
    for (Index i = 0; i <= n; ++i)
      for (Index j = 0; j <= n; ++j)
        points.push_back({at(i), at(j), 0.1 * std::sin(20 * at(i)) * std::cos(15 * at(j))});
    for (Index i = 0; i < n; ++i)
      for (Index j = 0; j < n; ++j) {
        const Index a = i * (n + 1) + j, b = a + n + 1;
        triangles.push_back({a, b, b + 1});
        triangles.push_back({a, b + 1, a + 1});
      }
  }
};

void triangle_tree_builds(benchmark::State& state) {
  const Waves waves;
  for (auto _ : state) benchmark::DoNotOptimize(TriangleTree(waves.points, waves.triangles));
}
BENCHMARK(triangle_tree_builds)->UseRealTime()->Unit(benchmark::kMillisecond);

// Of points near the surface, as samples of another surface are, but far from each other.
void closest_triangles(benchmark::State& state) {
  const Waves waves;
  const TriangleTree tree(waves.points, waves.triangles);
  std::mt19937 random(1);
  for (auto _ : state) {
    const Vec3& p = waves.points[random() % waves.points.size()];
    benchmark::DoNotOptimize(tree.closest(p + Vec3{0, 0, 1e-3}));
  }
}
BENCHMARK(closest_triangles)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace taut
