// The command line: help, the version, and words that make no sense.
#include "program/fixture.hpp"
#include "program/meshes.hpp"
#include "taut/version.hpp"

namespace taut::test {
namespace {

using Usage = ProgramTest;

TEST_F(Usage, Version) {
  EXPECT_EQ(expect_done({"--version"}).out, "taut " TAUT_VERSION "\n");
}

TEST_F(Usage, HelpHasExamples) {
  EXPECT_NE(expect_done({"--help"}).out.find("quality"), std::string::npos);
  EXPECT_NE(expect_done({"adapt", "--help"}).out.find("  taut adapt "), std::string::npos);
  EXPECT_NE(expect_done({"move", "--help"}).out.find("  taut move "), std::string::npos);
  EXPECT_NE(expect_done({"quality", "--help"}).out.find("  taut quality "), std::string::npos);
  EXPECT_NE(expect_done({"transfer", "--help"}).out.find("  taut transfer "), std::string::npos);
}

TEST_F(Usage, UnknownWords) {
  expect_error({}, 2, {"no command found, expected adapt, levelset, metric, move, quality or transfer", "taut --help"});
  expect_error({"adopt"}, 2, {"adopt", "taut --help"});
  expect_error({"adapt", "--frob"}, 2, {"--frob", "taut adapt --help"});
  expect_error({"quality", "a.mesh", "b.mesh"}, 2, {"b.mesh", "taut quality --help"});
  expect_error({"quality"}, 2, {"IN", "taut quality --help"});
  expect_error({"adapt", "a.mesh", "--size", "1"}, 2, {"--output"});
  expect_error({"adapt", "a.mesh", "-o", "b.mesh", "--size"}, 2, {"--size", "value"});
}

TEST_F(Usage, EitherMetricOrSizeOrField) {
  expect_error({"adapt", "a.mesh", "-o", "b.mesh"}, 2, {"none of --metric, --size, --field and --optimise found"});
  expect_error({"adapt", "a.mesh", "-o", "b.mesh", "--size", "1", "--metric", "m.sol"}, 2, {"--metric", "--size"});
}

struct Value {
  const char *option, *value, *expected;
};

TEST_F(Usage, ValuesOutOfRange) {
  constexpr Value values[] = {
      {"--size", "0", "above 0"},          {"--size", "-1", "above 0"},        {"--size", "nan", "above 0"},
      {"--size", "1x", "above 0"},         {"--hmin", "-1", "above 0"},        {"--hmax", "0", "above 0"},
      {"--gradation", "1", "above 1"},     {"--gradation", "on", "or off"},    {"--angle", "0", "between 0 and 180"},
      {"--angle", "180", "between 0 and"}, {"--rounds", "-1", "0 or more"},    {"--rounds", "1.5", "whole"},
      {"--threads", "-1", "0 to 1024"},    {"--threads", "1025", "0 to"},      {"--block-size", "1.5", "whole"},
      {"--surface", "keep", "fixed"},      {"--gradation-mix", "2", "from 0"},
  };
  for (const auto& [option, value, expected] : values)
    expect_error({"adapt", "a.mesh", "--metric", "m.sol", "-o", "b.mesh", option, value}, 2, {option, value, expected});
}

TEST_F(Usage, AMixNeedsGradation) {
  expect_error({"adapt", "a.mesh", "--size", "1", "-o", "b.mesh", "--gradation-mix", "1"}, 2,
               {"--gradation-mix", "--gradation", "taut adapt --help"});
}

TEST_F(Usage, SmallestAboveLargestSize) {
  expect_error({"adapt", "a.mesh", "--size", "1", "-o", "b.mesh", "--hmin", "2", "--hmax", "1"}, 2,
               {"--hmin: 2", "--hmax 1"});
}

}  // namespace
}  // namespace taut::test
