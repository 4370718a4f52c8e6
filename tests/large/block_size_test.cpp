// The loss of quality by blocks, on a mesh large enough for blocks of 64 thousand vertices. Built only in releases.
#include <gtest/gtest.h>

#include <cmath>

#include "adapt/checks.hpp"
#include "mesh/shapes.hpp"
#include "taut/adapt.hpp"

namespace taut {
namespace {

// A planar shock (Dobrzynski and Frey 2008, 5.1) in a cube of side 1: a million tetrahedra.
Tensor shock(const Point& p) {
  const double across = (0.1 * std::abs(1 - std::exp(-2 * std::abs(p[0] - 0.75))) + 0.0015) / 2.75, along = 0.1 / 2.75;
  return {std::pow(across, -2), 0, 0, std::pow(along, -2), 0, std::pow(along, -2)};
}

AdaptResult run(std::size_t block_size) {
  const Mesh mesh = test::cube(20);
  AdaptOptions options;
  options.block_size = block_size;
  return adapt(mesh, test::sampled(mesh, shock), options);
}

TEST(BlockSize, LeavesQualityAsItIs) {
  const AdaptResult whole = run(0);
  EXPECT_EQ(whole.report.blocks, 1);
  EXPECT_GT(whole.report.quality.vertices, 150000);
  EXPECT_GT(whole.report.quality.unit_edges, 0.99);
  for (const std::size_t size : {8192, 16384, 65536}) {
    const AdaptResult parts = run(size);
    EXPECT_GT(parts.report.blocks, 1);
    EXPECT_NEAR(parts.report.quality.unit_edges, whole.report.quality.unit_edges, 0.001) << size;
    EXPECT_NEAR(parts.report.quality.tau, whole.report.quality.tau, 0.002) << size;
    EXPECT_LT(parts.report.quality.Q_max, 6) << size;
    EXPECT_GT(parts.report.passes[0].put_off, 0);
  }
}

}  // namespace
}  // namespace taut
