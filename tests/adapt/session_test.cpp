// A session after vertices have been moved from outside, and rounds with a choice of passes.
#include "adapt/session.hpp"

#include <gtest/gtest.h>

#include "adapt/checks.hpp"
#include "adapt/fields.hpp"
#include "adapt/rounds.hpp"
#include "adapt/setup.hpp"
#include "mesh/invariants.hpp"
#include "mesh/shapes.hpp"
#include "metric/quality.hpp"
#include "metric/random_metrics.hpp"

namespace taut {
namespace {

Mesh disturbed_cube(Index n) {
  Mesh mesh = test::cube(n);
  test::jitter(mesh, 0.03, 1);
  return mesh;
}

Session session_of(const Mesh& mesh, const Metric& metric) {
  Report report;
  return set_up(mesh, metric, {}, report);
}

std::vector<VertexId> all_vertices(const TetMesh& mesh) {
  std::vector<VertexId> all;
  for (const VertexId v : mesh.vertex_ids()) all.push_back(v);
  return all;
}

void expect_qualities_right(const Session& session) {
  const TetMesh& m = session.mesh;
  for (const Tet& t : m.tets) {
    const auto& v = t.v;
    EXPECT_NEAR(t.state.quality,
                shape_quality(m.x(v[0]), m.x(v[1]), m.x(v[2]), m.x(v[3]), m.vertices[v[0]].m, m.vertices[v[1]].m,
                              m.vertices[v[2]].m, m.vertices[v[3]].m),
                1e-6);
  }
}

TEST(Session, AsksTheTargetAgainWhereVerticesMoved) {
  const MetricFunction field = test::front(0.3, 0.6);
  for (const bool by_function : {true, false}) {
    const Mesh mesh = disturbed_cube(6);
    Session session = session_of(mesh, by_function ? Metric(field) : Metric(test::sampled(mesh, field)));
    std::vector<VertexId> moved;
    for (const VertexId v : session.mesh.vertex_ids())
      if (session.mesh.tag_of_vertex[v].is_in_volume() && v % 3 == 0) moved.push_back(v);
    ASSERT_GT(moved.size(), 20);
    for (VertexId v : moved) session.mesh.vertices[v].x = session.mesh.x(v) + Vec3{0.02, -0.01, 0.015};
    for (Tet& t : session.mesh.tets) t.state.tried.set(Trial::edge_swap, 3);
    for (VertexState& state : session.mesh.state_of_vertex) state.restless = false;
    const std::vector<Tet> before = session.mesh.tets;
    session.refresh(moved);
    expect_qualities_right(session);
    for (VertexId v : moved) {
      CellId host = session.mesh.host_of_vertex[v];
      EXPECT_EQ(session.mesh.vertices[v].m, session.target->at(session.mesh.x(v), host));
      EXPECT_EQ(host, session.mesh.host_of_vertex[v]);
    }
    for (std::size_t i = 0; i < before.size(); ++i) {
      const Tet& t = session.mesh.tets[i];
      const bool at_moved = std::ranges::any_of(t.v, [&](VertexId v) { return std::ranges::count(moved, v) > 0; });
      const float old = before[i].state.quality;
      const bool has_changed = std::abs(t.state.quality - old) > 0.0101F * old;
      const bool is_retried = !t.state.tried.has(Trial::edge_swap, 3);
      EXPECT_TRUE(is_retried || !has_changed);
      EXPECT_TRUE(at_moved || !is_retried);
      for (VertexId v : t.v) EXPECT_TRUE(!is_retried || session.mesh.state_of_vertex[v].restless);
    }
  }
}

// By how many tetrahedra swaps are to be tried again after a motion.
template <class Motion>
std::size_t retried_after(Session& session, Motion motion) {
  for (Vertex& v : session.mesh.vertices) v.x = motion(v.x);
  for (Tet& t : session.mesh.tets) t.state.tried.set(Trial::edge_swap, 3);
  for (VertexState& state : session.mesh.state_of_vertex) state.restless = false;
  session.refresh(all_vertices(session.mesh));
  std::size_t count = 0;
  for (const Tet& t : session.mesh.tets) {
    const bool retried = !t.state.tried.has(Trial::edge_swap, 3);
    count += retried ? 1 : 0;
    for (VertexId v : t.v) EXPECT_TRUE(!retried || session.mesh.state_of_vertex[v].restless);
  }
  return count;
}

TEST(Session, TriesNothingAgainWhereShapesAreAsTheyWere) {
  Session session = session_of(disturbed_cube(4), test::uniform(0.3));
  EXPECT_EQ(retried_after(session, [](const Vec3& x) { return x + Vec3{0.5, 0.25, -1}; }), 0);
  expect_qualities_right(session);
}

TEST(Session, TriesAgainWhatIsBad) {
  Session session = session_of(disturbed_cube(4), test::uniform(0.3));
  ASSERT_GT(retried_after(session, [](const Vec3& x) { return Vec3{x[0], x[1], 0.3 * x[2]}; }), 0);
  std::size_t bad = 0;
  for (const Tet& t : session.mesh.tets) bad += t.state.quality <= 0.4F ? 1 : 0;
  EXPECT_GT(bad, 0);
  EXPECT_EQ(retried_after(session, [](const Vec3& x) { return x + Vec3{0.5, 0.25, -1}; }), bad);
}

TEST(Session, NoticesSmallChangesThatAddUp) {
  Session session = session_of(disturbed_cube(4), test::uniform(0.3));
  const auto shear = [](const Vec3& x) { return Vec3{x[0] + 0.002 * x[2], x[1], x[2]}; };
  EXPECT_LT(retried_after(session, shear), session.mesh.tet_count() / 20);
  std::size_t retried = 0;
  for (int step = 0; step < 100; ++step) retried += retried_after(session, shear);
  EXPECT_GT(retried, session.mesh.tet_count() / 2);
}

TEST(Session, FitsThePlanesAndLinesOfABodyThatTurned) {
  Session session = session_of(test::cube(3), test::uniform(0.3));
  const Model before = session.model;
  TetMesh& mesh = session.mesh;
  const auto turned = [](const Vec3& x) {
    return Vec3{0.6 * x[0] - 0.8 * x[1] + 2, 0.8 * x[0] + 0.6 * x[1], x[2] - 1};
  };
  for (Vertex& v : mesh.vertices) v.x = turned(v.x);
  session.refresh(all_vertices(mesh));
  EXPECT_EQ(session.model.corners.size(), before.corners.size());
  for (std::size_t p = 0; p < before.patches.size(); ++p) {
    const Plane &old = std::get<Plane>(before.patches[p].shape), &now = std::get<Plane>(session.model.patches[p].shape);
    EXPECT_LT(norm(now.normal - (turned(old.normal) - turned({0, 0, 0}))), 1e-15);
  }
  for (const VertexId v : mesh.vertex_ids()) {
    const Tag tag = mesh.tag_of_vertex[v];
    EXPECT_LT(norm(session.model.project(tag, mesh.x(v)) - mesh.x(v)), 1e-14);
  }
}

TEST(Session, FreezesWhatIsNeitherPlanarNorStraightAnyMore) {
  Session session = session_of(test::cube(4), test::uniform(0.3));
  TetMesh& mesh = session.mesh;
  std::vector<VertexId> moved;
  for (const VertexId v : mesh.vertex_ids())
    if (mesh.x(v)[2] == 1) moved.push_back(v);
  for (VertexId v : moved) mesh.vertices[v].x[2] += 0.1 * mesh.x(v)[0] * (1 - mesh.x(v)[0]);  // bends the top
  session.refresh(moved);
  std::size_t frozen = 0, bent = 0;
  for (const Patch& patch : session.model.patches) frozen += patch.frozen() ? 1 : 0;
  for (const Line& line : session.model.lines) bent += line.frozen ? 1 : 0;
  EXPECT_EQ(frozen, 1) << "the top; its bent edges lie in planes";
  EXPECT_EQ(bent, 2);
  for (VertexId v : moved) EXPECT_TRUE(mesh.tag_of_vertex[v].is_at_corner());
  for (const Triangle& t : mesh.triangles)
    for (VertexId v : t.v)
      EXPECT_EQ(session.model.on_patch(mesh.tag_of_vertex[v], t.patch), !session.model.patches[t.patch].frozen());
}

TEST(Rounds, WithoutInsertionAndCollapseKeepTheVertices) {
  Session session = session_of(disturbed_cube(6), test::front(0.4, 0.6));
  const std::size_t vertices = session.mesh.vertex_count();
  Report report;
  run_rounds(session, {.most = 8, .passes = {.insertion = false, .collapse = false}}, {}, report);
  EXPECT_EQ(session.mesh.vertices.size(), vertices);
  EXPECT_EQ(first_broken_invariant(session.mesh), "");
  std::size_t operations = 0;
  for (const PassReport& pass : report.passes) operations += pass.accepted;
  EXPECT_GT(operations, 100);
}

TEST(Rounds, GoOnWithASessionWhoseVerticesMoved) {
  Session session = session_of(disturbed_cube(6), test::front(0.4, 0.6));
  Report report;
  run_rounds(session, {.most = 4}, {}, report);
  std::vector<VertexId> moved;
  for (const VertexId v : session.mesh.vertex_ids())
    if (session.mesh.tag_of_vertex[v].is_in_volume() && v % 5 == 0) moved.push_back(v);
  for (VertexId v : moved) session.mesh.vertices[v].x = session.mesh.x(v) + Vec3{1e-4, 0, 1e-4};
  session.refresh(moved);
  run_rounds(session, {.most = 4}, {}, report);
  EXPECT_EQ(first_broken_invariant(session.mesh), "");
  expect_qualities_right(session);
}

}  // namespace
}  // namespace taut
