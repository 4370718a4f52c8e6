// taut adapt --geometry: a surface from another file, the report and the note, and what is refused.
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "program/fixture.hpp"
#include "program/meshes.hpp"
#include "taut/taut.hpp"

namespace taut::test {
namespace {

using nlohmann::json;

/// The unit ball.
Mesh ball(Index n) {
  Mesh mesh = cube(n);
  for (Point& p : mesh.points) {
    const Point c = {2 * p[0] - 1, 2 * p[1] - 1, 2 * p[2] - 1};
    for (std::size_t d = 0; d < 3; ++d) {
      const double a = c[(d + 1) % 3] * c[(d + 1) % 3], b = c[(d + 2) % 3] * c[(d + 2) % 3];
      p[d] = c[d] * std::sqrt(1 - a / 2 - b / 2 + a * b / 3);
    }
  }
  return mesh;
}

class GeometryRun : public ProgramTest {
protected:
  GeometryRun() {
    write("ball.mesh", mesh_text(ball(4)));
    Mesh fine = ball(8);
    fine.tetrahedra.clear();
    write("fine.mesh", mesh_text(fine));
  }
};

TEST_F(GeometryRun, VerticesLieOnTheOtherSurface) {
  expect_done(
      {"adapt", "ball.mesh", "--size", "0.4", "--geometry", "fine.mesh", "-o", "out.meshb", "--report", "out.json"});
  const json report = json::parse(read("out.json"));
  EXPECT_EQ(report["options"]["geometry"], "fine.mesh");
  EXPECT_EQ(report["off_surface"], 0);
  const Geometry geometry(read_boundary("fine.mesh"));
  const Mesh mesh = read_mesh("out.meshb");
  for (const auto& triangle : mesh.triangles)
    for (const Index v : triangle) EXPECT_LT(geometry.closest(mesh.points[v]).distance, 1e-9);
  expect_done({"quality", "out.meshb", "--check"});
}

TEST_F(GeometryRun, TheSurfaceOfTetrahedraServes) {
  Mesh fine = ball(8);
  fine.triangles.clear();
  fine.triangle_refs.clear();
  write("tetrahedra.mesh", mesh_text(fine));
  expect_done({"adapt", "ball.mesh", "--size", "0.4", "--geometry", "tetrahedra.mesh", "-o", "out.meshb"});
  const Geometry geometry(fine);
  const Mesh mesh = read_mesh("out.meshb");
  for (const auto& triangle : mesh.triangles)
    for (const Index v : triangle) EXPECT_LT(geometry.closest(mesh.points[v]).distance, 1e-9);
}

TEST_F(GeometryRun, WithoutOneTheReportHasNone) {
  expect_done({"adapt", "ball.mesh", "--size", "0.8", "-o", "out.meshb", "--report", "out.json"});
  const json report = json::parse(read("out.json"));
  EXPECT_TRUE(report["options"]["geometry"].is_null());
  EXPECT_EQ(report["off_surface"], 0);
}

TEST_F(GeometryRun, AFieldGoesWithIt) {
  write("u.sol", metric_text(Sizes(125, 1)));
  expect_done({"adapt", "ball.mesh", "--field", "u.sol", "--complexity", "100", "--hmax", "0.5", "--geometry",
               "fine.mesh", "-o", "out.meshb"});
}

TEST_F(GeometryRun, MovesWithABody) {
  write("m.json", R"({"bodies": [{"references": [0], "motions": [
      {"rotation": {"centre": [0, 0, 0], "axis": [1, 2, 3], "degrees": 20}}, {"translation": [0.1, 0, 0]}]}]})");
  const Words words = {"move",        "ball.mesh", "--motion", "m.json",     "--steps",   "3",        "-o",
                       "o-%04d.mesh", "--size",    "0.4",      "--geometry", "fine.mesh", "--report", "out.json"};
  expect_done(words);
  EXPECT_EQ(json::parse(read("out.json"))["options"]["geometry"], "fine.mesh");
  const Geometry geometry(read_boundary("fine.mesh"));
  const RigidMotion way = RigidMotion::translation({0.3, 0, 0}) * RigidMotion::rotation({0, 0, 0}, {1, 2, 3}, 60);
  const Mesh mesh = read_mesh("o-0003.mesh");
  for (const auto& triangle : mesh.triangles)
    for (const Index v : triangle) EXPECT_LT(geometry.closest(way.inverse()(mesh.points[v])).distance, 1e-9);

  const auto with = [&](const Words& more) {
    Words all = words;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  expect_error(with({"--surface", "planar"}), 2, {"--geometry with --surface planar", "taut move --help"});
  Words same = words;
  same.back() = "fine.json";
  std::filesystem::rename("fine.mesh", "o-0002.mesh");
  same[11] = "o-0002.mesh";
  expect_error(same, 2, {"o-0002.mesh", "geometry", "meshes"});
  write("cube.mesh", mesh_text(cube(4)));
  same[11] = "cube.mesh";
  expect_error(same, 2, {"cube.mesh: ", "of the mesh at"});
}

TEST_F(GeometryRun, VerticesThatStayAreNoted) {
  Mesh large = ball(4);
  for (Point& p : large.points)
    for (double& x : p) x *= 1.01;
  large.required_points = {large.triangles[0][0]};
  write_mesh("large.mesh", large);
  const Outcome found = run({"adapt", "large.mesh", "--size", "0.4", "--geometry", "fine.mesh", "-o", "out.mesh"});
  EXPECT_EQ(found.status, 0);
  EXPECT_TRUE(found.err.starts_with("taut: note: fine.mesh: 1 vertices of the boundary are not on this geometry"))
      << found.err;
}

TEST_F(GeometryRun, Refusals) {
  const auto with = [](Words more) {
    Words words = {"adapt", "ball.mesh", "--size", "0.4", "-o", "out.mesh", "--geometry"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  expect_error(with({"fine.mesh", "--surface", "planar"}), 2,
               {"--geometry with --surface planar", "--surface adapt", "taut adapt --help"});
  expect_error(with({"fine.mesh", "--surface", "fixed"}), 2, {"--geometry with --surface fixed"});
  expect_error(with({"none.mesh"}), 2, {"none.mesh"});
  expect_error(with({"fine.stl"}), 2, {"fine.stl", ".mesh"});
  write("bare.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices 1\n0 0 0 0\nTriangles 1\n1 1 1 0\nEnd\n");
  expect_error(with({"bare.mesh"}), 2, {"bare.mesh: triangle 1"});
  write("cube.mesh", mesh_text(cube(4)));
  expect_error(with({"cube.mesh"}), 2, {"cube.mesh: ", "of the mesh at"});
}

}  // namespace
}  // namespace taut::test
