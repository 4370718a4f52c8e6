// The cost of moving a mesh as an elastic body: a ball in the middle of 3e5 tetrahedra turns by a degree.
#include <benchmark/benchmark.h>

#include <cmath>

#include "elasticity/vertex_system.hpp"
#include "mesh/build.hpp"
#include "mesh/shapes.hpp"
#include "taut/threads.hpp"

namespace taut {
namespace {

// Boxes get smaller towards the ball, as around a body in a domain: edges differ by a factor of 4.
const TetMesh& domain() {
  static const TetMesh mesh = [] {
    constexpr Index n = 37;
    Mesh grid = test::grid(n);
    test::jitter(grid, 0.1 / n, 1);
    for (Point& p : grid.points)
      for (double& x : p) x = 0.5 * (2 * x - 1) + 0.5 * std::pow(2 * x - 1, 3);
    return build(grid).mesh;
  }();
  return mesh;
}

template <class Value>
std::vector<Constraint<Value>> constraints_with(auto value_on_body) {
  std::vector<Constraint<Value>> constraints;
  for (const Vertex& v : domain().vertices) {
    const bool is_on_wall = std::ranges::any_of(v.x, [](double x) { return std::abs(x) > 0.999; });
    constraints.push_back(is_on_wall        ? prescribed(Value{})
                          : norm(v.x) < 0.1 ? prescribed(Value(value_on_body(v.x)))
                                            : Constraint<Value>{});
  }
  return constraints;
}

Vec3 turn(const Vec3& x) {
  const double angle = std::acos(-1) / 180;
  return {(std::cos(angle) - 1) * x[0] - std::sin(angle) * x[1], std::sin(angle) * x[0] + (std::cos(angle) - 1) * x[1],
          0};
}

constexpr Stiffening stiffening{.exponent = 1.5};

template <class Work>
void on(benchmark::State& state, const Work& work) {
  on_threads(static_cast<int>(state.range(0)), [&] {
    for (auto _ : state) work();
  });
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(domain().tets.size()));
}

void vertex_graph(benchmark::State& state) {
  on(state, [] { benchmark::DoNotOptimize(VertexGraph(domain())); });
}

void elastic_assembly(benchmark::State& state) {
  const VertexGraph graph(domain());
  ElasticSystem system(graph);
  on(state, [&] { system.assemble(elements_of(domain(), stiffening)); });
}

// With a start that is wrong by `wrong`.
template <class Value>
void solution(benchmark::State& state, const std::vector<Constraint<Value>>& constraints, Preconditioner kind,
              double wrong) {
  const VertexGraph graph(domain());
  VertexSystem<Value> system(graph);
  system.assemble(elements_of(domain(), stiffening));
  const SolveOptions options{{.residual = 1e-8}, kind};
  std::vector<Value> start = system.solve(constraints, {}, {{.residual = 1e-12}}).values;
  for (std::size_t i = 0; i < start.size(); ++i)
    start[i] = (1 - wrong * (1 + std::sin(static_cast<double>(i)) / 2)) * start[i];
  int iterations = 0;
  on(state, [&] { iterations = system.solve(constraints, start, options).convergence.iterations; });
  state.counters["iterations"] = iterations;
}

void displacements(benchmark::State& state, Preconditioner kind, double wrong) {
  solution<Vec3>(state, constraints_with<Vec3>(turn), kind, wrong);
}

void shares(benchmark::State& state) {
  const auto one = [](const Vec3&) { return 1.0; };
  solution<double>(state, constraints_with<double>(one), Preconditioner::block_jacobi, 1);
}

BENCHMARK(vertex_graph)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
BENCHMARK(elastic_assembly)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(displacements, cold, Preconditioner::block_jacobi, 1)
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(displacements, warm, Preconditioner::block_jacobi, 0.01)
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(displacements, cholesky, Preconditioner::incomplete_cholesky, 1)
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
BENCHMARK(shares)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

}  // namespace
}  // namespace taut
