// taut adapt --optimise, --local and --ridges: what they do, the report, and what is refused.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "program/fixture.hpp"
#include "program/meshes.hpp"
#include "taut/taut.hpp"

namespace taut::test {
namespace {

using nlohmann::json;

/// A cube with sides of reference 1, or 2 where x = 1, and a line across its top at x = 1/2.
class OptionsOfAdapt : public ProgramTest {
protected:
  OptionsOfAdapt() {
    for (const auto& t : mesh.triangles) {
      const bool far = std::ranges::all_of(t, [&](Index p) { return mesh.points[p][0] == 1; });
      mesh.triangle_refs.push_back(far ? 2 : 1);
    }
    write_mesh("cube.mesh", mesh);
  }

  static Words adapt(const Words& more) {
    Words words = {"adapt", "cube.mesh", "-o", "out.mesh", "--report", "out.json"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  void refused(const Words& more, const std::vector<std::string>& parts) { expect_error(adapt(more), 2, parts); }

  /// The index of the point there.
  [[nodiscard]] Index at(const Point& place) const {
    return static_cast<Index>(std::ranges::find(mesh.points, place) - mesh.points.begin());
  }

  /// A front at the points.
  [[nodiscard]] Sizes sampled() const {
    Sizes values;
    for (const auto& [x, y, z] : mesh.points) values.push_back(2 + std::tanh(10 * (y - 0.5)));
    return values;
  }

  /// Two vertex numbers a line, from 1.
  [[nodiscard]] std::string line_text() const {
    std::string text;
    for (int j = 0; j < n; ++j)
      text += std::to_string(at({0.5, j / 8.0, 1}) + 1) + " " + std::to_string(at({0.5, (j + 1) / 8.0, 1}) + 1) + "\n";
    return text;
  }

  /// The length of the ridges of the output on the line.
  static double length_on_line() {
    const Mesh found = read_mesh("out.mesh");
    double sum = 0;
    for (const Index e : found.ridges) {
      const Point &p = found.points[found.edges[e][0]], &q = found.points[found.edges[e][1]];
      const auto on_line = [](const Point& x) { return std::abs(x[0] - 0.5) < 1e-9 && x[2] == 1; };
      if (on_line(p) && on_line(q)) sum += std::abs(p[1] - q[1]);
    }
    return sum;
  }

  static constexpr int n = 8;
  Mesh mesh = cube(n);
};

TEST_F(OptionsOfAdapt, OptimiseKeepsTheNumberOfTetrahedra) {
  for (const char* word : {"--optimise", "--optimize"}) {
    expect_done(adapt({word}));
    const json report = json::parse(read("out.json"));
    EXPECT_TRUE(report["options"]["optimise"].get<bool>());
    EXPECT_TRUE(report["metric"].is_null());
    EXPECT_NEAR(report["quality"]["tetrahedra"].get<double>() / static_cast<double>(mesh.tetrahedra.size()), 1, 0.15);
  }
  expect_done(adapt({"--optimise", "--hmin", "0.3"}));
  EXPECT_LT(json::parse(read("out.json"))["quality"]["tetrahedra"], mesh.tetrahedra.size() / 4);
}

TEST_F(OptionsOfAdapt, OptimiseStandsAlone) {
  for (const Words& more :
       {Words{"--size", "1"}, Words{"--metric", "m.sol"}, Words{"--field", "u.sol", "--complexity", "9"}}) {
    Words words = {"--optimise"};
    words.insert(words.end(), more.begin(), more.end());
    refused(words, {"taut: error: " + more[0] + " and --optimise found, expected only one", "taut adapt --help"});
  }
  refused({}, {"none of --metric, --size, --field and --optimise found", "taut adapt --help"});
}

TEST_F(OptionsOfAdapt, LocalSizesGoWithEveryTarget) {
  write("local.json", R"({"triangles": {"2": {"max": 0.05}}})");
  write("u.sol", metric_text(sampled()));
  write("m.sol", metric_text(Sizes(mesh.points.size(), 0.5)));
  for (const Words& target : {Words{}, Words{"--optimise"}, Words{"--size", "0.5"}, Words{"--metric", "m.sol"},
                              Words{"--field", "u.sol", "--complexity", "100"}}) {
    Words words = adapt({"--local", "local.json", "--metric-out", "m.out.sol"});
    words.insert(words.end(), target.begin(), target.end());
    expect_done(words);
    EXPECT_EQ(json::parse(read("out.json"))["options"]["local"], "local.json");
    const Mesh found = read_mesh("out.mesh");
    double longest = 0;
    for (std::size_t t = 0; t < found.triangles.size(); ++t) {
      if (found.triangle_refs[t] != 2) continue;
      const auto& v = found.triangles[t];
      for (int k = 0; k < 3; ++k) {
        const Point &p = found.points[v[k]], &q = found.points[v[(k + 1) % 3]];
        longest = std::max(longest, std::hypot(p[1] - q[1], p[2] - q[2]));
      }
    }
    EXPECT_LT(longest, 0.1) << (target.empty() ? "alone" : target[0]);
  }
}

TEST_F(OptionsOfAdapt, MistakesInLocalSizesAreNamed) {
  const auto with = [&](const char* text, const std::vector<std::string>& parts) {
    write("local.json", text);
    refused({"--local", "local.json"}, parts);
    refused({"--local", "local.json", "--size", "1"}, parts);
  };
  with(R"({"triangles": {"5": {"size": 1}}})", {"taut: error: local.json: triangles.5: none of the mesh's 768"});
  with(R"({"triangles": {"2": {"min": 2, "max": 1}}})", {"taut: error: local.json: triangles.2.min: 2 found"});
  with(R"({"triangles": {"2": {"sise": 2}}})", {"taut: error: local.json: triangles.2: unknown key \"sise\""});
  write("u.sol", metric_text(sampled()));
  write("local.json", R"({"edges": {"5": {"size": 1}}})");
  refused({"--local", "local.json", "--field", "u.sol", "--complexity", "9"}, {"taut: error: local.json: edges.5: "});
  refused({"--local", "no.json"}, {"taut: error: no.json: "});
}

TEST_F(OptionsOfAdapt, RidgesComeFromTextAndMeshes) {
  write("line.txt", "# across the top\n\n" + line_text());
  expect_done(adapt({"--size", "0.3", "--ridges", "line.txt"}));
  EXPECT_NEAR(length_on_line(), 1, 1e-12);
  EXPECT_EQ(json::parse(read("out.json"))["options"]["ridges"], "line.txt");
  Mesh lines;
  for (int j = 0; j <= n; ++j) lines.points.push_back({0.5, j / 8.0, 1});
  for (Index j = 0; j < n; ++j) lines.edges.push_back({j, j + 1});
  write_mesh("line.meshb", lines);
  expect_done(adapt({"--size", "0.3", "--ridges", "line.meshb"}));
  EXPECT_NEAR(length_on_line(), 1, 1e-12);
  expect_done(adapt({"--size", "0.3"}));
  EXPECT_EQ(length_on_line(), 0);
}

TEST_F(OptionsOfAdapt, MistakesInRidgesAreNamed) {
  const auto with = [&](const std::string& text, const std::vector<std::string>& parts) {
    write("line.txt", text);
    refused({"--size", "1", "--ridges", "line.txt"}, parts);
  };
  for (const char* line : {"1", "1 2 3", "1 x", "0 1", "-1 2", "1,2", "1.0 2"})
    with(std::string("# two\n") + line + " # end\r\n",
         {"taut: error: line.txt: line 2: two vertex numbers expected, counted from 1, found \"" + std::string(line)});
  with("# nothing\n", {"taut: error: line.txt: no edges found"});
  with("1 2\n1 2000\n", {"taut: error: line.txt: edge 2: vertex 2000 found, expected 1..729"});
  with("1 729\n", {"taut: error: line.txt: edge 1 (1 729) is no edge of a triangle"});
  refused({"--size", "1", "--ridges", "no.txt"}, {"taut: error: no.txt: cannot be read"});
  refused({"--size", "1", "--ridges", "no.mesh"}, {"taut: error: no.mesh: "});
  refused({"--size", "1", "--ridges", "cube.mesh"}, {"taut: error: cube.mesh: ", "Edges"});
  Mesh lines;
  lines.points = {{0.5, 0, 1}, {0.5, 0.1, 1}};
  lines.edges = {{0, 1}};
  write_mesh("line.mesh", lines);
  refused({"--size", "1", "--ridges", "line.mesh"}, {"taut: error: line.mesh: vertex 2 (0.5 0.1 1): no vertex of"});
}

}  // namespace
}  // namespace taut::test
