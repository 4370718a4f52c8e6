// Binary meshes: all versions and byte orders, and what is refused.
#include <fmt/format.h>

#include <cmath>

#include "io/gmf_builder.hpp"

namespace taut::test {
namespace {

GmfBuilder with_vertices(int version = 2, std::endian order = std::endian::little) {
  GmfBuilder builder(version, order);
  builder.dimension().block(4, 4);
  for (int i = 0; i < 4; ++i) builder.reals({i == 1 ? 1. : 0., i == 2 ? 1. : 0., i == 3 ? 1. : 0.}).integer(i + 10);
  return builder;
}

std::string one_tet(int version, std::endian order) {
  return with_vertices(version, order)
      .block(8, 1)
      .integers({1, 2, 3, 4, -6})
      .block(6, 2)
      .integers({1, 2, 3, 5, 2, 3, 4, 6})
      .block(17, 1)
      .integer(2)
      .end();
}

std::string error_of(const std::string& content) {
  return message_of<InputError>([&] { (void)binary_mesh(content); });
}

class EveryBinary : public testing::TestWithParam<std::tuple<int, std::endian>> {};

TEST_P(EveryBinary, IsRead) {
  const auto [version, order] = GetParam();
  const Mesh mesh = binary_mesh(one_tet(version, order));
  EXPECT_EQ(mesh.points, (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  EXPECT_EQ(mesh.point_refs, (std::vector<int>{10, 11, 12, 13}));
  EXPECT_EQ(mesh.tetrahedra, (std::vector<std::array<Index, 4>>{{0, 1, 2, 3}}));
  EXPECT_EQ(mesh.tetrahedron_refs, std::vector<int>{-6});
  EXPECT_EQ(mesh.triangles, (std::vector<std::array<Index, 3>>{{0, 1, 2}, {1, 2, 3}}));
  EXPECT_EQ(mesh.triangle_refs, (std::vector<int>{5, 6}));
  EXPECT_EQ(mesh.required_triangles, std::vector<Index>{1});
  EXPECT_TRUE(mesh.edges.empty());
}

INSTANTIATE_TEST_SUITE_P(Gmf, EveryBinary,
                         testing::Combine(testing::Values(1, 2, 3, 4),
                                          testing::Values(std::endian::little, std::endian::big)));

TEST(ReadBinary, PassesOverUnknownKeywordsInAnyOrder) {
  const std::string content = GmfBuilder(3)
                                  .block(60, 1)
                                  .reals({0, 0, 1})
                                  .block(8, 1)
                                  .integers({4, 3, 2, 1, 0})
                                  .keyword(4711)
                                  .dimension()
                                  .block(4, 4)
                                  .reals({0, 0, 0})
                                  .integer(0)
                                  .reals({1, 0, 0})
                                  .integer(0)
                                  .reals({0, 1, 0})
                                  .integer(0)
                                  .reals({0, 0, 1})
                                  .integer(0)
                                  .end();
  EXPECT_EQ(binary_mesh(content).tetrahedra, (std::vector<std::array<Index, 4>>{{3, 2, 1, 0}}));
}

TEST(ReadBinary, NeedsNoEndKeyword) {
  const std::string whole = one_tet(2, std::endian::little);
  EXPECT_EQ(binary_mesh(whole.substr(0, whole.size() - 8)).tetrahedra.size(), 1U);
  const std::string bare_end = whole.substr(0, whole.size() - 4);
  EXPECT_EQ(binary_mesh(bare_end).tetrahedra.size(), 1U);
  EXPECT_NE(error_of(bare_end.substr(0, bare_end.size() - 1)).find("keyword expected, the file is truncated"),
            std::string::npos);
  const std::string last = with_vertices().block(8, 1).integers({1, 2, 3, 4, 0}).bytes();
  EXPECT_EQ(binary_mesh(last).tetrahedra.size(), 1U);
}

TEST(ReadBinary, ToleratesPaddingAndForeignElementsThatAreNone) {
  const std::string content =
      with_vertices().block(10, 0).block(7, 0).block(8, 1).integers({1, 2, 3, 4, 0}).word(-1).word(-1).end();
  EXPECT_EQ(binary_mesh(content).tetrahedra.size(), 1U);
}

TEST(ReadBinary, NamesTheEntityOfAnIndexOutOfRange) {
  const auto with = [](std::vector<std::int64_t> second) {
    return error_of(with_vertices().block(8, 2).integers({1, 2, 3, 4, 0}).integers(second).end());
  };
  EXPECT_EQ(with({1, 2, 3, 5, 0}), "wing.meshb: Tetrahedra 2: vertex 5 found, expected 1..4");
  EXPECT_EQ(with({0, 2, 3, 4, 0}), "wing.meshb: Tetrahedra 2: vertex 0 found, expected 1..4");
  EXPECT_EQ(with({-7, 2, 3, 4, 0}), "wing.meshb: Tetrahedra 2: vertex -7 found, expected 1..4");
}

TEST(ReadBinary, NamesTheEntityOfAListedIndexOutOfRange) {
  const auto with = [](int code) {
    return error_of(with_vertices().block(8, 1).integers({1, 2, 3, 4, 0}).block(code, 1).integer(9).end());
  };
  EXPECT_EQ(with(13), "wing.meshb: Corners 1: vertex 9 found, expected 1..4");
  EXPECT_EQ(with(15), "wing.meshb: RequiredVertices 1: vertex 9 found, expected 1..4");
  EXPECT_EQ(with(14), "wing.meshb: Ridges 1: edge 9 found, but the file has no edge");
  EXPECT_EQ(with(16), "wing.meshb: RequiredEdges 1: edge 9 found, but the file has no edge");
  EXPECT_EQ(with(17), "wing.meshb: RequiredTriangles 1: triangle 9 found, but the file has no triangle");
  EXPECT_EQ(with(12), "wing.meshb: RequiredTetrahedra 1: tetrahedron 9 found, expected 1..1");
}

TEST(ReadBinary, RefusesReferencesBeyond32Bits) {
  const std::string content = with_vertices(4).block(8, 1).integers({1, 2, 3, 4, std::int64_t{1} << 31}).end();
  EXPECT_EQ(error_of(content), "wing.meshb: Tetrahedra 1: reference 2147483648 found, expected a 32-bit number");
}

TEST(ReadBinary, RefusesCoordinatesThatAreNotFinite) {
  for (const double bad : {std::nan(""), HUGE_VAL}) {
    const std::string content = GmfBuilder(2).dimension().block(4, 1).reals({0, bad, 0}).integer(0).block(8, 0).end();
    EXPECT_EQ(error_of(content), "wing.meshb: Vertices 1: finite number expected, found infinity or not-a-number");
  }
}

TEST(ReadBinary, RefusesOtherElementsAndDimensions) {
  for (const auto& [code, name] :
       {std::pair{7, "Quadrilaterals"}, {9, "Prisms"}, {10, "Hexahedra"}, {49, "Pyramids"}}) {
    const std::string content = with_vertices().block(8, 0).block(code, 1).integers({1, 2, 3, 4, 0, 0, 0, 0, 0}).end();
    EXPECT_EQ(error_of(content),
              fmt::format("wing.meshb: {}: 1 found, but taut takes tetrahedra, triangles and edges only", name));
  }
  EXPECT_EQ(error_of(GmfBuilder(2).dimension(2).block(4, 0).block(8, 0).end()),
            "wing.meshb: Dimension: 2 found, expected 3: taut takes tetrahedra in three dimensions");
}

TEST(ReadBinary, NamesAMissingKeyword) {
  EXPECT_EQ(error_of(GmfBuilder(2).block(4, 0).block(8, 0).end()), "wing.meshb: keyword Dimension expected, not found");
  EXPECT_EQ(error_of(GmfBuilder(2).dimension().block(8, 0).end()), "wing.meshb: keyword Vertices expected, not found");
  EXPECT_EQ(error_of(with_vertices().end()), "wing.meshb: keyword Tetrahedra expected, not found");
}

TEST(ReadBinary, RefusesWhatIsNoGmfFile) {
  EXPECT_EQ(error_of("\1"), "wing.meshb: too short for a binary Gamma Mesh Format file");
  EXPECT_EQ(error_of("\1\2\3\4\5\6\7\10"), "wing.meshb: not a binary Gamma Mesh Format file: it does not begin with 1");
  EXPECT_EQ(error_of(GmfBuilder(5).end()), "wing.meshb: version 5 found, expected 1..4");
  EXPECT_EQ(error_of(GmfBuilder(0).end()), "wing.meshb: version 0 found, expected 1..4");
}

TEST(ReadBinary, RefusesAbsurdCountsBeforeItTakesMemory) {
  EXPECT_EQ(error_of(with_vertices().block(8, 2000000000).integers({1, 2, 3, 4, 0}).end()),
            "wing.meshb: Tetrahedra: 2000000000 entries announced, but only 20 bytes follow");
  EXPECT_EQ(error_of(with_vertices().block(8, -3).end()),
            "wing.meshb: Tetrahedra: -3 entries announced, expected 0..4294967294");
  EXPECT_EQ(error_of(with_vertices(4).block(8, std::int64_t{1} << 60).end()),
            "wing.meshb: Tetrahedra: 1152921504606846976 entries announced, expected 0..4294967294");
}

TEST(ReadBinary, RefusesPositionsThatDoNotGrow) {
  EXPECT_EQ(error_of(GmfBuilder(2).dimension().next(8).block(4, 0).end()),
            "wing.meshb: byte 8: next keyword at 8 found, expected 0 or 16..40");
  EXPECT_EQ(error_of(GmfBuilder(3).dimension().next(-1).block(4, 0).end()),
            "wing.meshb: byte 8: next keyword at -1 found, expected 0 or 20..52");
  EXPECT_EQ(error_of(GmfBuilder(2).dimension().next(1000).block(4, 0).end()),
            "wing.meshb: byte 8: next keyword at 1000 found, expected 0 or 16..40");
}

TEST(ReadBinary, RefusesAKeywordThatComesTwice) {
  EXPECT_EQ(error_of(GmfBuilder(2).dimension().block(4, 0).block(4, 0).block(8, 0).end()),
            "wing.meshb: byte 40: keyword Vertices found a second time");
}

TEST(ReadBinary, RefusesABlockThatEndsBeforeItsCount) {
  EXPECT_EQ(error_of(GmfBuilder(2).dimension().keyword(4).block(8, 0).end()),
            "wing.meshb: Vertices: truncated before its first entry");
}

TEST(ReadBinary, ReadsTheSameFromDisk) {
  const std::filesystem::path path = std::filesystem::path(TAUT_TEST_DATA) / "two_tets.meshb";
  expect_equal(read_mesh(path), two_tets());
}

}  // namespace
}  // namespace taut::test
