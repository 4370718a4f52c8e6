// taut transfer: the files written, the report, and input that cannot be used.
#include <cmath>
#include <nlohmann/json.hpp>

#include "program/fixture.hpp"
#include "program/meshes.hpp"
#include "taut/taut.hpp"

namespace taut::test {
namespace {

class TransferRun : public ProgramTest {
protected:
  TransferRun() {
    write("from.mesh", mesh_text(from_));
    write("to.mesh", mesh_text(to_));
    write("u.sol", metric_text(sampled(from_)));
  }

  static Sizes sampled(const Mesh& mesh) {
    Sizes values;
    for (const Point& p : mesh.points) values.push_back(1 + 2 * p[0] - p[1] + 3 * p[2]);
    return values;
  }

  const Mesh from_ = cube(2), to_ = cube(3);
};

TEST_F(TransferRun, WritesTheFieldsAndAReport) {
  for (const char* method : {"conservative", "linear"}) {
    const std::string table = expect_done({"transfer", "from.mesh", "u.sol", "to.mesh", "-o", "out.solb", "--method",
                                           method, "--report", "out.json"})
                                  .out;
    for (const char* part : {"mass before", "greatest before", "outside         0 points", "read", "write"})
      EXPECT_NE(table.find(part), std::string::npos) << part;
    const std::vector<Field> fields = read_solution("out.solb");
    ASSERT_EQ(fields.size(), 1U);
    const Sizes expected = sampled(to_);
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(fields[0].values.at(i), expected[i], 1e-13);
    const auto report = nlohmann::json::parse(read("out.json"));
    EXPECT_EQ(report["options"]["method"], method);
    EXPECT_EQ(report["outside"], 0);
    EXPECT_NEAR(report["fields"][0][0]["mass_after"].get<double>(), 3, 1e-13);
    EXPECT_EQ(report["covered_volume"].is_null(), std::string(method) == "linear");
  }
  EXPECT_EQ(expect_done({"transfer", "from.mesh", "u.sol", "to.mesh", "-o", "out.sol", "--quiet"}).out, "");
}

TEST_F(TransferRun, ThreadsLeaveTheFileAsItIs) {
  expect_done({"transfer", "from.mesh", "u.sol", "to.mesh", "-o", "one.solb", "--threads", "1"});
  expect_done({"transfer", "from.mesh", "u.sol", "to.mesh", "-o", "three.solb", "--threads", "3"});
  EXPECT_EQ(read("one.solb"), read("three.solb"));
}

TEST_F(TransferRun, ErrorsNameTheFile) {
  const auto refused = [&](const Words& words, const std::vector<std::string>& parts) {
    Words all = {"transfer"};
    all.insert(all.end(), words.begin(), words.end());
    expect_error(all, 2, parts);
  };
  write("bad.mesh", changed(two_tets, "0 0 1 0", "0.25 0.25 0 0"));
  write("few.sol", metric_text(Sizes{1, 2}));
  refused({"from.mesh", "few.sol", "to.mesh", "-o", "o.sol"}, {"taut: error: few.sol: field 1: 2 values", "27"});
  refused({"from.mesh", "u.sol", "bad.mesh", "-o", "o.sol"}, {"taut: error: bad.mesh: tetrahedron 1", "flat"});
  refused({"bad.mesh", "u.sol", "to.mesh", "-o", "o.sol"}, {"taut: error: u.sol: field 1: 27 values", "5"});
  refused({"from.mesh", "no.sol", "to.mesh", "-o", "o.sol"}, {"taut: error: no.sol: "});
  refused({"from.mesh", "u.sol", "no.mesh", "-o", "o.sol"}, {"taut: error: no.mesh: "});
  refused({"from.mesh", "u.sol", "to.mesh", "-o", "o.mesh"}, {"taut: error: o.mesh: ", ".sol"});
  refused({"from.mesh", "u.sol", "to.mesh", "-o", "no/o.sol"}, {"taut: error: no/o.sol: "});
  refused({"from.mesh", "u.sol", "to.mesh", "-o", "o.sol", "--report", "r"}, {"taut: error: r: ", ".json"});
  refused({"from.mesh", "u.sol", "to.mesh"}, {"--output", "taut transfer --help"});
  refused({"from.mesh", "u.sol", "to.mesh", "-o", "o.sol", "--method", "fast"}, {"--method", "fast", "linear"});
}

}  // namespace
}  // namespace taut::test
