// taut levelset extract: the surface, its measures, the comparison, and what is refused.
#include <cmath>
#include <nlohmann/json.hpp>
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

/// A cube and the distance from its middle.
class Levelset : public ProgramTest {
protected:
  Levelset() {
    const Mesh mesh = cube(8);
    write("cube.mesh", mesh_text(mesh));
    Sizes distances;
    for (const auto& [x, y, z] : mesh.points) distances.push_back(std::hypot(x - 0.5, y - 0.5, z - 0.5));
    write("u.sol", metric_text(distances));
  }

  Words extract(const Words& more) const {
    Words words = {"levelset", "extract", "cube.mesh", "u.sol"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
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
