// taut levelset: the surface, its measures, the comparison, vertices placed on it, and what is refused.
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

#include "program/fixture.hpp"
#include "program/meshes.hpp"
#include "taut/taut.hpp"

namespace taut::test {
namespace {

using nlohmann::json;

bool has(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

/// A cube, the distance from its middle, and the square of it, which the quadratic fits of `place` recover.
class Levelset : public ProgramTest {
protected:
  Levelset() {
    const Mesh mesh = cube(8);
    write("cube.mesh", mesh_text(mesh));
    Sizes distances;
    for (const auto& [x, y, z] : mesh.points) distances.push_back(std::hypot(x - 0.5, y - 0.5, z - 0.5));
    write("u.sol", metric_text(distances));
    Sizes squares;
    for (const double distance : distances) squares.push_back(distance * distance);
    write("squares.sol", metric_text(squares));
  }

  Words extract(const Words& more) const {
    Words words = {"levelset", "extract", "cube.mesh", "u.sol"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  static Words place(const Words& more) {
    Words words = {"levelset", "place", "cube.mesh", "squares.sol", "-o", "p.meshb", "--level", "0.09"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  static json report() { return json::parse(read("r.json")); }
};

TEST_F(Levelset, ExtractsAClosedSurface) {
  const std::string text = expect_done(extract({"-o", "s.mesh", "--level", "0.3", "--report", "s.json"})).out;
  EXPECT_TRUE(has(text, "triangles ") && has(text, "area ") && has(text, " enclosed")) << text;
  const SurfaceMesh surface = read_surface("s.mesh");
  const SurfaceMeasures m = measure(surface);
  const json report = json::parse(read("s.json"));
  EXPECT_EQ(report["level"], 0.3);
  EXPECT_EQ(report["surface"]["triangles"], surface.triangles.size());
  EXPECT_EQ(report["surface"]["points"], surface.points.size());
  EXPECT_EQ(report["surface"]["open_edges"], 0);
  EXPECT_NEAR(report["surface"]["volume"].get<double>(), m.volume, 1e-14);
  EXPECT_NEAR(m.volume, 0.113, 0.01);
  EXPECT_TRUE(report["compare"].is_null());
  EXPECT_FALSE(report.contains("distance"));
}

TEST_F(Levelset, SaysThatASurfaceIsOpen) {
  const std::string text = expect_done(extract({"-o", "s.meshb", "--level", "0.6", "--report", "s.json"})).out;
  EXPECT_TRUE(has(text, "open edges")) << text;
  EXPECT_TRUE(json::parse(read("s.json"))["surface"]["volume"].is_null());
}

TEST_F(Levelset, ComparesWithAnotherSurface) {
  expect_done(extract({"-o", "small.meshb", "--level", "0.2", "--quiet"}));
  const std::string text =
      expect_done(extract({"-o", "s.mesh", "--level", "0.3", "--compare", "small.meshb", "--report", "s.json"})).out;
  EXPECT_TRUE(has(text, "distance to small.meshb") && has(text, "both ways")) << text;
  const json d = json::parse(read("s.json"))["distance"];
  for (const char* way : {"to_other", "from_other"}) {
    EXPECT_NEAR(d[way]["mean"].get<double>(), 0.1, 0.01);
    EXPECT_GT(d[way]["samples"], 1000);
  }
  EXPECT_GT(d["worst"].get<double>(), 0.1);
  expect_done(extract({"-o", "s.mesh", "--level", "0.3", "--compare", "s.mesh", "--report", "s.json"}));
  EXPECT_NEAR(json::parse(read("s.json"))["distance"]["worst"].get<double>(), 0, 1e-14);
}

TEST_F(Levelset, QuietPrintsNothing) {
  EXPECT_EQ(expect_done(extract({"-o", "s.mesh", "--level", "0.3", "--quiet"})).out, "");
}

TEST_F(Levelset, ThreadsLeaveTheFilesAsTheyAre) {
  std::set<std::string> surfaces, reports;
  for (const char* threads : {"1", "2", "3"}) {
    expect_done(extract(
        {"-o", "s.meshb", "--level", "0.3", "--compare", "cube.mesh", "--report", "s.json", "--threads", threads}));
    surfaces.insert(read("s.meshb"));
    reports.insert(read("s.json"));
  }
  EXPECT_EQ(surfaces.size(), 1U);
  EXPECT_EQ(reports.size(), 1U);
}

TEST_F(Levelset, RefusesFilesThatDoNotFit) {
  write("few.sol", metric_text(Sizes{1, 2, 3}));
  expect_error({"levelset", "extract", "cube.mesh", "few.sol", "-o", "s.mesh"}, 2,
               {"few.sol: values for 3 vertices found", "expected 729"});
  write("tensors.sol", metric_text(Tensors(729, {1, 0, 0, 1, 0, 1})));
  expect_error({"levelset", "extract", "cube.mesh", "tensors.sol", "-o", "s.mesh"}, 2,
               {"tensors.sol: 6 numbers per vertex", "expected one"});
  expect_error({"levelset", "extract", "no.mesh", "u.sol", "-o", "s.mesh"}, 2, {"no.mesh: "});
  write("bare.mesh", two_tets);
  expect_error(extract({"-o", "s.mesh", "--level", "0.3", "--compare", "bare.mesh"}), 2, {"bare.mesh: ", "Triangles"});
}

TEST_F(Levelset, RefusesALevelThatTheFieldDoesNotTake) {
  expect_error(extract({"-o", "s.mesh", "--level", "2"}), 2, {"u.sol: no surface at the level 2", "from 0 to 0.86"});
  expect_error(extract({"-o", "s.mesh"}), 2, {"u.sol: no surface at the level 0 "});
}

TEST_F(Levelset, ChecksTheOutputsFirst) {
  const Words no_input = {"levelset", "extract", "no.mesh", "no.sol"};
  const auto refused = [&](const Words& more, const std::string& file) {
    Words words = no_input;
    words.insert(words.end(), more.begin(), more.end());
    expect_error(words, 2, {"taut: error: " + file + ": "});
  };
  refused({"-o", "out.vtk"}, "out.vtk");
  refused({"-o", "no/out.mesh"}, "no/out.mesh");
  refused({"-o", "out.mesh", "--report", "report"}, "report");
}

TEST_F(Levelset, PlacesVerticesOnTheSurface) {
  const std::string text =
      expect_done(place({"--values-out", "v.solb", "--metric-out", "m.solb", "--report", "r.json"})).out;
  EXPECT_TRUE(has(text, "cube.mesh -> p.meshb: ") && has(text, " vertices moved, ")) << text;
  const Mesh mesh = read_mesh("p.meshb");
  const std::vector<Field> values = read_solution("v.solb");
  ASSERT_EQ(values.size(), 1U);
  ASSERT_EQ(values[0].values.size(), mesh.points.size());
  std::size_t on_surface = 0;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const auto& [x, y, z] = mesh.points[v];
    const double distance = std::hypot(x - 0.5, y - 0.5, z - 0.5);
    EXPECT_NEAR(values[0].values[v], distance * distance - 0.09, 1e-9);
    on_surface += values[0].values[v] == 0 ? 1 : 0;
  }
  const json r = report();
  EXPECT_EQ(r["on_surface"], on_surface);
  EXPECT_GT(r["moved"], 50);
  EXPECT_EQ(r["crossed"], 0);
  EXPECT_EQ(r["quality"]["vertices"], mesh.points.size());
  EXPECT_EQ(std::get<Tensors>(read_metric("m.solb")).size(), mesh.points.size());
  expect_done({"quality", "p.meshb", "--check"});
}

TEST_F(Levelset, PlaceReportsWhatItWasAskedFor) {
  write("sizes.sol", metric_text(Sizes(729, 0.125)));
  expect_done(place({"--metric", "sizes.sol", "--surface", "fixed", "--angle", "30", "--q-max", "15", "--deviation",
                     "0.002", "--report", "r.json"}));
  const json r = report();
  EXPECT_EQ(r["options"], (json{{"deviation", 0.002}, {"q_max", 15}, {"surface", "fixed"}, {"angle", 30}}));
  EXPECT_EQ(r["metric"], "sizes.sol");
  EXPECT_EQ(r["level"], 0.09);
  EXPECT_TRUE(r["values_out"].is_null());
  EXPECT_GT(r["inserted"], 50);
}

/// The part of the volume that the surface encloses approaches that of the ball as the deviation falls.
TEST_F(Levelset, PlaceInsertsWhereTheSurfaceDeviates) {
  const auto missing = [&](const Words& more) {
    expect_done(place(more));
    expect_done({"levelset", "extract", "p.meshb", "v.solb", "-o", "s.meshb", "--report", "r.json", "--quiet"});
    return 4.0 / 3 * std::numbers::pi * 0.027 - report()["surface"]["volume"].get<double>();
  };
  const double without = missing({"--values-out", "v.solb"});
  EXPECT_LT(missing({"--values-out", "v.solb", "--deviation", "0.002"}), 0.5 * without);
}

TEST_F(Levelset, PlaceMayOverwriteItsInput) {
  expect_done({"levelset", "place", "cube.mesh", "u.sol", "--level", "0.3", "-o", "cube.mesh", "--quiet"});
  EXPECT_NE(read("cube.mesh"), mesh_text(cube(8)));
  EXPECT_EQ(expect_done(place({"--quiet"})).out, "");
}

TEST_F(Levelset, PlaceWritesTheSameFilesOnAnyNumberOfThreads) {
  std::set<std::string> files;
  for (const char* threads : {"1", "2", "3"}) {
    expect_done(place({"--values-out", "v.solb", "--report", "r.json", "--deviation", "0.005", "--threads", threads}));
    files.insert(read("p.meshb") + read("v.solb") + read("r.json"));
  }
  EXPECT_EQ(files.size(), 1U);
}

TEST_F(Levelset, PlaceRefusesFilesThatDoNotFit) {
  const auto refused = [&](const std::string& mesh, const std::string& field, const Words& more,
                           const std::vector<std::string>& parts) {
    Words words = {"levelset", "place", mesh, field, "-o", "p.mesh", "--level", "0.3"};
    words.insert(words.end(), more.begin(), more.end());
    expect_error(words, 2, parts);
  };
  write("few.sol", metric_text(Sizes{1, 2, 3}));
  write("tensors.sol", metric_text(Tensors(729, {1, 0, 0, 1, 0, 1})));
  write("zeros.sol", metric_text(Sizes(729, 0.0)));
  write("flat.mesh", changed(two_tets, "0 0 1 0", "0.25 0.25 0 0"));
  write("five.sol", metric_text(Sizes{1, 2, 3, 4, -5}));
  refused("cube.mesh", "few.sol", {}, {"few.sol: values for 3 vertices found", "expected 729"});
  refused("cube.mesh", "tensors.sol", {}, {"tensors.sol: 6 numbers per vertex", "expected one"});
  refused("no.mesh", "u.sol", {}, {"no.mesh: "});
  refused("flat.mesh", "five.sol", {}, {"flat.mesh: tetrahedron 1"});
  refused("cube.mesh", "u.sol", {"--metric", "few.sol"}, {"few.sol: 3 values for 729 vertices"});
  refused("cube.mesh", "u.sol", {"--metric", "zeros.sol"}, {"zeros.sol: vertex 1: size 0 found"});
  refused("cube.mesh", "u.sol", {"--metric", "no.sol"}, {"no.sol: "});
  refused("cube.mesh", "zeros.sol", {}, {"zeros.sol: no surface at the level 0.3 found", "from 0 to 0"});
}

TEST_F(Levelset, PlaceChecksTheOutputsFirst) {
  const auto refused = [&](const Words& more, const std::string& start) {
    Words words = {"levelset", "place", "no.mesh", "no.sol"};
    words.insert(words.end(), more.begin(), more.end());
    expect_error(words, 2, {"taut: error: " + start});
  };
  refused({"-o", "out.vtk"}, "out.vtk: ");
  refused({"-o", "no/out.mesh"}, "no/out.mesh: ");
  refused({"-o", "out.mesh", "--report", "report"}, "report: ");
  refused({"-o", "out.mesh", "--values-out", "v.txt"}, "v.txt: ");
  refused({"-o", "out.mesh", "--metric-out", "m.mesh"}, "m.mesh: ");
  refused({"-o", "out.mesh", "--metric-out", "a.sol", "--values-out", "./a.sol"}, "./a.sol: found as the file for ");
}

TEST_F(Levelset, PlaceUsage) {
  const std::string help = expect_done({"levelset", "place", "--help"}).out;
  EXPECT_TRUE(has(help, "  taut levelset place ") && has(help, "--report") && has(help, "--angle")) << help;
  expect_error({"levelset", "place"}, 2, {"IN", "taut levelset place --help"});
  expect_error({"levelset", "place", "cube.mesh", "u.sol"}, 2, {"--output", "taut levelset place --help"});
  const auto refused = [&](const char* option, const char* word, const std::string& expected) {
    expect_error(place({option, word}), 2, {option, word + std::string(" found, expected ") + expected});
  };
  refused("--deviation", "0", "a number above 0");
  refused("--q-max", "1", "a number above 1");
  refused("--q-max", "inf", "a number above 1");
  refused("--surface", "move", "adapt, planar or fixed");
  refused("--angle", "180", "degrees between 0 and 180");
  expect_error({"levelset", "place", "cube.mesh", "u.sol", "-o", "p.mesh", "--level", "nan"}, 2,
               {"--level", "nan found, expected a number"});
}

TEST_F(Levelset, Usage) {
  EXPECT_TRUE(has(expect_done({"levelset", "extract", "--help"}).out, "  taut levelset extract "));
  EXPECT_TRUE(has(expect_done({"levelset", "--help"}).out, "extract"));
  expect_error({"levelset"}, 2, {"no command found, expected extract", "taut levelset --help"});
  expect_error({"levelset", "cut"}, 2, {"unknown word cut", "taut levelset --help"});
  expect_error({"levelset", "extract"}, 2, {"IN", "taut levelset extract --help"});
  expect_error(extract({"-o", "s.mesh", "--frob"}), 2, {"--frob", "taut levelset extract --help"});
  expect_error(extract({"-o", "s.mesh", "--level", "high"}), 2, {"--level", "high found, expected a number"});
  expect_error(extract({"-o", "s.mesh", "--spacing", "0"}), 2, {"--spacing", "above 0"});
  expect_error(extract({"-o", "s.mesh", "--divisions", "0"}), 2, {"--divisions", "1 to 1000"});
}

}  // namespace
}  // namespace taut::test
