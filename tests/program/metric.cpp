// taut metric: every kind runs, the complexity is the one that is asked for, and what is refused.
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "program/fixture.hpp"
#include "program/meshes.hpp"
#include "taut/taut.hpp"

namespace taut::test {
namespace {

using nlohmann::json;

bool says(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

class MetricRun : public ProgramTest {
protected:
  MetricRun() {
    write("cube.mesh", mesh_text(mesh_));
    Sizes front;
    Field vector{Field::Kind::vector, {}};
    for (const auto& [x, y, z] : mesh_.points) {
      front.push_back(std::tanh(10 * (x - 0.45)));
      vector.values.insert(vector.values.end(), {0, 0, std::sin(6 * y)});
    }
    write("u.sol", metric_text(front));
    write_solution("v.solb", {vector});
    write("sizes.sol", metric_text(Sizes(mesh_.points.size(), 0.2)));
    write("tensors.sol", metric_text(Tensors(mesh_.points.size(), {400, 0, 0, 1, 0, 1})));
  }

  static Words metric(const Words& more) {
    Words words = {"metric"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  void refused(const Words& more, const std::vector<std::string>& parts) { expect_error(metric(more), 2, parts); }

  double complexity_of(const std::string& file) {
    const std::string text = expect_done({"quality", "cube.mesh", "--metric", file, "--json"}).out;
    return json::parse(text)["quality"]["complexity"].get<double>();
  }

  const Mesh mesh_ = cube(6);
};

TEST_F(MetricRun, EveryKind) {
  const Words kinds[] = {
      {"lp", "cube.mesh", "u.sol", "v.solb", "--complexity", "500", "--recovery", "projection"},
      {"error", "cube.mesh", "u.sol", "v.solb", "--error", "0.05"},
      {"levelset", "cube.mesh", "u.sol", "--error", "0.05", "--level", "0.1", "--growth", "0.5", "--refinement", "4"},
      {"curvature", "cube.mesh", "--deviation", "0.01", "--relative", "--turn", "30", "--angle", "60"},
      {"implied", "cube.mesh"},
      {"size", "cube.mesh", "--size", "0.2"},
      {"size", "cube.mesh", "sizes.sol"},
      {"intersect", "cube.mesh", "sizes.sol", "tensors.sol"},
      {"gradate", "cube.mesh", "tensors.sol"},
  };
  for (Words words : kinds) {
    words.insert(words.end(), {"-o", "out.solb", "--hmin", "0.01", "--hmax", "1", "--gradation", "1.5"});
    EXPECT_TRUE(says(expect_done(metric(words)).out, "out.solb: complexity ")) << words[0];
    EXPECT_GT(complexity_of("out.solb"), 0) << words[0];
    words.emplace_back("--quiet");
    EXPECT_EQ(expect_done(metric(words)).out, "") << words[0];
  }
}

TEST_F(MetricRun, SizesAndIntersectionsAreExact) {
  expect_done(metric({"size", "cube.mesh", "--size", "0.2", "-o", "out.sol"}));
  EXPECT_NEAR(complexity_of("out.sol"), 125, 1e-9);
  expect_done(metric({"intersect", "cube.mesh", "sizes.sol", "tensors.sol", "-o", "out.sol"}));
  EXPECT_NEAR(complexity_of("out.sol"), 500, 1e-9);
  expect_done(metric({"gradate", "cube.mesh", "tensors.sol", "-o", "out.sol", "--anisotropy", "2"}));
  EXPECT_NEAR(complexity_of("out.sol"), 2000, 1e-6);
}

TEST_F(MetricRun, LpHasTheComplexity) {
  for (const char* norm : {"1", "2", "inf"})
    for (const char* field : {"u.sol", "v.solb"}) {
      expect_done(metric({"lp", "cube.mesh", field, "--complexity", "500", "--norm", norm, "--hmax", "0.5",
                          "--gradation", "1.5", "-o", "out.solb"}));
      EXPECT_NEAR(complexity_of("out.solb"), 500, 0.00201 * 500) << norm << " " << field;
    }
}

/// A bowl of radius 2 in the top of the cube; a plane has the size --hmax.
TEST_F(MetricRun, CurvatureIsThatOfTheSurface) {
  Mesh bowl = mesh_;
  for (auto& [x, y, z] : bowl.points) z *= 3 - std::sqrt(4 - (x - 0.5) * (x - 0.5) - (y - 0.5) * (y - 0.5));
  write("bowl.mesh", mesh_text(bowl));
  expect_done(metric({"curvature", "bowl.mesh", "--deviation", "0.001", "--hmax", "5", "-o", "out.sol"}));
  const Tensors tensors = std::get<Tensors>(read_metric("out.sol"));
  for (std::size_t v = 0; v < tensors.size(); ++v) {
    if (bowl.points[v] == Point{0.5, 0.5, 1}) {
      EXPECT_NEAR(1 / std::sqrt(tensors[v][0]), std::sqrt(0.008 * 2), 0.002);
    }
    if (bowl.points[v] == Point{0.5, 0.5, 0}) {
      EXPECT_NEAR(1 / std::sqrt(tensors[v][0]), 5, 1e-6);
    }
  }
}

/// Two components of the vector are zero.
TEST_F(MetricRun, ComponentsThatAreZeroDoNotCount) {
  write_solution("third.solb", {Field{Field::Kind::scalar, read_solution("v.solb")[0].component(2)}});
  for (const char* field : {"v.solb", "third.solb"})
    expect_done(metric({"lp", "cube.mesh", field, "--complexity", "50", "-o", std::string("m-") + field}));
  EXPECT_EQ(read("m-v.solb"), read("m-third.solb"));
}

TEST_F(MetricRun, HessiansAreThoseOfTheComponents) {
  expect_done(metric({"hessian", "cube.mesh", "u.sol", "v.solb", "-o", "h.solb"}));
  const std::vector<Field> fields = read_solution("h.solb");
  ASSERT_EQ(fields.size(), 4U);
  for (const Field& field : fields) EXPECT_EQ(field.kind, Field::Kind::tensor);
}

TEST_F(MetricRun, NotesWhatStopsIt) {
  const Outcome fine = run(metric({"lp", "cube.mesh", "u.sol", "--complexity", "1e5", "--hmin", "0.2", "-o", "o.sol"}));
  EXPECT_EQ(fine.status, 0);
  EXPECT_TRUE(fine.err.starts_with("taut: note: o.sol: complexity 12")) << fine.err;
  EXPECT_TRUE(says(fine.err, " instead of 1e+05, because of hmin\n")) << fine.err;
  const Outcome coarse = run(metric({"lp", "cube.mesh", "u.sol", "--complexity", "1", "--hmax", "0.5", "-o", "o.sol"}));
  EXPECT_TRUE(says(coarse.err, " instead of 1, because of hmax\n")) << coarse.err;
}

TEST_F(MetricRun, ThreadsLeaveTheFileAsItIs) {
  std::set<std::string> files;
  for (const char* threads : {"1", "2", "3"}) {
    expect_done(metric({"lp", "cube.mesh", "u.sol", "v.solb", "--complexity", "500", "--gradation", "1.5", "-o",
                        "out.solb", "--threads", threads}));
    files.insert(read("out.solb"));
  }
  EXPECT_EQ(files.size(), 1U);
}

TEST_F(MetricRun, RefusesFilesThatCannotBeUsed) {
  write("few.sol", metric_text(Sizes{1, 2}));
  write("nan.sol", changed(metric_text(Sizes(343, 1.0)), "1 1\n1\n1\n", "1 1\n1\nnan\n"));
  write("flat.mesh", changed(two_tets, "0 0 1 0", "0.25 0.25 0 0"));
  const auto lp = [&](const Words& files, const std::vector<std::string>& parts) {
    Words words = {"lp"};
    words.insert(words.end(), files.begin(), files.end());
    words.insert(words.end(), {"--complexity", "9", "-o", "o.sol"});
    refused(words, parts);
  };
  lp({"cube.mesh", "u.sol", "few.sol"}, {"few.sol: values for 2 vertices found, expected 343"});
  lp({"cube.mesh", "nan.sol"}, {"nan.sol: line 6", "SolAtVertices 2", "finite number"});
  lp({"cube.mesh", "tensors.sol"}, {"tensors.sol: a tensor field found, expected scalars or vectors"});
  lp({"no.mesh", "u.sol"}, {"no.mesh: "});
  lp({"cube.mesh", "no.sol"}, {"no.sol: "});
  refused({"levelset", "cube.mesh", "few.sol", "--error", "1", "-o", "o.sol"}, {"few.sol: values for 2 vertices"});
  refused({"size", "cube.mesh", "few.sol", "-o", "o.sol"}, {"few.sol: ", "343"});
  refused({"intersect", "cube.mesh", "sizes.sol", "few.sol", "-o", "o.sol"}, {"few.sol: ", "343"});
  refused({"implied", "flat.mesh", "-o", "o.sol"}, {"flat.mesh: tetrahedron 1", "flat"});
  refused({"curvature", "flat.mesh", "--deviation", "1", "-o", "o.sol"}, {"flat.mesh: tetrahedron 1", "flat"});
}

TEST_F(MetricRun, RefusesOptionsThatMakeNoSense) {
  refused({}, {"no command found, expected lp, error", "taut metric --help"});
  refused({"l2"}, {"unknown word l2", "taut metric --help"});
  refused({"lp", "cube.mesh", "u.sol", "-o", "o.sol"}, {"--complexity", "taut metric lp --help"});
  refused({"lp", "cube.mesh", "--complexity", "9", "-o", "o.sol"}, {"FIELDS", "taut metric lp --help"});
  refused({"lp", "cube.mesh", "u.sol", "--complexity", "0", "-o", "o.sol"}, {"--complexity", "above 0"});
  refused({"lp", "cube.mesh", "u.sol", "--complexity", "9", "--norm", "0", "-o", "o.sol"}, {"--norm", "1 or more"});
  refused({"lp", "cube.mesh", "u.sol", "--complexity", "9", "--recovery", "x", "-o", "o.sol"},
          {"--recovery", "projec"});
  refused({"lp", "cube.mesh", "u.sol", "--complexity", "9", "--hmin", "2", "--hmax", "1", "-o", "o.sol"},
          {"--hmin: 2", "taut metric lp --help"});
  refused({"error", "cube.mesh", "u.sol", "-o", "o.sol"}, {"--error"});
  refused({"levelset", "cube.mesh", "u.sol", "--error", "1", "--refinement", "1", "-o", "o.sol"}, {"--refinement"});
  refused({"curvature", "cube.mesh", "-o", "o.sol"}, {"--deviation", "taut metric curvature --help"});
  refused({"curvature", "cube.mesh", "--deviation", "0", "-o", "o.sol"}, {"--deviation: 0", "above 0"});
  refused({"curvature", "cube.mesh", "--deviation", "1", "--turn", "91", "-o", "o.sol"}, {"--turn: 91", "at most 90"});
  refused({"size", "cube.mesh", "-o", "o.sol"}, {"file of sizes or --size"});
  refused({"size", "cube.mesh", "sizes.sol", "--size", "1", "-o", "o.sol"}, {"file of sizes or --size"});
  refused({"gradate", "cube.mesh", "sizes.sol", "u.sol", "-o", "o.sol"}, {"taut metric gradate --help"});
  refused({"implied", "cube.mesh", "-o", "o.mesh"}, {"o.mesh: ", ".sol"});
  refused({"implied", "cube.mesh", "-o", "no/o.sol"}, {"no/o.sol: "});
}

TEST_F(MetricRun, HelpHasExamples) {
  EXPECT_TRUE(says(expect_done({"metric", "--help"}).out, "  taut metric lp "));
}

}  // namespace
}  // namespace taut::test
