// taut move: a cubic hole that travels and turns through a cube, the files of the steps, and what is refused.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program/fixture.hpp"
#include "program/meshes.hpp"
#include "taut/taut.hpp"

namespace taut::test {
namespace {

using nlohmann::json;

constexpr int hole = 7;

/// The least and the greatest x of the hole.
std::pair<double, double> reach_of_hole(const Mesh& mesh) {
  std::pair reach = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.triangle_refs[t] != hole) continue;
    for (const Index v : mesh.triangles[t]) {
      reach.first = std::min(reach.first, mesh.points[v][0]);
      reach.second = std::max(reach.second, mesh.points[v][0]);
    }
  }
  return reach;
}

class Move : public ProgramTest {
protected:
  Move() {
    write_mesh("room.meshb", room(6));
    write("shift.json", R"({"bodies": [{"references": [7], "translation": [0.03, 0, 0]}], "fixed": [1]})");
    write("turn.json", R"({"bodies": [{"references": [7], "rotation":
                           {"centre": [0.5, 0.5, 0.5], "axis": [0, 0, 1], "degrees": 15}}]})");
  }

  static Words move(const std::string& motion, int steps, const Words& more = {},
                    const std::string& out = "o-%04d.meshb") {
    Words words = {"move", "room.meshb", "--motion", motion, "--steps", std::to_string(steps), "-o", out};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  static Mesh sound_mesh(const std::string& file) {
    Mesh mesh = read_mesh(file);
    EXPECT_EQ(defects(mesh), std::vector<std::string>{}) << file;
    return mesh;
  }

  static void write_displacements(double x) {
    Field field{.kind = Field::Kind::vector, .values = {}};
    for (std::size_t i = 0; i < room(6).points.size(); ++i)
      for (const double component : {x, 0.0, 0.0}) field.values.push_back(component);
    write_solution("d.solb", {field});
    write("d.json", R"({"bodies": [{"references": [7], "displacements": "d.solb"}], "sliding": [2]})");
  }

  static json report() { return json::parse(read("r.json")); }
};

TEST_F(Move, TranslatesABody) {
  const Outcome outcome = expect_done(move("shift.json", 4, {"--report", "r.json"}));
  EXPECT_NE(outcome.out.find("4 steps"), std::string::npos) << outcome.out;
  EXPECT_EQ(read_mesh("o-0000.meshb").points, room(6).points);
  for (int step = 0; step <= 4; ++step) {
    const auto [least, greatest] = reach_of_hole(sound_mesh("o-000" + std::to_string(step) + ".meshb"));
    EXPECT_NEAR(least, 1.0 / 3 + 0.03 * step, 1e-12);
    EXPECT_NEAR(greatest, 2.0 / 3 + 0.03 * step, 1e-12);
  }
}

TEST_F(Move, ReportsEachStep) {
  expect_done(move("shift.json", 3, {"--report", "r.json", "--quiet", "--every", "2"}));
  const json found = report();
  EXPECT_EQ(found["options"]["mode"], "all");
  EXPECT_EQ(found["ended"], nullptr);
  ASSERT_EQ(found["steps"].size(), 4U);
  for (int n = 0; n <= 3; ++n) {
    const json& step = found["steps"][static_cast<std::size_t>(n)];
    EXPECT_EQ(step["step"], n);
    EXPECT_EQ(step["share"], 1);
    EXPECT_EQ(step["parts"] > 0, n > 0);
    EXPECT_EQ(step["off_surface"], 0);
    EXPECT_EQ(step["iterations"] > 0, n > 0);
    for (const char* measure : {"tau", "Q_max", "Q_up_to_3", "unit_edges"}) EXPECT_GT(step[measure], 0) << measure;
    EXPECT_EQ(step["seconds"].contains("solve"), n > 0);
    const std::string file = "o-000" + std::to_string(n) + ".meshb";
    EXPECT_EQ(std::filesystem::exists(file), n != 1) << file;  // the last one always
    EXPECT_EQ(step["file"], n == 1 ? json() : json(file));
    if (n == 1) continue;
    EXPECT_EQ(step["vertices"], read_mesh(file).points.size());
    EXPECT_EQ(step["tetrahedra"], read_mesh(file).tetrahedra.size());
  }
  EXPECT_EQ(found["totals"]["steps"], 3);
  EXPECT_GT(found["totals"]["seconds"]["all"], 0);
}

