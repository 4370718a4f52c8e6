// Runs that succeed: the files written, the tables, the reports.
#include <nlohmann/json.hpp>
#include <set>

#include "program/fixture.hpp"
#include "program/meshes.hpp"
#include "taut/taut.hpp"

namespace taut::test {
namespace {

using nlohmann::json;

bool contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

class GoodRun : public ProgramTest {
protected:
  GoodRun() { write("cube.mesh", mesh_text(cube(2))); }

  json quality(const Words& words) {
    Words all = {"quality", "--json"};
    all.insert(all.end(), words.begin(), words.end());
    return json::parse(expect_done(all).out);
  }
};

TEST_F(GoodRun, OneSizeEverywhere) {
  const std::string table = expect_done({"adapt", "cube.mesh", "--size", "0.25", "-o", "out.mesh"}).out;
  for (const char* part : {"tau", "unit edges", "edges by length", "tetrahedra by Q", "insert", "relocate", "write"})
    EXPECT_TRUE(contains(table, part)) << part;
  expect_done({"quality", "out.mesh", "--check"});
  EXPECT_NEAR(quality({"out.mesh"})["quality"]["volume"].get<double>(), 1, 1e-12);
}

TEST_F(GoodRun, TextAndBinaryHoldTheSame) {
  expect_done({"adapt", "cube.mesh", "--size", "0.3", "-o", "out.mesh"});
  expect_done({"adapt", "cube.mesh", "--size", "0.3", "-o", "out.meshb"});
  const Mesh text = read_mesh("out.mesh"), binary = read_mesh("out.meshb");
  EXPECT_EQ(text.points, binary.points);
  EXPECT_EQ(text.tetrahedra, binary.tetrahedra);
  EXPECT_EQ(text.triangles, binary.triangles);
}

TEST_F(GoodRun, ForParaView) {
  write("u.sol", metric_text(Sizes(27, 1)));
  expect_done({"adapt", "cube.mesh", "--size", "0.3", "-o", "out.vtu"});
  EXPECT_TRUE(contains(read("out.vtu"), "Name=\"metric\" NumberOfComponents=\"9\""));
  expect_done({"adapt", "cube.mesh", "--field", "u.sol", "--complexity", "50", "--hmax", "0.5", "-o", "out.vtu"});
  EXPECT_TRUE(contains(read("out.vtu"), "Name=\"field 1\" NumberOfComponents=\"1\""));
  EXPECT_EQ(read_solution("out.sol").size(), 1U);
}

TEST_F(GoodRun, TensorsAndAllOutputs) {
  write("m.sol", metric_text(Tensors(27, {100, 0, 0, 16, 0, 16})));
  expect_done({"adapt",           "cube.mesh", "--metric", "m.sol",    "-o",          "out.meshb",
               "--metric-out",    "out.solb",  "--report", "out.json", "--gradation", "1.5",
               "--gradation-mix", "0.25",      "--hmin",   "0.01",     "--hmax",      "1",
               "--surface",       "adapt"});
  const json report = json::parse(read("out.json"));
  const json measured = quality({"out.meshb", "--metric", "out.solb", "--check"});
  EXPECT_EQ(report["quality"], measured["quality"]);
  EXPECT_EQ(report["hash"].get<std::string>().size(), 16U);
  EXPECT_EQ(report["options"]["gradation"], 1.5);
  EXPECT_EQ(report["options"]["gradation_mix"], 0.25);
  EXPECT_EQ(report["cancelled"], false);
  EXPECT_GT(report["passes"][0]["accepted"], 0);
  EXPECT_NEAR(report["quality"]["complexity"].get<double>(), 160, 1e-6);
  EXPECT_TRUE(report["seconds"].contains("read") && report["seconds"].contains("write"));
}

TEST_F(GoodRun, ThreadsLeaveTheFilesAsTheyAre) {
  write("m.sol", metric_text(Tensors(27, {1600, 0, 0, 100, 0, 100})));
  std::set<std::string> meshes, metrics, hashes;
  for (const char* threads : {"1", "2", "3", "5", "8"}) {
    expect_done({"adapt", "cube.mesh", "--metric", "m.sol", "-o", "out.meshb", "--metric-out", "out.solb", "--report",
                 "out.json", "--threads", threads, "--block-size", "300"});
    meshes.insert(read("out.meshb"));
    metrics.insert(read("out.solb"));
    const json report = json::parse(read("out.json"));
    hashes.insert(report["hash"].get<std::string>());
    EXPECT_EQ(std::to_string(report["threads"].get<int>()), threads);
    EXPECT_GT(report["blocks"], 5);
    EXPECT_GT(report["passes"][0]["put_off"], 0);
  }
  EXPECT_EQ(meshes.size(), 1U);
  EXPECT_EQ(metrics.size(), 1U);
  EXPECT_EQ(hashes.size(), 1U);
  EXPECT_EQ(expect_done({"quality", "out.meshb", "--threads", "1"}).out,
            expect_done({"quality", "out.meshb", "--threads", "3"}).out);
}

TEST_F(GoodRun, HistogramsCountEverything) {
  write("m.sol", metric_text(Sizes(27, 0.5)));
  const json measured = quality({"cube.mesh", "--metric", "m.sol"})["quality"];
  const auto sum = [](const json& histogram) {
    std::size_t all = 0;
    for (const json& bin : histogram) all += bin["count"].get<std::size_t>();
    return all;
  };
  EXPECT_EQ(sum(measured["length_histogram"]), measured["edges"]);
  EXPECT_EQ(sum(measured["Q_histogram"]), measured["tetrahedra"]);
  for (const char* open : {"length_histogram", "Q_histogram"}) EXPECT_TRUE(measured[open].back()["to"].is_null());
  EXPECT_TRUE(contains(expect_done({"quality", "cube.mesh", "--metric", "m.sol"}).out, "  above 5 "));
}

TEST_F(GoodRun, RoundsAreAtMostThoseAskedFor) {
  for (const char* option : {"--rounds", "--passes"}) {
    expect_done({"adapt", "cube.mesh", "--size", "0.1", "-o", "out.mesh", "--report", "out.json", option, "2"});
    const json report = json::parse(read("out.json"));
    EXPECT_EQ(report["rounds"], 2) << option;
    EXPECT_EQ(report["options"]["rounds"], 2) << option;
  }
}

TEST_F(GoodRun, FixedSurfaceKeepsTheTriangles) {
  expect_done({"adapt", "cube.mesh", "--size", "0.2", "--surface", "fixed", "-o", "out.mesh"});
  EXPECT_EQ(read_mesh("out.mesh").triangles.size(), 48U);
}

TEST_F(GoodRun, QuietPrintsNothing) {
  write("inverted.mesh", two_tets);
  EXPECT_EQ(expect_done({"adapt", "inverted.mesh", "--size", "0.5", "-o", "out.mesh", "--quiet"}).out, "");
}

TEST_F(GoodRun, InputMayBeOverwritten) {
  const std::string before = read("cube.mesh");
  expect_done({"adapt", "cube.mesh", "--size", "0.4", "-o", "cube.mesh"});
  EXPECT_NE(read("cube.mesh"), before);
  EXPECT_EQ(snapshot().size(), 1U);
  expect_done({"quality", "cube.mesh", "--check"});
}

TEST_F(GoodRun, NothingIsPickedUpThatWasNotNamed) {
  expect_done({"adapt", "cube.mesh", "--size", "0.4", "-o", "alone.mesh"});
  write("cube.sol", "no solution");
  expect_done({"adapt", "cube.mesh", "--size", "0.4", "-o", "beside.mesh"});
  EXPECT_EQ(read("alone.mesh"), read("beside.mesh"));
}

TEST_F(GoodRun, NotesOnMendedInput) {
  write("mended.mesh", changed(two_tets, "1 2 3 4 0", "2 1 3 4 0"));
  const Outcome outcome = run({"adapt", "mended.mesh", "--size", "0.5", "-o", "out.mesh"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_TRUE(contains(outcome.err, "mended.mesh: 1 inverted")) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "mended.mesh: 6 missing triangles")) << outcome.err;
  expect_done({"quality", "out.mesh", "--check"});
}

TEST_F(GoodRun, NoteOnCurvedPatches) {
  Mesh bulged = cube(2);
  for (Point& p : bulged.points)
    if (p == Point{0.5, 0.5, 1}) p[2] = 1.1;
  write("bulged.mesh", mesh_text(bulged));
  const Outcome outcome = run({"adapt", "bulged.mesh", "--surface", "planar", "--size", "0.3", "-o", "out.mesh"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_TRUE(contains(outcome.err, "bulged.mesh: 8 triangles")) << outcome.err;
}

TEST_F(GoodRun, CheckFindsDefects) {
  write("bare.mesh", two_tets);
  EXPECT_EQ(run({"quality", "bare.mesh"}).status, 0);
  const Outcome checked = run({"quality", "bare.mesh", "--check"});
  EXPECT_EQ(checked.status, 1);
  EXPECT_TRUE(contains(checked.out, "defects found"));
  EXPECT_TRUE(contains(checked.err, "taut: error: bare.mesh: ")) << checked.err;
  EXPECT_FALSE(quality({"bare.mesh"})["defects"].empty());
}

}  // namespace
}  // namespace taut::test
