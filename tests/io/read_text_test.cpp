// Text meshes: the variations that writers use, and what is refused.
#include "io/gmf_builder.hpp"

namespace taut::test {
namespace {

constexpr const char* head = "MeshVersionFormatted 2\nDimension 3\n";
constexpr const char* points = "Vertices\n4\n0 0 0 1\n1 0 0 2\n0 1 0 3\n0 0 1 4\n";
constexpr const char* tets = "Tetrahedra\n1\n1 2 3 4 5\n";

std::string error_of(const std::string& content) {
  return message_of<InputError>([&] { (void)text_mesh(content); });
}
std::string file(const std::string& rest) {
  return std::string(head) + points + rest;
}

void expect_one_tet(const std::string& content) {
  const Mesh mesh = text_mesh(content);
  EXPECT_EQ(mesh.points, (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  EXPECT_EQ(mesh.point_refs, (std::vector<int>{1, 2, 3, 4}));
  EXPECT_EQ(mesh.tetrahedra, (std::vector<std::array<Index, 4>>{{0, 1, 2, 3}}));
  EXPECT_EQ(mesh.tetrahedron_refs, std::vector<int>{5});
}

TEST(ReadText, TakesThePlainForm) {
  expect_one_tet(file(std::string(tets) + "End\n"));
  expect_one_tet(file(tets));
}

TEST(ReadText, TakesOddBlanksAndComments) {
  expect_one_tet(
      "# made by hand\r\n\r\n  MeshVersionFormatted\r\n\t1 # Dimension 2\r\nDimension\r\n3\r\nVertices 4 0 0 0 1 1 0 0 "
      "2 0\r\n1 0 3#three\r\n0 0 1 4 # Tetrahedra 7\r\nTetrahedra 1 1 2\r\n\r\n3 4 5 End");
  expect_one_tet(
      "MeshVersionFormatted 2 Dimension 3 Vertices 4 0 0 0 1 1 0 0 2 0 1 0 3 0 0 1 4 Tetrahedra 1 1 2 3 4 5");
}

TEST(ReadText, TakesTheNumbersOfFortranAndOfC) {
  expect_one_tet(std::string(head) +
                 "Vertices 4\n0.D0 -0 +0. 1\n1d+0 .0e+00 1e-400 +2\n0D-5 +1.0E0 0.0 3\n0 0 1e0 4\n" + tets);
}

TEST(ReadText, TakesAnyOrderAndPassesOverUnknownKeywords) {
  const Mesh mesh = text_mesh(std::string(head) + "Corners 1 4 Normals\n2\n0 0 1\n1 0 -nan\nRidges 1 1\n" + tets +
                              "AngleOfCornerBound 30.5\nNote some free text 12 nan\n" + points +
                              "Hexahedra 0\nEdges 1 3 4 8\nEnd\nVertices twice");
  EXPECT_EQ(mesh.corners, std::vector<Index>{3});
  EXPECT_EQ(mesh.ridges, std::vector<Index>{0});
  EXPECT_EQ(mesh.edges, (std::vector<std::array<Index, 2>>{{2, 3}}));
  EXPECT_EQ(mesh.edge_refs, std::vector<int>{8});
}

TEST(ReadText, NamesTheLineAndTheEntityOfAnIndexOutOfRange) {
  EXPECT_EQ(error_of(file("Tetrahedra\n2\n1 2 3 4 0\n1 2 904 4 0\n")),
            "wing.mesh: line 12: Tetrahedra 2: vertex 904 found, expected 1..4");
  EXPECT_EQ(error_of(file("Tetrahedra 0\nRequiredTetrahedra 1 1")),
            "wing.mesh: line 10: RequiredTetrahedra 1: tetrahedron 1 found, but the file has no tetrahedron");
}

TEST(ReadText, NamesTheLineOfWhatIsNoNumber) {
  EXPECT_EQ(error_of(file("Tetrahedra\n1\n1 2 x3 4 0\n")),
            "wing.mesh: line 10: Tetrahedra: 1 entries announced, but only 5 bytes follow before \"x3\"");
  EXPECT_EQ(error_of(file("Tetrahedra\n1\n1 2 3.5 4 0\n")),
            "wing.mesh: line 11: Tetrahedra 1: integer expected, found \"3.5\"");
  EXPECT_EQ(error_of(file("Tetrahedra\none\n")), "wing.mesh: line 10: Tetrahedra: integer expected, found \"one\"");
  EXPECT_EQ(error_of(file("Tetrahedra 1 99999999999999999999 1 1 1 1")),
            "wing.mesh: line 9: Tetrahedra 1: integer expected, found \"99999999999999999999\"");
  EXPECT_EQ(error_of(std::string(head) + "Vertices 1\n0.0 1.0.0 0 0\n" + tets),
            "wing.mesh: line 4: Vertices 1: finite number expected, found \"1.0.0\"");
  EXPECT_EQ(error_of(file("Tetrahedra 1 1 2 3 \x01\x7f\xff 5 End")).substr(0, 18), "wing.mesh: line 9:");
}

TEST(ReadText, RefusesCoordinatesThatAreNotFinite) {
  const auto with = [](const std::string& bad) {
    return error_of(std::string(head) + "Vertices\n2\n0.00 0.00 0.00 0\n0 " + bad + " 0 0\n" + tets);
  };
  EXPECT_EQ(with("1e999"), "wing.mesh: line 6: Vertices 2: finite number expected, found \"1e999\"");
  EXPECT_EQ(with("nan"), "wing.mesh: line 6: Vertices 2: finite number expected, found infinity or not-a-number");
  EXPECT_EQ(with("Inf"), "wing.mesh: line 6: Vertices 2: finite number expected, found infinity or not-a-number");
  EXPECT_EQ(with("-nan"), "wing.mesh: line 6: Vertices 2: finite number expected, found infinity or not-a-number");
  EXPECT_EQ(with("-inf"), "wing.mesh: line 6: Vertices 2: finite number expected, found infinity or not-a-number");
}

TEST(ReadText, RefusesTooFewAndTooManyValues) {
  EXPECT_EQ(error_of(file("Tetrahedra\n2\n1111 2 3 4 5\n1111 End\n")),
            "wing.mesh: line 11: Tetrahedra 1: vertex 1111 found, expected 1..4");
  EXPECT_EQ(error_of(file("Tetrahedra 2\n1 2 3 4 50000000\n1 End\n")),
            "wing.mesh: line 11: Tetrahedra 2: integer expected, found \"End\"");
  EXPECT_EQ(error_of(file("Tetrahedra 2\n1 2 3 4 500000000\n1")),
            "wing.mesh: line 11: Tetrahedra 2: integer expected, found the end of the file");
  EXPECT_EQ(error_of(file("Tetrahedra\n1\n1 2 3 4 5\n6\nEnd\n")),
            "wing.mesh: line 12: Tetrahedra 1: next keyword expected, found \"6\": more values than announced, or "
            "elements that are not linear");
}

TEST(ReadText, RefusesAbsurdCounts) {
  EXPECT_EQ(error_of(file("Tetrahedra 4000000000\n1 2 3 4 0\n")),
            "wing.mesh: line 9: Tetrahedra: 4000000000 entries announced, but only 11 bytes follow before the end of "
            "the file");
  EXPECT_EQ(error_of(file("Tetrahedra -1\n")),
            "wing.mesh: line 9: Tetrahedra: -1 entries announced, expected 0..4294967294");
}

TEST(ReadText, RefusesOtherElementsAndDimensions) {
  EXPECT_EQ(error_of(file("Quadrilaterals 1\n1 2 3 4 0\n")),
            "wing.mesh: line 9: Quadrilaterals: 1 found, but taut takes tetrahedra, triangles and edges only");
  EXPECT_EQ(error_of("MeshVersionFormatted 2\nDimension\n2\nVertices 0\nTetrahedra 0\n"),
            "wing.mesh: line 3: Dimension: 2 found, expected 3: taut takes tetrahedra in three dimensions");
}

TEST(ReadText, RefusesAKeywordThatComesTwiceOrNot) {
  EXPECT_EQ(error_of(file("Edges 0\nVertices 0\n")), "wing.mesh: line 10: keyword Vertices found a second time");
  EXPECT_EQ(error_of(file("")), "wing.mesh: keyword Tetrahedra expected, not found");
  EXPECT_EQ(error_of(std::string(head) + tets), "wing.mesh: keyword Vertices expected, not found");
  EXPECT_EQ(error_of("MeshVersionFormatted 2"), "wing.mesh: keyword Dimension expected, not found");
}

TEST(ReadText, RefusesWhatIsNoGmfFile) {
  const std::string no_gmf = "wing.mesh: not a Gamma Mesh Format file: it does not begin with MeshVersionFormatted";
  EXPECT_EQ(error_of(""), "wing.mesh: the file is empty");
  EXPECT_EQ(error_of("once upon a time"), no_gmf);
  EXPECT_EQ(error_of("meshversionformatted 2 dimension 3"), no_gmf);
  EXPECT_EQ(error_of("Dimension 3 MeshVersionFormatted 2"), no_gmf);
  EXPECT_EQ(error_of("MeshVersionFormatted 7\n"), "wing.mesh: line 1: MeshVersionFormatted: 7 found, expected 1..4");
  EXPECT_EQ(error_of("MeshVersionFormatted"),
            "wing.mesh: line 1: MeshVersionFormatted: integer expected, found the end of the file");
}

TEST(ReadText, ReadsTheSameFromDisk) {
  expect_equal(read_mesh(std::filesystem::path(TAUT_TEST_DATA) / "two_tets.mesh"), two_tets());
}

TEST(ReadFile, RefusesWhatCannotBeOpened) {
  EXPECT_EQ(message_of<InputError>([] { (void)read_mesh("none/such.mesh"); }),
            "none/such.mesh: cannot be read: No such file or directory");
  EXPECT_EQ(message_of<InputError>([] { (void)read_mesh("wing.vtk"); }),
            "wing.vtk: unknown extension \".vtk\", expected .mesh or .meshb, of the Gamma Mesh Format (Medit)");
  EXPECT_EQ(message_of<InputError>([] { (void)read_solution("wing"); }),
            "wing: unknown extension \"\", expected .sol or .solb, of the Gamma Mesh Format (Medit)");
}

}  // namespace
}  // namespace taut::test