TEST_F(Move, TurnsABodyAndCarriesFields) {
  const Mesh start = room(6);
  write("u.sol", metric_text(Sizes(start.points.size(), 3)));
  expect_done(move("turn.json", 6,
                   {"--follow", "share", "--mode", "flips", "--fields", "u.sol", "--fields-out", "u-%04d.solb",
                    "--metric-out", "m-%04d.solb", "--size", "0.17", "--metric-follows", "7"}));
  const Mesh last = sound_mesh("o-0006.meshb");
  EXPECT_NEAR(reach_of_hole(sound_mesh("o-0003.meshb")).second, 0.5 + std::sqrt(2) / 6, 1e-12);
  EXPECT_NEAR(reach_of_hole(last).second, 2.0 / 3, 1e-12);  // a quarter turn
  EXPECT_EQ(last.points.size(), start.points.size());
  const std::vector<Field> fields = read_solution("u-0006.solb");
  ASSERT_EQ(fields.size(), 1U);
  ASSERT_EQ(fields[0].values.size(), last.points.size());
  for (const double value : fields[0].values) EXPECT_NEAR(value, 3, 1e-9);
  EXPECT_EQ(read_solution("m-0006.solb")[0].values.size(), 6 * last.points.size());
}

TEST_F(Move, ListsFilesForParaView) {
  write("u.sol", metric_text(Sizes(room(6).points.size(), 3)));
  expect_done(move("turn.json", 2, {"--fields", "u.sol"}, "run-%03d.vtu"));
  for (const char* name : {"run-000.vtu", "run-001.vtu", "run-002.vtu"}) {
    EXPECT_NE(read(name).find("field 1"), std::string::npos);
    EXPECT_NE(read("run.pvd").find("file=\"" + std::string(name) + "\""), std::string::npos) << read("run.pvd");
  }
  std::filesystem::create_directory("sub");
  expect_done(move("turn.json", 1, {"--pvd", "sub/all.pvd"}, "next-%03d.vtu"));
  EXPECT_NE(read("sub/all.pvd").find("file=\"../next-001.vtu\""), std::string::npos) << read("sub/all.pvd");
  expect_error(move("turn.json", 1, {"--pvd", "a.pvd"}), 2, {"--pvd", "o-%04d.meshb", ".vtu"});
}

TEST_F(Move, FollowsDisplacements) {
  write_displacements(0.03);
  for (const char* mode : {"move", "flips"}) {
    expect_done(move("d.json", 3, {"--mode", mode}));
    const Mesh last = sound_mesh("o-0003.meshb");
    EXPECT_EQ(last.points.size(), room(6).points.size());
    EXPECT_NEAR(reach_of_hole(last).second, 2.0 / 3 + 0.09, 1e-12);
  }
  EXPECT_EQ(read_mesh("o-0000.meshb").points.size(), room(6).points.size());
}

