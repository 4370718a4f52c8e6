#include "partition/bisection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/metric_grid.hpp"
#include "partition/block.hpp"

namespace taut {
namespace {

constexpr unsigned rounds = 8;

std::vector<std::size_t> sizes_of(const TetMesh& mesh, const Bisection& bisection) {
  std::vector<std::size_t> sizes(bisection.parts(), 0);
  for (const Vertex& vertex : mesh.vertices) ++sizes.at(bisection.part_of(vertex.x));
  return sizes;
}

TEST(Bisection, MakesAsManyPartsAsAskedFor) {
  const TetMesh mesh = test::metric_grid(10);
  const auto count = static_cast<double>(mesh.vertices.size());
  for (unsigned round = 0; round < rounds; ++round)
    for (const std::size_t size : {20, 50, 100, 300, 500})
      EXPECT_EQ(Bisection(mesh, size, round).parts(), std::lround(count / static_cast<double>(size)));
  EXPECT_EQ(Bisection(mesh, mesh.vertices.size() + 1, 0).parts(), 1);
  EXPECT_EQ(Bisection(mesh, 1'000'000, 0).parts(), 1);
}

TEST(Bisection, MakesPartsOfAboutTheSizeAskedFor) {
  const TetMesh mesh = test::metric_grid(14);
  for (unsigned round = 0; round < rounds; ++round)
    for (const std::size_t size : {50, 130, 400, 1000})
      for (const std::size_t found : sizes_of(mesh, Bisection(mesh, size, round))) {
        EXPECT_LE(found, 2 * size) << "round " << round;
        EXPECT_GE(2.5 * static_cast<double>(found), size) << "round " << round;
      }
}

TEST(Bisection, PutsEveryPointOfSpaceIntoAPart) {
  const TetMesh mesh = test::metric_grid(6);
  const Bisection bisection(mesh, 40, 0);
  const Bisection same(mesh, 40, 0);
  for (double x = -3; x < 3; x += 0.37)
    for (double y = -3; y < 3; y += 0.37)
      for (double z = -3; z < 3; z += 0.37) {
        EXPECT_LT(bisection.part_of({x, y, z}), bisection.parts());
        EXPECT_EQ(bisection.part_of({x, y, z}), same.part_of({x, y, z}));
      }
}

TEST(Bisection, DependsOnTheLivingOnly) {
  TetMesh mesh = test::metric_grid(6);
  const Bisection before(mesh, 40, 2);
  Block block;
  block.borrow(mesh, {.vertices = 200});
  for (int i = 0; i < 100; ++i)
    block.remove_vertex(mesh, block.add_vertex(mesh, {{9, 9, 9}, identity3}, {}, CellId{0}));
  block.give_back(mesh);
  const Bisection after(mesh, 40, 2);
  EXPECT_EQ(after.parts(), before.parts());
  for (const VertexId v : ids<VertexId>(mesh.vertices.size()))
    EXPECT_TRUE(!mesh.is_vertex_alive(v) || after.part_of(mesh.x(v)) == before.part_of(mesh.x(v)));
}

TEST(Bisection, PartsOtherwiseInEveryRound) {
  const TetMesh mesh = test::metric_grid(12);
  std::vector<std::vector<std::uint32_t>> part(rounds);
  for (unsigned round = 0; round < rounds; ++round) {
    const Bisection bisection(mesh, mesh.vertices.size() / 2, round);
    for (const Vertex& vertex : mesh.vertices) part[round].push_back(bisection.part_of(vertex.x));
    for (unsigned other = 0; other < round; ++other) {
      std::size_t differ = 0;
      for (const VertexId v : ids<VertexId>(mesh.vertices.size())) differ += part[round][v] != part[other][v] ? 1 : 0;
      EXPECT_GT(differ, mesh.vertices.size() / 100) << "rounds " << other << " and " << round;
    }
  }
}

TEST(Bisection, LeavesHardlyATetrahedronAtASeamForLong) {
  const TetMesh mesh = test::metric_grid(12);
  std::vector<bool> was_inside(mesh.tets.size(), false);
  for (unsigned round = 0; round < rounds; ++round) {
    const Bisection bisection(mesh, 400, round);
    for (const TetId t : ids<TetId>(mesh.tets.size())) {
      const auto part = [&](int k) { return bisection.part_of(mesh.x(mesh.tets[t].v[k])); };
      if (part(0) == part(1) && part(0) == part(2) && part(0) == part(3)) was_inside[t] = true;
    }
  }
  EXPECT_LT(std::ranges::count(was_inside, false), 0.01 * static_cast<double>(mesh.tets.size()));
}

// Whether a line inside the box [0, extent] leads from part to part.
bool parts_along(const Bisection& bisection, const Vec3& direction, const Vec3& extent) {
  test::Random random(3);
  const auto inside = [&](const Vec3& x) {
    return x[0] >= 0 && x[0] <= extent[0] && x[1] >= 0 && x[1] <= extent[1] && x[2] >= 0 && x[2] <= extent[2];
  };
  for (int i = 0; i < 2000; ++i) {
    const Vec3 x = {random.uniform(0, extent[0]), random.uniform(0, extent[1]), random.uniform(0, extent[2])};
    const Vec3 y = x + random.uniform(-1, 1) * direction;
    if (inside(y) && bisection.part_of(x) != bisection.part_of(y)) return true;
  }
  return false;
}

TEST(Bisection, CutsAcrossTheDirectionInWhichUnitEdgesAreShortest) {
  for (const Vec3& n : {Vec3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, -1}, {1, 1, 1}, {1, -1, 1}}) {
    const double s = 1e4 / dot(n, n);
    const Sym3 thin = {s * n[0] * n[0], s * n[0] * n[1], s * n[0] * n[2],
                       s * n[1] * n[1], s * n[1] * n[2], s * n[2] * n[2]};
    const TetMesh mesh = test::metric_grid(8, 4.0 * identity3 + thin);
    const Vec3 u = cross(n, {0.3, 0.5, 0.7}), v = cross(n, u);
    for (unsigned round = 0; round < rounds; ++round) {
      const Bisection bisection(mesh, 120, round);
      EXPECT_TRUE(parts_along(bisection, n, {1, 1, 1}));
      EXPECT_FALSE(parts_along(bisection, u, {1, 1, 1}) || parts_along(bisection, v, {1, 1, 1}))
          << "across " << n[0] << " " << n[1] << " " << n[2];
    }
  }
}

TEST(Bisection, IsNotMisledByTheLongestExtent) {
  // A bar along x with unit edges as long as the bar: planes across it would cut all of them.
  const TetMesh mesh = test::metric_grid(8, {0.01, 0, 0, 400, 0, 400}, {10, 1, 1});
  for (unsigned round = 0; round < rounds; ++round) {
    const Bisection bisection(mesh, 90, round);
    EXPECT_FALSE(parts_along(bisection, {10, 0, 0}, {10, 1, 1}));
    EXPECT_TRUE(parts_along(bisection, {0, 1, 0}, {10, 1, 1}) || parts_along(bisection, {0, 0, 1}, {10, 1, 1}));
  }
}

}  // namespace
}  // namespace taut
