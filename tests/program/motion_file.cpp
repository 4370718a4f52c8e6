// The file that says how the boundary moves: what is read from it, and what is said about mistakes.
#include "motion_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "program/meshes.hpp"
#include "step_names.hpp"

namespace taut::test {
namespace {

using program::MotionFile;
using program::read_motion;
using program::StepNames;

constexpr const char* good = R"({
  "bodies": [
    {"references": [7, -8], "translation": [0, 0, -0.5]},
    {"references": [9], "rotation": {"centre": [1, 0, 0], "axis": [0, 0, 2], "degrees": 90}},
    {"references": [5], "motions": [{"rotation": {"centre": [1, 0, 0], "axis": [0, 0, 1], "degrees": -90}},
                                    {"translation": [4, 0, 0]}]},
    {"references": [3], "displacements": "wing.solb"}
  ],
  "fixed": [1, 4],
  "sliding": [2]
})";

class MotionFiles : public testing::Test {
protected:
  MotionFiles() : folder_(std::filesystem::path(testing::TempDir()) / "taut-motion-file") {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ += info->name();
    std::filesystem::create_directories(folder_);
  }
  ~MotionFiles() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] MotionFile read(const std::string& text) const {
    std::ofstream(file()) << text;
    return read_motion(file());
  }

  /// The message about the file's content, without the file's name.
  [[nodiscard]] std::string error_of(const std::string& text) const {
    try {
      (void)read(text);
    } catch (const InputError& error) {
      const std::string message = error.what(), name = file().string() + ": ";
      EXPECT_TRUE(message.starts_with(name)) << message;
      return message.substr(name.size());
    }
    return "nothing thrown";
  }

  /// The same for the good file with `from` replaced by `to`.
  [[nodiscard]] std::string error_with(const char* from, const char* to) const {
    return error_of(changed(good, from, to));
  }

  [[nodiscard]] std::filesystem::path file() const { return folder_ / "motion.json"; }

  std::filesystem::path folder_;
};

void expect_near(const Point& a, const Point& b) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-14);
}

TEST_F(MotionFiles, AreRead) {
  const MotionFile motion = read(good);
  ASSERT_EQ(motion.bodies.size(), 4U);
  EXPECT_EQ(motion.bodies[0].references, (std::vector<int>{7, -8}));
  expect_near(motion.bodies[0].place_after(1)({1, 2, 3}), {1, 2, 2.5});
  expect_near(motion.bodies[1].place_after(1)({2, 0, 0}), {1, 1, 0});
  EXPECT_EQ(motion.bodies[2].motions.size(), 2U);
  EXPECT_TRUE(motion.bodies[3].motions.empty());
  EXPECT_EQ(motion.bodies[3].displacements, folder_ / "wing.solb");
  EXPECT_EQ(motion.fixed, (std::vector<int>{1, 4}));
  EXPECT_EQ(motion.sliding, (std::vector<int>{2}));
}

TEST_F(MotionFiles, NeedOnlyOneBody) {
  const MotionFile motion = read(R"({"bodies": [{"references": [0], "translation": [1, 2, 3]}]})");
  EXPECT_EQ(motion.bodies.size(), 1U);
  EXPECT_TRUE(motion.fixed.empty());
  EXPECT_TRUE(motion.sliding.empty());
}

// With the rotation first, the axis travels with the body: the point on it only moves along.
TEST_F(MotionFiles, AMotionInTheListIsRepeatedBeforeTheNext) {
  const auto body = read(good).bodies[2];
  expect_near(body.place_after(3)({1, 0, 0}), {13, 0, 0});
  expect_near(body.place_after(2)({2, 0, 0}), {8, 0, 0});
  expect_near(body.place_after(0.5)({1, 0, 0}), {3, 0, 0});
}

TEST_F(MotionFiles, WrongValuesAreNamed) {
  EXPECT_EQ(error_with("[0, 0, 2]", "[0, 2]"), "bodies[1].rotation.axis: three numbers expected, found [0,2]");
  EXPECT_EQ(error_with("[0, 0, 2]", "[0, 0, \"2\"]"),
            "bodies[1].rotation.axis: three numbers expected, found [0,0,\"2\"]");
  EXPECT_EQ(error_with("[0, 0, 2]", "{}"), "bodies[1].rotation.axis: three numbers expected, found {}");
  EXPECT_EQ(error_with("[0, 0, 2]", "[0, 0, 0]"),
            "bodies[1].rotation: rotation: axis: (0, 0, 0) found, expected a vector of any other length");
  EXPECT_EQ(error_with("90}}", "\"90\"}}"), "bodies[1].rotation.degrees: a number expected, found \"90\"");
  EXPECT_EQ(error_with("90}}", "200}}"), "bodies[1].rotation.degrees: a number from -180 to 180 expected, found 200");
  EXPECT_EQ(error_with("\"wing.solb\"", "7"), "bodies[3].displacements: the name of a file expected, found 7");
  EXPECT_EQ(error_with("\"wing.solb\"", "\"\""), "bodies[3].displacements: the name of a file expected, found \"\"");
  EXPECT_EQ(error_with("[4, 0, 0]", "4"), "bodies[2].motions[1].translation: three numbers expected, found 4");
  EXPECT_EQ(error_of("[]"), "an object expected, found []");
  EXPECT_EQ(error_of(R"({"bodies": {}})"), "bodies: a list of bodies expected, found {}");
  EXPECT_EQ(error_of(R"({"bodies": []})"), "bodies: at least one body expected, found []");
  EXPECT_EQ(error_of(R"({"bodies": [3]})"), "bodies[0]: an object expected, found 3");
}