TEST_F(Move, DisplacementsNeedVerticesThatStay) {
  write_displacements(0.03);
  expect_error(move("d.json", 3), 2, {"d.json", "--mode all", "--mode move or flips"});
  expect_error(move("d.json", 3, {"--mode", "flips", "--follow", "share"}), 2, {"d.json", "--follow elastic"});
  write("d.json", R"({"bodies": [{"references": [7], "displacements": "d.solb"},
                                 {"references": [2], "translation": [0, 0, -0.1]}]})");
  expect_error(move("d.json", 3, {"--mode", "flips"}), 2, {"d.json: bodies[1]", "displacements expected"});
  write("d.json", R"({"bodies": [{"references": [7], "displacements": "u.sol"}]})");
  write("u.sol", metric_text(Sizes(room(6).points.size(), 3)));
  expect_error(move("d.json", 3, {"--mode", "flips"}), 2, {"u.sol: expected one vector per vertex"});
  write("u.sol", metric_text(Sizes(5, 3)));
  expect_error(move("d.json", 3, {"--mode", "flips"}), 2, {"u.sol", "5 vertices"});
}

TEST_F(Move, ABodyIsStoppedAtAWall) {
  write("far.json", R"({"bodies": [{"references": [7], "translation": [0.15, 0, 0]}]})");
  const Outcome outcome = run(move("far.json", 5, {"--report", "r.json"}));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(outcome.err.starts_with("taut: error: step 3: ")) << outcome.err;
  EXPECT_NE(outcome.err.find("the triangles of reference 7 meet those of reference 1 near ("), std::string::npos)
      << outcome.err;
  EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
  EXPECT_NE(outcome.err.find("o-0003.meshb holds the last valid mesh"), std::string::npos) << outcome.err;
  EXPECT_NEAR(reach_of_hole(sound_mesh("o-0002.meshb")).second, 2.0 / 3 + 0.3, 1e-12);
  EXPECT_GE(reach_of_hole(sound_mesh("o-0003.meshb")).second, 2.0 / 3 + 0.3 - 1e-12);
  EXPECT_FALSE(std::filesystem::exists("o-0004.meshb"));
  const json found = report();
  ASSERT_EQ(found["steps"].size(), 4U);
  EXPECT_LT(found["steps"][3]["share"], 1);
  const json& obstacle = found["steps"][3]["obstacle"];
  EXPECT_EQ(obstacle["reason"], "contact");
  EXPECT_EQ(obstacle["body"], 7);
  EXPECT_GT(obstacle["gap"], 0);
  EXPECT_LT(obstacle["gap"], obstacle["size"]);
  EXPECT_EQ(obstacle["place"].size(), 3U);
  EXPECT_TRUE(found["steps"][2]["obstacle"].is_null());
  EXPECT_TRUE(found["ended"].get<std::string>().starts_with("step 3: "));
}

TEST_F(Move, GivesTheSameFilesOnAnyNumberOfThreads) {
  expect_done(move("turn.json", 3, {"--threads", "1", "--metric-out", "m1-%04d.solb"}, "one-%04d.meshb"));
  expect_done(move("turn.json", 3, {"--threads", "3", "--metric-out", "m3-%04d.solb"}, "three-%04d.meshb"));
  for (const char* step : {"0000.meshb", "0001.meshb", "0002.meshb", "0003.meshb"})
    EXPECT_TRUE(read(std::string("one-") + step) == read(std::string("three-") + step)) << step;
  EXPECT_TRUE(read("m1-0003.solb") == read("m3-0003.solb"));
}

TEST_F(Move, NamesReferencesThatNoTriangleHas) {
  write("m.json", R"({"bodies": [{"references": [7, 9], "translation": [0, 0, 0]}]})");
  expect_error(move("m.json", 1), 2, {"m.json: bodies[0].references[1]: reference 9 found", "room.meshb"});
  write("m.json", R"({"bodies": [{"references": [7], "translation": [0, 0, 0]}], "fixed": [1, 3]})");
  expect_error(move("m.json", 1), 2, {"m.json: fixed[1]: reference 3 found"});
  write("m.json", R"({"bodies": [{"references": [7], "translation": [0, 0, 0]}], "sliding": [5]})");
  expect_error(move("m.json", 1), 2, {"m.json: sliding[0]: reference 5 found"});
  expect_error(move("shift.json", 1, {"--metric-follows", "1"}), 2, {"--metric-follows", "1", "shift.json"});
}

