// Fields and metrics: the order of tensors, all versions, and what is refused.
#include <cmath>

#include <limits>

#include "io/gmf_builder.hpp"
#include "taut/threads.hpp"

namespace taut::test {
namespace {

constexpr const char* head = "MeshVersionFormatted 2\nDimension 3\n";

std::string text_error(const std::string& rest) {
  return message_of<InputError>([&] { (void)gmf::read_fields(text_file(head + rest)); });
}
std::string metric_error(const std::string& rest) {
  return message_of<InputError>([&] { (void)gmf::read_metric(text_file(head + rest)); });
}

class EverySolution : public testing::TestWithParam<std::tuple<int, std::endian>> {};

TEST_P(EverySolution, HasItsTensorsReordered) {
  const auto [version, order] = GetParam();
  // In the file xx, xy, yy, xz, yz, zz.
  const std::string content = GmfBuilder(version, order)
                                  .dimension()
                                  .block(62, 2)
                                  .word(1)
                                  .word(3)
                                  .reals({11, 12, 22, 13, 23, 33})
                                  .reals({1, 2, 3, 4, 5, 6})
                                  .end();
  const Metric metric = gmf::read_metric(binary_file(content));
  ASSERT_TRUE(std::holds_alternative<Tensors>(metric));
  EXPECT_EQ(std::get<Tensors>(metric), (Tensors{{11, 12, 13, 22, 23, 33}, {1, 2, 4, 3, 5, 6}}));
}

TEST_P(EverySolution, MayHaveSeveralFields) {
  const auto [version, order] = GetParam();
  GmfBuilder builder(version, order);
  builder.dimension().block(62, 2).word(3).word(2).word(3).word(1);
  for (const double vertex : {100., 200.}) {
    for (int i = 0; i < 10; ++i) builder.real(vertex + i);
  }
  const std::vector<Field> fields = gmf::read_fields(binary_file(builder.end()));
  ASSERT_EQ(fields.size(), 3U);
  EXPECT_EQ(fields[0].kind, Field::Kind::vector);
  EXPECT_EQ(fields[0].values, (std::vector<double>{100, 101, 102, 200, 201, 202}));
  EXPECT_EQ(fields[1].kind, Field::Kind::tensor);
  EXPECT_EQ(fields[1].values, (std::vector<double>{103, 104, 106, 105, 107, 108, 203, 204, 206, 205, 207, 208}));
  EXPECT_EQ(fields[2].kind, Field::Kind::scalar);
  EXPECT_EQ(fields[2].values, (std::vector<double>{109, 209}));
}

INSTANTIATE_TEST_SUITE_P(Gmf, EverySolution,
                         testing::Combine(testing::Values(1, 2, 3, 4),
                                          testing::Values(std::endian::little, std::endian::big)));

TEST(Solution, IsReadFromText) {
  const std::vector<Field> fields = gmf::read_fields(text_file(
      "MeshVersionFormatted 1 Dimension\n3\nSolAtVertices\n2\n2 1 3\n\n7 1 2 3 4 5 6\n8\n11 12 22 13 23 33 End"));
  ASSERT_EQ(fields.size(), 2U);
  EXPECT_EQ(fields[0].values, (std::vector<double>{7, 8}));
  EXPECT_EQ(fields[1].values, (std::vector<double>{1, 2, 4, 3, 5, 6, 11, 12, 13, 22, 23, 33}));
}

TEST(Solution, MayBeWrittenByFortran) {
  const std::vector<Field> fields = gmf::read_fields(text_file(
      std::string(head) + "SolAtVertices\r\n 2\r\n 1 1\r\n  +0.5000000000000000D+00\r\n   .1000000000000000-102\r\n"));
  EXPECT_EQ(fields[0].values, (std::vector<double>{0.5, 1e-103}));
}

TEST(Solution, EncodingIsSeenFromTheContent) {
  const std::filesystem::path data = TAUT_TEST_DATA;
  const auto metric_in = [&](const char* name) {
    return std::get<Tensors>(gmf::read_metric(gmf::parse("wing", gmf::copy_of(content_of(data / name)))));
  };
  EXPECT_EQ(metric_in("two_tets.sol"), metric_in("two_tets.solb"));
}

TEST(Solution, IsWrittenInTheOrderOfTheFile) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "taut-order.sol";
  write_solution(path, {{.kind = Field::Kind::tensor, .values = {11, 12, 13, 22, 23, 33}}});
  EXPECT_EQ(content_of(path),
            "MeshVersionFormatted 2\nDimension 3\n\nSolAtVertices\n1\n1 3\n11 12 22 13 23 33\n\nEnd\n");
  std::filesystem::remove(path);
}

TEST(Solution, NamesThePlaceOfAnError) {
  EXPECT_EQ(text_error(""), "wing.sol: keyword SolAtVertices expected, not found");
  EXPECT_EQ(text_error("SolAtVertices 2\n1 1\n1.0\n-nan\n"),
            "wing.sol: line 6: SolAtVertices 2: finite number expected, found infinity or not-a-number");
  EXPECT_EQ(text_error("SolAtVertices 2\n1 4\n1 1 1 1 1 1\n"),
            "wing.sol: line 4: SolAtVertices: kind 4 of field 1 found, expected 1 (scalar), 2 (vector) or 3 (tensor)");
  EXPECT_EQ(text_error("SolAtVertices 2\n0\n"),
            "wing.sol: line 4: SolAtVertices: 0 fields found, expected at least one");
  EXPECT_EQ(text_error("SolAtVertices 2000000000\n1 3\n"),
            "wing.sol: line 4: SolAtVertices: 2000000000 entries announced, but only 1 bytes follow before the end of "
            "the file");
  EXPECT_EQ(message_of<InputError>([] {
              (void)gmf::read_fields(binary_file(GmfBuilder(2).dimension().block(62, 1).word(1 << 30).end()));
            }),
            "wing.solb: SolAtVertices: truncated before its first entry");
  EXPECT_EQ(message_of<InputError>([] {
              (void)gmf::read_fields(
                  binary_file(GmfBuilder(2).dimension().block(62, 2).word(1).word(1).reals({1, NAN}).end()));
            }),
            "wing.solb: SolAtVertices 2: finite number expected, found infinity or not-a-number");
}

TEST(Solution, BesideOthersOrTwiceIsRefused) {
  EXPECT_EQ(text_error("SolAtTetrahedra 1 1 1 0.5\n"), "wing.sol: keyword SolAtVertices expected, not found");
  EXPECT_EQ(text_error("SolAtVertices 1 1 1 0.5\nSolAtVertices 1 1 1 0.5\n"),
            "wing.sol: line 4: keyword SolAtVertices found a second time");
}

TEST(Solution, OfTwoDimensionsIsRefused) {
  EXPECT_EQ(message_of<InputError>([] {
              (void)gmf::read_fields(text_file("MeshVersionFormatted 2\nDimension 2\nSolAtVertices 1\n1 3\n1 0 1\n"));
            }),
            "wing.sol: line 2: Dimension: 2 found, expected 3: taut takes tetrahedra in three dimensions");
}

TEST(ReadMetric, TakesSizes) {
  const Metric metric = gmf::read_metric(text_file(std::string(head) + "SolAtVertices 3 1 1 0.5 .25 1"));
  ASSERT_TRUE(std::holds_alternative<Sizes>(metric));
  EXPECT_EQ(std::get<Sizes>(metric), (Sizes{0.5, 0.25, 1}));
}

TEST(ReadMetric, SaysWhatWasFoundInstead) {
  EXPECT_EQ(metric_error("SolAtVertices 1 2 1 3 1 1 0 1 0 0 1"),
            "wing.sol: 2 fields found, a metric is one scalar or one tensor field");
  EXPECT_EQ(metric_error("SolAtVertices 1 1 2 1 0 1"),
            "wing.sol: a vector field found, a metric is one scalar or one tensor field");
}

TEST(ReadMetric, ReadsTheSameFromDisk) {
  const std::filesystem::path data = TAUT_TEST_DATA;
  const Tensors expected = {
      {1, 0.5, 0, 2, 0, 3}, {4, 0, 0.25, 5, 0, 6}, {7, 0, 0, 8, 0.125, 9}, {1, 0, 0, 1, 0, 1}, {1e6, 0, 0, 1, 0, 1e-3}};
  EXPECT_EQ(std::get<Tensors>(read_metric(data / "two_tets.sol")), expected);
  EXPECT_EQ(std::get<Tensors>(read_metric(data / "two_tets.solb")), expected);
}

// Long enough for several threads to read it.
TEST(ReadMetric, OnAnyNumberOfThreads) {
  std::vector<double> sizes(100000);
  for (std::size_t i = 0; i < sizes.size(); ++i) sizes[i] = 1 + static_cast<double>(i);
  const auto file_of = [](const std::vector<double>& values) {
    GmfBuilder builder(2);
    builder.dimension().block(62, static_cast<std::int64_t>(values.size())).word(1).word(1).reals(values);
    return binary_file(builder.end());
  };
  auto spoilt = sizes;
  spoilt[40000] = spoilt[90000] = std::numeric_limits<double>::quiet_NaN();
  for (const int threads : {1, 3}) {
    on_threads(threads, [&] {
      EXPECT_EQ(std::get<Sizes>(gmf::read_metric(file_of(sizes))), sizes);
      EXPECT_EQ(message_of<InputError>([&] { (void)gmf::read_metric(file_of(spoilt)); }),
                "wing.solb: SolAtVertices 40001: finite number expected, found infinity or not-a-number");
    });
  }
}

}  // namespace
}  // namespace taut::test
