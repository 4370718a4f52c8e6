// The file of sizes by reference: what is read from it, and what is said about mistakes.
#include "local_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "program/meshes.hpp"
#include "taut/error.hpp"

namespace taut::test {
namespace {

using program::read_local_sizes;

constexpr const char* good = R"({
  "points": {"1": {"size": 0.005}},
  "edges": {"-7": {"size": 0.01}},
  "triangles": {"3": {"size": 0.02}, "4": {"deviation": 1e-3, "min": 0.01}},
  "tetrahedra": {"2": {"min": 0.01, "max": 1}}
})";

class LocalFiles : public testing::Test {
protected:
  LocalFiles() : file_((std::filesystem::path(testing::TempDir()) / "taut-local-").string()) {
    file_ += testing::UnitTest::GetInstance()->current_test_info()->name();
    file_ += ".json";
  }
  ~LocalFiles() override { std::filesystem::remove(file_); }

  [[nodiscard]] LocalSizes read(const std::string& text) const {
    std::ofstream(file_) << text;
    return read_local_sizes(file_);
  }

  /// The message about the file's content, without the file's name.
  [[nodiscard]] std::string error_of(const std::string& text) const {
    try {
      (void)read(text);
    } catch (const InputError& error) {
      const std::string message = error.what();
      EXPECT_TRUE(message.starts_with(file_ + ": ")) << message;
      return message.substr(file_.size() + 2);
    }
    return "nothing thrown";
  }

  /// The same for the good file with `from` replaced by `to`.
  [[nodiscard]] std::string error_with(const char* from, const char* to) const {
    return error_of(changed(good, from, to));
  }

  std::string file_;
};

TEST_F(LocalFiles, AreRead) {
  const LocalSizes sizes = read(good);
  EXPECT_EQ(sizes.points.at(1).size, 0.005);
  EXPECT_EQ(sizes.edges.at(-7).size, 0.01);
  EXPECT_EQ(sizes.triangles.size(), 2U);
  EXPECT_EQ(sizes.triangles.at(3).deviation, 0);
  EXPECT_EQ(sizes.triangles.at(4).deviation, 1e-3);
  EXPECT_EQ(sizes.triangles.at(4).size, std::numeric_limits<double>::infinity());
  EXPECT_EQ(sizes.tetrahedra.at(2).min, 0.01);
  EXPECT_EQ(sizes.tetrahedra.at(2).max, 1);
}

TEST_F(LocalFiles, WrongKeysAreNamed) {
  EXPECT_EQ(error_with("\"edges\"", "\"Edges\""),
            "unknown key \"Edges\" found, expected points, edges, triangles, tetrahedra");
  EXPECT_EQ(error_with("\"max\": 1", "\"hmax\": 1"),
            "tetrahedra.2: unknown key \"hmax\" found, expected size, min, max");
  EXPECT_EQ(error_with("\"size\": 0.005", "\"deviation\": 0.005"),
            "points.1: unknown key \"deviation\" found, expected size, min, max");
  for (const char* bad : {"x", "", "1.5", "+3", " 3", "2147483648"}) {
    std::string key = "\"", message = "triangles.";
    key.append(bad).append("\"");
    message.append(bad).append(": a reference, which is a 32-bit integer, expected as this key");
    EXPECT_EQ(error_with("\"3\"", key.c_str()), message);
  }
  EXPECT_EQ(error_with("\"3\"", "\"04\""), "triangles.4: this reference was given before");
  EXPECT_EQ(error_with("\"3\"", "\"4\""), "key \"4\" found twice in one object");
}

TEST_F(LocalFiles, WrongValuesAreNamed) {
  EXPECT_EQ(error_with("0.02", "\"0.02\""), "triangles.3.size: a number expected, found \"0.02\"");
  EXPECT_EQ(error_with("0.02", "0"), "triangles.3.size: a number above 0 expected, found 0");
  EXPECT_EQ(error_with("1e-3", "-1"), "triangles.4.deviation: a number above 0 expected, found -1");
  EXPECT_EQ(error_with("{\"size\": 0.02}", "0.02"), "triangles.3: an object expected, found 0.02");
  EXPECT_EQ(error_with("{\"size\": 0.02}", "{}"),
            "triangles.3: at least one of the keys size, min, max expected, found {}");
  EXPECT_EQ(error_of(R"({"edges": [1]})"), "edges: an object with references as keys expected, found [1]");
  EXPECT_EQ(error_of("[]"), "an object expected, found []");
  EXPECT_EQ(error_of("{}"), "sizes for at least one reference expected, found {}");
  EXPECT_EQ(error_of(R"({"edges": {}})"), "sizes for at least one reference expected, found {\"edges\":{}}");
  EXPECT_TRUE(error_of("{").starts_with("parse error at line 1"));
  EXPECT_THROW((void)read_local_sizes("no.json"), InputError);
}

}  // namespace
}  // namespace taut::test