TEST_F(Move, RefusesMotionFilesThatAreWrong) {
  write("m.json", R"({"bodies": [{"references": [7], "shift": [0, 0, 0]}]})");
  expect_error(move("m.json", 1), 2, {"m.json: bodies[0]: unknown key \"shift\""});
  expect_error(move("none.json", 1), 2, {"none.json: cannot be read"});
}

TEST_F(Move, StopsAtMotionsThatAreTooLong) {
  write("m.json", R"({"bodies": [{"references": [7], "translation": [1e308, 0, 0]}]})");
  const Outcome outcome = run(move("m.json", 3));
  EXPECT_EQ(outcome.status, 2);
  EXPECT_TRUE(outcome.err.starts_with("taut: error: m.json: that of the reference 7 is not finite or above 1e+100"))
      << outcome.err;
  write("m.json", R"({"bodies": [{"references": [7], "translation": [1e99, 0, 0]}]})");
  EXPECT_EQ(run(move("m.json", 3)).status, 1);
  EXPECT_EQ(sound_mesh("o-0001.meshb").points, room(6).points);
}

TEST_F(Move, RefusesNamesThatDoNotFit) {
  expect_error(move("shift.json", 1, {}, "o.meshb"), 2, {"o.meshb", "out-%04d.meshb"});
  expect_error(move("shift.json", 1, {}, "o-%04d.stl"), 2, {"o-0000.stl", ".meshb"});
  expect_error(move("shift.json", 1, {"--metric-out", "m.solb"}), 2, {"m.solb", "%04d"});
  expect_error(move("shift.json", 1, {"--metric-out", "none/m-%04d.solb"}), 2, {"none/m-0000.solb"});
  expect_error(move("shift.json", 1, {"--report", "shift.json"}), 2, {"shift.json", "motion", "report"});
  std::filesystem::copy("room.meshb", "o-0002.meshb");
  Words words = move("shift.json", 2);
  words[1] = "./o-0002.meshb";
  expect_error(words, 2, {"o-0002.meshb", "input mesh", "meshes"});
  write("u.sol", metric_text(Sizes(room(6).points.size(), 3)));
  expect_error(
      move("shift.json", 1, {"--fields", "u.sol", "--fields-out", "a-%04d.sol", "--metric-out", "./a-%04d.sol"}), 2,
      {"a-0000.sol", "fields", "metric"});
}

TEST_F(Move, NamesTheMetricThatDoesNotFit) {
  write("m.sol", "nothing");
  expect_error(move("shift.json", 1, {"--metric", "m.sol"}), 2, {"error: m.sol: "});
  write("m.sol", metric_text(Sizes(5, 3)));
  expect_error(move("shift.json", 1, {"--metric", "m.sol"}), 2, {"error: m.sol: 5 values"});
}

TEST_F(Move, RefusesOptionsThatContradict) {
  expect_error(move("shift.json", 1, {"--size", "0.1", "--metric", "m.solb"}), 2, {"--metric and --size"});
  expect_error(move("shift.json", 1, {"--fields-out", "f-%04d.sol"}), 2, {"--fields-out", "--fields"});
  expect_error(move("shift.json", 1, {"--fields", "u.sol"}), 2, {"--fields-out"});
  expect_error(move("shift.json", 1, {"--fields"}), 2, {"--fields: expected a value"});
  expect_error(move("shift.json", 1, {"--mode", "swap"}), 2, {"--mode", "swap found, expected move, flips or all"});
  expect_error(move("shift.json", 0), 2, {"--steps", "1 or more"});
  expect_error(move("shift.json", 1, {"--every", "0"}), 2, {"--every", "1 or more"});
  expect_error(move("shift.json", 1, {"--stiffening", "-1"}), 2, {"--stiffening", "0 or more"});
}

}  // namespace
}  // namespace taut::test
