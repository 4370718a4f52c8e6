// The cost of the inner loops, on the kind of meshes and metrics for which they are written.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <span>
#include <vector>

#include "adapt/block_passes.hpp"
#include "adapt/setup.hpp"
#include "base/stopwatch.hpp"
#include "cavity/face_batch.hpp"
#include "cavity/vertex_batch.hpp"
#include "mesh/grid.hpp"
#include "mesh/orientation.hpp"
#include "metric/length.hpp"
#include "metric/quality.hpp"
#include "operators/delaunay.hpp"

namespace taut {
namespace {

constexpr std::size_t sample_count = 4096;

// Sizes of ratio 10 to 1 across a plane, as at a shock.
Tensor stretched_metric(const Point& p) {
  const double h = 0.1 * std::abs(1 - std::exp(-std::abs(p[0] - 0.5))) + 0.01;
  return {1 / (h * h), 0, 0, 100, 0, 100};
}

std::vector<Vertex> random_vertices() {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Vertex> vertices(sample_count);
  for (Vertex& v : vertices) {
    for (double& x : v.x) x = unit(random);
    v.m = stretched_metric(v.x);
  }
  return vertices;
}

using Corners = std::array<const Vertex*, 4>;

// Positive tetrahedra with edges of length near 1, like most that an operator visits.
std::vector<Corners> sample_tets(const TetMesh& mesh) {
  std::vector<Corners> tets;
  for (const Tet& t : std::span(mesh.tets).first(sample_count))
    tets.push_back({&mesh.vertices[t.v[0]], &mesh.vertices[t.v[1]], &mesh.vertices[t.v[2]], &mesh.vertices[t.v[3]]});
  return tets;
}

Session grid_problem(Index n) {
  Report report;
  return set_up(test::grid(n), stretched_metric, {}, report);
}

template <double length(const Vec3&, const Vec3&, const Sym3&, const Sym3&)>
void edge_lengths(benchmark::State& state) {
  const std::vector<Vertex> vertices = random_vertices();
  for (auto _ : state)
    for (std::size_t i = 1; i < vertices.size(); ++i)
      benchmark::DoNotOptimize(length(vertices[i - 1].x, vertices[i].x, vertices[i - 1].m, vertices[i].m));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(vertices.size() - 1));
}
BENCHMARK(edge_lengths<edge_length>);
BENCHMARK(edge_lengths<edge_length_fast>);

void shape_qualities(benchmark::State& state) {
  const Session problem = grid_problem(10);
  const std::vector<Corners> tets = sample_tets(problem.mesh);
  for (auto _ : state)
    for (const auto& [a, b, c, d] : tets)
      benchmark::DoNotOptimize(shape_quality(a->x, b->x, c->x, d->x, a->m, b->m, c->m, d->m));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(tets.size()));
}
BENCHMARK(shape_qualities);

void orientations(benchmark::State& state) {
  const Session problem = grid_problem(10);
  const std::vector<Corners> tets = sample_tets(problem.mesh);
  for (auto _ : state)
    for (const auto& [a, b, c, d] : tets) benchmark::DoNotOptimize(orientation(a->x, b->x, c->x, d->x));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(tets.size()));
}
BENCHMARK(orientations);

void delaunay_conflicts(benchmark::State& state) {
  const Session problem = grid_problem(10);
  const std::vector<Corners> tets = sample_tets(problem.mesh);
  for (auto _ : state)
    for (std::size_t i = 1; i < tets.size(); ++i) benchmark::DoNotOptimize(in_conflict(*tets[i - 1][0], tets[i]));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(tets.size() - 1));
}
BENCHMARK(delaunay_conflicts);

// The argument is the number of faces: about 10 for a swap, 24 for the ball of a vertex, 40 for an insertion.
void face_batches(benchmark::State& state) {
  const std::vector<Vertex> vertices = random_vertices();
  FaceBatch batch;
  for (int i = 0; i < state.range(0); ++i) batch.push(vertices[3 * i], vertices[3 * i + 1], vertices[3 * i + 2]);
  for (auto _ : state) {
    batch.evaluate(vertices.back());
    benchmark::DoNotOptimize(batch.quality.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(face_batches)->Arg(10)->Arg(24)->Arg(40);

// One pass after `rounds` insertion passes on a grid of a single block. Items are accepted operations. Their time
// includes the refused ones, and the cut that insertion repeats when the mesh has grown.
void measure_pass(benchmark::State& state, int rounds, void (*pass)(BlockPasses&), Tally Tallies::*kind) {
  std::size_t accepted = 0, tried = 0;
  for (auto _ : state) {
    Session problem = grid_problem(8);
    BlockPasses passes(problem, 0);
    for (int i = 0; i < rounds; ++i) {
      passes.cut();
      passes.insert({});
      passes.close();
    }
    passes.cut();
    const PassReport before = (passes.tallies().*kind).report();
    const Stopwatch watch;
    pass(passes);
    state.SetIterationTime(watch.seconds());
    const PassReport after = (passes.tallies().*kind).report();
    accepted += after.accepted - before.accepted;
    tried += after.tried - before.tried;
  }
  const auto average = benchmark::Counter::kAvgIterations;
  state.counters["accepted"] = {static_cast<double>(accepted), average};
  state.counters["tried"] = {static_cast<double>(tried), average};
  state.SetItemsProcessed(static_cast<std::int64_t>(accepted));
}

void insertions(benchmark::State& state) {
  measure_pass(
      state, 1, [](BlockPasses& passes) { passes.insert({}); }, &Tallies::insertion);
}
BENCHMARK(insertions)->UseManualTime()->Unit(benchmark::kMillisecond);

void swaps(benchmark::State& state) {
  measure_pass(
      state, 4, [](BlockPasses& passes) { passes.swap({}); }, &Tallies::swap);
}
BENCHMARK(swaps)->UseManualTime()->Unit(benchmark::kMillisecond);

void relocations(benchmark::State& state) {
  measure_pass(
      state, 4, [](BlockPasses& passes) { passes.relocate({}); }, &Tallies::relocation);
}
BENCHMARK(relocations)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace taut
