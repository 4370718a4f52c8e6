#include <gtest/gtest.h>

#include "cavity/face_batch.hpp"
#include "cavity/vertex_batch.hpp"
#include "mesh/build.hpp"
#include "mesh/orientation.hpp"
#include "mesh/shapes.hpp"
#include "metric/length.hpp"
#include "metric/quality.hpp"
#include "metric/random_metrics.hpp"

namespace taut {
namespace {

using test::Random;

struct Tetrahedron {
  Vertex p, a, b, c;
};

TEST(FaceBatch, MeasuresAsTheQualityOfTheMeanMetric) {
  Random random(1);
  for (const double smallest : {1.0, 1e-1, 1e-3}) {
    FaceBatch batch;
    const Vertex p = {random.point(), random.metric(smallest)};
    std::vector<Tetrahedron> all;
    for (int i = 0; i < FaceBatch::capacity; ++i) {
      EXPECT_FALSE(batch.full());
      all.push_back({p,
                     {random.point(), random.metric(smallest)},
                     {random.point(), random.metric(smallest)},
                     {random.point(), random.metric(smallest)}});
      batch.push(all.back().a, all.back().b, all.back().c);
    }
    EXPECT_TRUE(batch.full());
    batch.evaluate(p);
    for (int i = 0; i < batch.size(); ++i) {
      const auto& [q, a, b, c] = all[i];
      EXPECT_NEAR(batch.volume[i], six_volumes(p.x, a.x, b.x, c.x), 1e-14);
      const double expected = shape_quality(q.x, a.x, b.x, c.x, q.m, a.m, b.m, c.m);
      EXPECT_NEAR(batch.quality[i], expected, 1e-9 * std::abs(expected) + 1e-13) << i;
      EXPECT_LT(batch.doubtful_volume[i], 1e-13);
    }
  }
}

TEST(FaceBatch, TheRegularTetrahedronIsPerfectFromOneSideAndInvertedFromTheOther) {
  const Vec3 a = {1, 1, 1}, b = {-1, 1, -1}, c = {1, -1, -1}, d = {-1, -1, 1};
  FaceBatch batch;
  for (int repeat = 0; repeat < 2; ++repeat) {
    batch.clear();
    EXPECT_EQ(batch.size(), 0);
    batch.push({b, identity3}, {c, identity3}, {d, identity3});
    batch.push({c, identity3}, {b, identity3}, {d, identity3});
    batch.evaluate({a, identity3});
    EXPECT_EQ(batch.size(), 2);
    EXPECT_NEAR(batch.quality[0], 1, 1e-15);
    EXPECT_NEAR(batch.volume[0], 16, 1e-13);
    EXPECT_NEAR(batch.quality[1], -1, 1e-15);
  }
}

TEST(FaceBatch, TheSignOfAVolumeThatIsNotInDoubtIsExact) {
  Random random(2);
  int doubtful = 0, certain_of_small = 0;
  for (int i = 0; i < 20000; ++i) {
    const double offset = random.uniform(-1, 1) * std::exp2(random.uniform(-60, -40));
    const Vec3 shift = std::exp2(random.uniform(0, 20)) * random.point();
    const Vec3 a = random.point() + shift, b = random.point() + shift, c = random.point() + shift;
    const double s = random.uniform(-2, 2), t = random.uniform(-2, 2);
    const Vec3 p = a + s * (b - a) + t * (c - a) + offset * cross(b - a, c - a);
    FaceBatch batch;
    batch.push({a, identity3}, {b, identity3}, {c, identity3});
    batch.evaluate({p, identity3});
    const double v = batch.volume[0];
    if (std::abs(v) <= batch.doubtful_volume[0]) {
      ++doubtful;
      continue;
    }
    ++certain_of_small;
    ASSERT_EQ(v > 0 ? 1 : -1, exact_orientation(p, a, b, c)) << i;
  }
  EXPECT_GT(doubtful, 1000) << "the test has too few doubtful cases";
  EXPECT_GT(certain_of_small, 1000);
}

TEST(FaceBatch, ExactlyFlatIsInDoubt) {
  const double x = 0.1 + 0.2;
  FaceBatch batch;
  batch.push({{x, 0.1, 0.7}, identity3}, {{x, 0.3, 0.2}, identity3}, {{x, 0.9, 0.4}, identity3});
  batch.evaluate({{x, 0.5, 0.5}, identity3});
  EXPECT_LE(std::abs(batch.volume[0]), batch.doubtful_volume[0]);
}

TetMesh mesh_of_random_metrics() {
  TetMesh mesh = build(test::cube(4)).mesh;
  Random random(3);
  for (Vertex& v : mesh.vertices) v.m = random.metric(0.01);
  return mesh;
}

TEST(VertexBatch, NumbersInTheOrderOfMention) {
  const TetMesh mesh = mesh_of_random_metrics();
  VertexBatch batch;
  for (int repeat = 0; repeat < 2; ++repeat) {
    batch.clear();
    EXPECT_EQ(batch.add(mesh, VertexId{40}), 0);
    EXPECT_EQ(batch.add(mesh, VertexId{7}), 1);
    EXPECT_EQ(batch.add(mesh, VertexId{40}), 0);
    EXPECT_EQ(batch.add(mesh, VertexId{8}), 2);
    EXPECT_EQ(batch.size(), 3);
    EXPECT_EQ(batch.id(1), 7);
    EXPECT_EQ(batch.x(1), mesh.x(VertexId{7}));
    EXPECT_TRUE(batch.contains(VertexId{8}));
    EXPECT_FALSE(batch.contains(VertexId{9}));
  }
  for (const VertexId v : mesh.vertex_ids()) {
    if (batch.size() == VertexBatch::capacity) break;
    EXPECT_GE(batch.add(mesh, v), 0);
  }
  EXPECT_EQ(batch.add(mesh, VertexId{124}), -1);
  EXPECT_EQ(batch.add(mesh, VertexId{40}), 0) << "vertices that are already there are still found";
  EXPECT_EQ(batch.size(), VertexBatch::capacity);
}

TEST(VertexBatch, MeasuresAsTheFastEdgeLength) {
  const TetMesh mesh = mesh_of_random_metrics();
  Random random(4);
  VertexBatch batch;
  for (int n = 1; n <= VertexBatch::capacity; ++n) {
    (void)batch.add(mesh, static_cast<VertexId>(2 * n % 125));
    const Vertex apex = {random.point(), random.metric(0.01)};
    const auto lengths = batch.lengths(apex);
    ASSERT_EQ(lengths.size(), static_cast<std::size_t>(batch.size()));
    for (int i = 0; i < batch.size(); ++i) {
      const Vertex& q = mesh.vertices[batch.id(i)];
      const double expected = edge_length_fast(apex.x, q.x, apex.m, q.m);
      EXPECT_NEAR(lengths[i], expected, 1e-11 * expected);
    }
  }
}

TEST(VertexBatch, SumsWeightedEdges) {
  const TetMesh mesh = mesh_of_random_metrics();
  VertexBatch batch;
  std::vector<double> weights;
  const Vec3 p = {0.3, 0.4, 0.5};
  Vec3 expected{};
  for (const VertexId v : {VertexId{3}, VertexId{30}, VertexId{60}, VertexId{90}, VertexId{120}}) {
    (void)batch.add(mesh, v);
    weights.push_back(0.1 * static_cast<int>(v) - 5);
    expected = expected + weights.back() * (p - mesh.x(v));
  }
  EXPECT_LT(norm(batch.weighted_edges(p, weights) - expected), 1e-13);
}

}  // namespace
}  // namespace taut
