// taut adapt --field: the files written, the report, the notes, and what is refused.
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "program/fixture.hpp"
#include "program/meshes.hpp"
#include "taut/taut.hpp"

namespace taut::test {
namespace {

using nlohmann::json;

bool mentions(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

/// A cube with a front, and a file with a vector and a tensor beside it.
class AdaptField : public ProgramTest {
protected:
  AdaptField() {
    const Mesh mesh = cube(6);
    write("cube.mesh", mesh_text(mesh));
    Sizes front;
    Field vector{Field::Kind::vector, {}}, tensor{Field::Kind::tensor, {}};
    for (const auto& [x, y, z] : mesh.points) {
      front.push_back(2 + std::tanh(10 * (x - 0.5)));
      vector.values.insert(vector.values.end(), {x, y, 2 * z});
      tensor.values.insert(tensor.values.end(), {1, x, y, 1, z, 1});
    }
    write("u.sol", metric_text(front));
    write_solution("more.solb", {vector, tensor});
  }

  static Words adapt(const Words& more) {
    Words words = {"adapt", "cube.mesh"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  void refused(const Words& more, const std::vector<std::string>& parts) { expect_error(adapt(more), 2, parts); }
};

TEST_F(AdaptField, WritesMeshMetricAndFields) {
  const std::string table = expect_done(adapt({"--field", "u.sol", "--field", "more.solb", "--complexity", "200", "-o",
                                               "out.meshb", "--report", "out.json"}))
                                .out;
  for (const char* part : {"of the metric on the old mesh", "mass before", "sizing", "transfer", "tau", "relocate"})
    EXPECT_TRUE(mentions(table, part)) << part;
  expect_done({"quality", "out.meshb", "--metric", "out.metric.solb", "--check"});
  const Mesh mesh = read_mesh("out.meshb");
  const std::vector<Field> fields = read_solution("out.solb");
  ASSERT_EQ(fields.size(), 3U);
  EXPECT_EQ(fields[1].kind, Field::Kind::vector);
  EXPECT_EQ(fields[2].kind, Field::Kind::tensor);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    EXPECT_NEAR(fields[1].values[3 * v + 2], 2 * mesh.points[v][2], 1e-12);
    EXPECT_NEAR(fields[2].values[6 * v + 4], mesh.points[v][2], 1e-12);
  }
  EXPECT_EQ(snapshot().size(), 7U);
}

TEST_F(AdaptField, ReportsSizingAndTransfer) {
  expect_done(adapt({"--field", "u.sol", "--complexity", "200", "--norm", "4", "--recovery", "projection", "-o",
                     "out.mesh", "--report", "out.json"}));
  json report = json::parse(read("out.json"));
  EXPECT_EQ(report["fields"], json({"u.sol"}));
  EXPECT_EQ(report["field_out"], "out.sol");
  EXPECT_EQ(report["metric_out"], "out.metric.sol");
  EXPECT_TRUE(report["metric"].is_null());
  EXPECT_EQ(report["sizing"]["asked_complexity"], 200);
  EXPECT_NEAR(report["sizing"]["complexity"].get<double>(), 200, 0.41);
  EXPECT_TRUE(report["sizing"]["stopped_by"].is_null());
  EXPECT_EQ(report["sizing"]["norm"], 4);
  EXPECT_EQ(report["sizing"]["recovery"], "projection");
  const json mass = report["transfer"]["fields"][0][0];
  EXPECT_NEAR(mass["mass_after"].get<double>(), mass["mass_before"].get<double>(), 1e-12);
  for (const char* phase : {"read", "sizing", "transfer", "write"}) EXPECT_TRUE(report["seconds"].contains(phase));
  expect_done(adapt({"--size", "0.5", "-o", "out.mesh", "--report", "out.json"}));
  report = json::parse(read("out.json"));
  EXPECT_FALSE(report.contains("sizing") || report.contains("transfer"));
  EXPECT_EQ(report["fields"], json::array());
}

TEST_F(AdaptField, InterpolatesIfAsked) {
  expect_done(adapt({"--field", "u.sol", "--complexity", "100", "--transfer", "linear", "-o", "out.mesh", "--report",
                     "out.json", "--field-out", "u-new.solb", "--metric-out", "m.sol"}));
  const json transfer = json::parse(read("out.json"))["transfer"];
  EXPECT_EQ(transfer, json({{"method", "linear"}}));
  EXPECT_EQ(read_solution("u-new.solb")[0].values.size(), read_mesh("out.mesh").points.size());
  EXPECT_FALSE(std::filesystem::exists("out.sol") || std::filesystem::exists("out.metric.sol"));
}

TEST_F(AdaptField, MayReplaceItsInput) {
  expect_done(adapt({"--field", "u.sol", "--complexity", "100", "-o", "cube.mesh", "--field-out", "u.sol"}));
  EXPECT_EQ(read_solution("u.sol")[0].values.size(), read_mesh("cube.mesh").points.size());
  expect_done(adapt({"--field", "u.sol", "--complexity", "100", "-o", "cube.mesh", "--field-out", "u.sol", "--quiet"}));
}

TEST_F(AdaptField, ThreadsLeaveTheFilesAsTheyAre) {
  std::set<std::string> meshes, fields;
  for (const char* threads : {"1", "3"}) {
    expect_done(adapt({"--field", "u.sol", "--complexity", "200", "-o", "out.meshb", "--threads", threads}));
    meshes.insert(read("out.meshb"));
    fields.insert(read("out.solb"));
  }
  EXPECT_EQ(meshes.size(), 1U);
  EXPECT_EQ(fields.size(), 1U);
}

TEST_F(AdaptField, NotesTheLimitThatStopsIt) {
  const Words fine = adapt({"--field", "u.sol", "--complexity", "1e5", "--hmin", "0.2", "-o", "out.mesh"});
  const Outcome outcome = run(fine);
  EXPECT_EQ(outcome.status, 0);
  EXPECT_TRUE(mentions(outcome.err, " instead of 1e+05, because of hmin\n")) << outcome.err;
  const Outcome coarse = run(adapt({"--field", "u.sol", "--complexity", "10", "--hmax", "0.2", "-o", "out.mesh"}));
  EXPECT_TRUE(mentions(coarse.err, "because of hmax")) << coarse.err;
}

TEST_F(AdaptField, NotesThatAFixedSurfaceKeepsTheMeshFromItsSize) {
  const Words words = adapt({"--field", "u.sol", "--complexity", "20", "-o", "out.mesh", "--surface"});
  const auto with = [&](const char* surface) {
    Words all = words;
    all.emplace_back(surface);
    return run(all);
  };
  const Outcome fixed = with("fixed");
  EXPECT_EQ(fixed.status, 0);
  EXPECT_TRUE(mentions(fixed.err, "tetrahedra instead of about 210, because of the triangles that stay")) << fixed.err;
  EXPECT_EQ(with("adapt").err, "");
}

TEST_F(AdaptField, RefusesFieldsThatCannotBeUsed) {
  const auto with_field = [&](const std::string& file, const std::vector<std::string>& parts) {
    refused({"--field", "u.sol", "--field", file, "--complexity", "9", "-o", "out.mesh"}, parts);
  };
  write("few.sol", metric_text(Sizes{1, 2}));
  with_field("few.sol", {"taut: error: few.sol: values for 2 vertices found, expected 343"});
  write("nan.sol", changed(metric_text(Sizes(343, 1.0)), "1 1\n1\n1\n", "1 1\n1\nnan\n"));
  with_field("nan.sol", {"taut: error: nan.sol: line 6", "SolAtVertices 2", "finite number"});
  with_field("no.sol", {"taut: error: no.sol: "});
  write("tensors.sol", metric_text(Tensors(343, {1, 0, 0, 1, 0, 1})));
  refused({"--field", "tensors.sol", "--complexity", "9", "-o", "out.mesh"},
          {"taut: error: tensors.sol: only tensors found, expected a scalar or a vector"});
  refused({"--field", "u.sol", "--complexity", "1e12", "-o", "out.mesh"}, {"taut: error: --complexity: about "});
}

TEST_F(AdaptField, RefusesOutputsThatCollide) {
  const auto with = [&](const Words& more, const std::vector<std::string>& parts) {
    Words words = {"--field", "no.sol", "--complexity", "9", "-o", "out.mesh"};
    words.insert(words.end(), more.begin(), more.end());
    refused(words, parts);
  };
  with({"--field-out", "x.sol", "--metric-out", "./x.sol"}, {"taut: error: ./x.sol: found as the file for the fields"});
  with({"--metric-out", "out.sol"}, {"taut: error: out.sol: found as the file for the fields and for the metric"});
  with({"--field-out", "out.metric.sol"}, {"taut: error: out.metric.sol: found"});
  with({"--field-out", "no/x.sol"}, {"taut: error: no/x.sol: "});
  with({"--field-out", "x.mesh"}, {"taut: error: x.mesh: ", ".sol"});
}

TEST_F(AdaptField, RefusesOptionsThatDoNotGoTogether) {
  refused({"--field", "u.sol", "-o", "out.mesh"}, {"--field requires --complexity", "taut adapt --help"});
  for (const auto& [option, value] : std::map<std::string, std::string>{{"--complexity", "9"},
                                                                        {"--norm", "2"},
                                                                        {"--recovery", "projection"},
                                                                        {"--transfer", "linear"},
                                                                        {"--field-out", "x.sol"}})
    refused({"--size", "1", "-o", "out.mesh", option, value}, {option + " requires --field", "taut adapt --help"});
  refused({"--field", "u.sol", "--complexity", "9", "--size", "1", "-o", "out.mesh"}, {"--size and --field found"});
  refused({"--field", "u.sol", "--complexity", "9", "--metric", "m.sol", "-o", "out.mesh"},
          {"--metric and --field found", "only one"});
  refused({"--field", "u.sol", "--complexity", "0", "-o", "out.mesh"}, {"--complexity", "above 0"});
  refused({"--field", "u.sol", "--complexity", "9", "--norm", "0.5", "-o", "out.mesh"}, {"--norm", "1 or more"});
  refused({"--field", "u.sol", "--complexity", "9", "--transfer", "fast", "-o", "out.mesh"}, {"--transfer", "linear"});
  refused({"--field", "u.sol", "more.solb", "--complexity", "9", "-o", "out.mesh"}, {"more.solb", "taut adapt --help"});
}

}  // namespace
}  // namespace taut::test