TEST_F(MotionFiles, WrongReferencesAreNamed) {
  EXPECT_EQ(error_with("[7, -8]", "7"), "bodies[0].references: a list of references expected, found 7");
  EXPECT_EQ(error_with("[7, -8]", "[]"), "bodies[0].references: at least one reference expected, found []");
  for (const char* bad : {"7.0", "\"7\"", "2147483648", "-2147483649", "18446744073709551615", "true"}) {
    const std::string list = std::string("[7, ") + bad + "]";
    EXPECT_EQ(error_with("[7, -8]", list.c_str()),
              std::string("bodies[0].references[1]: a reference, which is a 32-bit integer, expected, found ") + bad);
  }
  EXPECT_EQ(error_with("[9]", "[9, 7]"), "bodies[1].references[1]: reference 7 found again, after bodies[0]");
  EXPECT_EQ(error_with("[1, 4]", "[4, 4]"), "fixed[1]: reference 4 found again, after fixed");
  EXPECT_EQ(error_with("[2]", "[5]"), "sliding[0]: reference 5 found again, after bodies[2]");
}

TEST_F(MotionFiles, WrongKeysAreNamed) {
  EXPECT_EQ(error_with("\"fixed\"", "\"Fixed\""), "unknown key \"Fixed\" found, expected bodies, fixed, sliding");
  EXPECT_EQ(error_with("\"degrees\": 90", "\"angle\": 90"),
            "bodies[1].rotation: unknown key \"angle\" found, expected centre, axis, degrees");
  EXPECT_EQ(error_with(", \"degrees\": 90", ""), "bodies[1].rotation: key \"degrees\" expected, not found");
  EXPECT_EQ(error_with("\"references\": [9], ", ""), "bodies[1]: key \"references\" expected, not found");
  EXPECT_EQ(error_of("{}"), "key \"bodies\" expected, not found");
  const std::string one = "exactly one of translation, rotation, motions, displacements expected, found ";
  EXPECT_EQ(error_with(", \"displacements\": \"wing.solb\"", ""), "bodies[3]: " + one + "0");
  EXPECT_EQ(error_with("\"wing.solb\"", "\"wing.solb\", \"motions\": []"), "bodies[3]: " + one + "2");
  EXPECT_EQ(error_of(R"({"bodies": [{"references": [1], "motions": []}]})"),
            "bodies[0].motions: at least one motion expected, found []");
  EXPECT_EQ(error_of(R"({"bodies": [{"references": [1], "motions": [{}]}]})"),
            "bodies[0].motions[0]: exactly one of translation, rotation expected, found 0");
}

TEST_F(MotionFiles, WhatIsNotJsonIsNamed) {
  EXPECT_TRUE(error_of("{\n\"bodies\": [}").starts_with("parse error at line 2, column 12: "));
  EXPECT_TRUE(error_of("").starts_with("parse error at line 1, column 1: "));
  EXPECT_TRUE(error_with("-0.5", "1e999").starts_with("number overflow"));
  EXPECT_EQ(error_with("\"sliding\"", "\"fixed\""), "key \"fixed\" found twice in one object");
  EXPECT_EQ(error_with("\"centre\": [1, 0, 0], \"axis\": [0, 0, 2]", "\"axis\": [1, 0, 0], \"axis\": [0, 0, 2]"),
            "key \"axis\" found twice in one object");
  EXPECT_THROW((void)read_motion(folder_ / "none.json"), InputError);
}

TEST(StepNames, CountWithZeros) {
  const StepNames names("runs/out-%04d.meshb");
  EXPECT_EQ(names(0), "runs/out-0000.meshb");
  EXPECT_EQ(names(37), "runs/out-0037.meshb");
  EXPECT_EQ(names(123456), "runs/out-123456.meshb");
  EXPECT_EQ(StepNames("%01d.vtu")(12), "12.vtu");
  EXPECT_EQ(StepNames("{}%03d{0}")(5), "{}005{0}");
}

TEST(StepNames, HaveOnePlaceForTheNumber) {
  for (const char* bad : {"out.meshb", "", "out-%d.meshb", "out-%4d.meshb", "out-%00d.meshb", "out-%04s.meshb",
                          "out-%012d.meshb", "out-%04d-%04d.meshb", "out-%%04d.meshb", "out-%04d%.meshb", "out-%n",
                          "out-%04", "run-%04d/out.meshb", "%s%04d.meshb"})
    EXPECT_THROW(StepNames{bad}, InputError) << bad;
}

}  // namespace
}  // namespace taut::test
