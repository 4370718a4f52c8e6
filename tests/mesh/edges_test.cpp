#include "mesh/edges.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "base/with_threads.hpp"
#include "mesh/grid.hpp"

namespace taut {
namespace {

using Tets = std::vector<std::array<Index, 4>>;

std::vector<std::array<Index, 2>> by_a_set(const Tets& tets) {
  std::set<std::array<Index, 2>> edges;
  for (const auto& t : tets)
    for (const auto& [i, j] : edge_vertices) edges.insert({std::min(t[i], t[j]), std::max(t[i], t[j])});
  return {edges.begin(), edges.end()};
}

TEST(Edges, OfNoneAndOne) {
  EXPECT_TRUE(edges_of({}).empty());
  EXPECT_EQ(edges_of(Tets{{3, 1, 0, 2}}),
            (std::vector<std::array<Index, 2>>{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}));
}

TEST(Edges, OfAGrid) {
  const Mesh mesh = test::grid(4);
  const auto edges = edges_of(mesh.tetrahedra);
  EXPECT_EQ(edges, by_a_set(mesh.tetrahedra));
  // Along the axes, across squares, across boxes.
  EXPECT_EQ(edges.size(), 3 * 4 * 25 + 3 * 16 * 5 + 64);
}

TEST(Edges, OfTetrahedraAtRandom) {
  std::mt19937 generator(1);
  std::uniform_int_distribution<Index> vertex(0, 99);
  Tets tets(500);
  for (auto& t : tets) do
      t = {vertex(generator), vertex(generator), vertex(generator), vertex(generator)};
    while (std::set<Index>(t.begin(), t.end()).size() < 4);
  EXPECT_EQ(edges_of(tets), by_a_set(tets));
}

TEST(Edges, AreTheSameOnAnyNumberOfThreads) {
  const Mesh mesh = test::grid(28);
  const auto compute = [&] { return edges_of(mesh.tetrahedra); };
  const auto edges = test::with_threads(3, compute);
  EXPECT_EQ(edges, by_a_set(mesh.tetrahedra));
  EXPECT_EQ(edges, test::with_threads(1, compute));
}

}  // namespace
}  // namespace taut
