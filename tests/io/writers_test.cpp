// Meshes as other programs write them, and what people take for such meshes.
#include <fmt/format.h>

#include "io/gmf_builder.hpp"

namespace taut::test {
namespace {

constexpr const char* plain = R"(MeshVersionFormatted 2
Dimension 3
Vertices
4
0 0 0 1
1 0 0 2
0 1 0 3
0 0 1 4
Triangles
2
1 3 2 10
1 2 4 11
Tetrahedra
1
1 2 3 4 5
End
)";

void expect_plain(const std::string& content) {
  expect_equal(text_mesh(content), text_mesh(plain));
}

std::string error_of(const std::string& content) {
  return message_of<InputError>([&] { (void)text_mesh(content); });
}

/// `text` with each `old` changed.
std::string with(std::string text, std::string_view old, std::string_view now) {
  for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at + now.size())) {
    text.replace(at, old.size(), now);
  }
  return text;
}

TEST(Writers, Gmsh) {
  expect_plain(
      " MeshVersionFormatted 2\n Dimension\n 3\n Vertices\n 4\n"
      "                    0                    0                    0      1\n"
      "                    1 -6.1232339957368E-327                    0      2\n"
      "                    0                    1                   -0      3\n"
      "                    0                    0                    1      4\n"
      " Triangles\n 2\n 1 3 2 10\n 1 2 4 11\n Tetrahedra\n 1\n 1 2 3 4 5\n End\n");
}

TEST(Writers, Fortran) {
  expect_plain(with(with(plain, "0 0 1 4", "  0.0000D+00   +.0d0   1.0D+000    +4"), "1 0 0 2", "+1. -.0 1.-400 2"));
  const Mesh mesh = text_mesh(with(plain, "1 0 0 2", "-0.15D-01 0.25+100 -.5-300 +2"));
  EXPECT_EQ(mesh.points[1], (Point{-0.015, 0.25e100, -0.5e-300}));
}

TEST(Writers, FortranWhereColumnsWereTooNarrow) {
  for (const char* bad : {"****", "1.0-2.5", "1.0-22", "1.0-100-100", "1.0D", "1.0D+", "1e5-100", "--1", "+-1", "+",
                          "1,5", "2*0.0", "1.0D+400", "1.0+400", "0x1p3", "1..2", "-", ".", "e5"}) {
    const std::string error = error_of(with(plain, "1 0 0 2", fmt::format("1 0 {} 2", bad)));
    EXPECT_TRUE(error.starts_with("wing.mesh: line 6: Vertices 2: finite number expected, found") ||
                error.starts_with("wing.mesh: line 4: Vertices: 4 entries announced"))
        << bad << ": " << error;
  }
  const std::string long_one = "1" + std::string(400, '0') + "e-5";
  EXPECT_NE(error_of(with(plain, "1 0 0 2", "1 0 " + long_one + " 2")).find("line 6"), std::string::npos);
}

TEST(Writers, IntegersAreDigitsWithOrWithoutASign) {
  for (const char* bad : {"+-2", "2.", "2.0", "2e0", "-", "+", "2,", "99999999999999999999"}) {
    EXPECT_EQ(error_of(with(plain, "1 0 0 2", fmt::format("1 0 0 {}", bad))),
              fmt::format("wing.mesh: line 6: Vertices 2: integer expected, found \"{}\"", bad));
  }
  EXPECT_EQ(error_of(with(plain, "1 0 0 2", "1 0 0 4294967295")),
            "wing.mesh: line 6: Vertices 2: reference 4294967295 found, expected a 32-bit number");
}

}  // namespace
}  // namespace taut::test
