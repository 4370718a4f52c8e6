// What holds for every transfer, whatever the meshes.
#include <gtest/gtest.h>

#include "transfer/meshes.hpp"

namespace taut {
namespace {

class AnyTransfer : public testing::TestWithParam<std::tuple<std::size_t, Transfer>> {
protected:
  const Mesh from = test::pairs()[std::get<0>(GetParam())].from();
  const Mesh to = test::pairs()[std::get<0>(GetParam())].to();
  const Transfer method = std::get<1>(GetParam());

  [[nodiscard]] Transferred transferred(const std::vector<Field>& fields) const {
    return transfer(from, fields, to, {.method = method});
  }
};

std::string name_of(const testing::TestParamInfo<AnyTransfer::ParamType>& info) {
  return std::string(test::pairs()[std::get<0>(info.param)].name) +
         (std::get<1>(info.param) == Transfer::linear ? "_linear" : "_conservative");
}

INSTANTIATE_TEST_SUITE_P(Pairs, AnyTransfer,
                         testing::Combine(testing::Range(std::size_t{0}, test::pairs().size()),
                                          testing::Values(Transfer::linear, Transfer::conservative)),
                         name_of);

TEST_P(AnyTransfer, KeepsLinearFields) {
  const Transferred result = transferred({test::sampled_field(from, test::linear_function)});
  EXPECT_LT(test::largest_error(to, result.fields[0], test::linear_function), 4e-13);  // the range is 5.5
  EXPECT_EQ(result.report.outside, 0);
}

TEST_P(AnyTransfer, KeepsConstants) {
  const auto constant = [](const Point&) { return 0.1; };
  const Transferred result = transferred({test::sampled_field(from, constant)});
  EXPECT_EQ(test::largest_error(to, result.fields[0], constant), 0);
}

TEST_P(AnyTransfer, MakesNoNewExtremum) {
  const Transferred result = transferred({test::sampled_field(from, test::step_function)});
  for (const double u : result.fields[0].values) {
    EXPECT_GE(u, 0);
    EXPECT_LE(u, 1);
  }
}

TEST_P(AnyTransfer, ReportsWhatItDid) {
  const TransferReport report = transferred({test::sampled_field(from, test::smooth_function)}).report;
  const double volume = test::volume_of(from);
  EXPECT_NEAR(report.volume_before, volume, 1e-12);
  EXPECT_NEAR(report.volume_after, volume, 1e-12);
  const ComponentReport& u = report.fields.at(0).at(0);
  EXPECT_GE(u.least_after, u.least_before);
  EXPECT_LE(u.greatest_after, u.greatest_before);
  if (method == Transfer::linear) return;
  EXPECT_NEAR(u.mass_after, u.mass_before, 1e-12 * u.mass_before);
  EXPECT_NEAR(report.covered_volume.value(), volume, 1e-12);
  EXPECT_GT(report.overlaps, to.tetrahedra.size() / 2);
}

TEST_P(AnyTransfer, TreatsComponentsAlike) {
  Field vector{Field::Kind::vector, {}}, tensor{Field::Kind::tensor, {}};
  for (const Point& p : from.points) {
    for (std::size_t c = 0; c < 3; ++c) vector.values.push_back(std::sin(3 * p[c]));
    for (std::size_t c = 0; c < 6; ++c) tensor.values.push_back(std::cos(3 * p[c % 3] + static_cast<double>(c)));
  }
  const auto both = transferred({vector, tensor}).fields;
  const auto component = [&](const Field& field, std::size_t c) {
    Field scalar;
    for (std::size_t i = c; i < field.values.size(); i += field.size()) scalar.values.push_back(field.values[i]);
    return scalar;
  };
  ASSERT_EQ(both.size(), 2);
  EXPECT_EQ(both[0].kind, Field::Kind::vector);
  EXPECT_EQ(both[1].kind, Field::Kind::tensor);
  EXPECT_EQ(component(both[0], 1).values, transferred({component(vector, 1)}).fields[0].values);
  EXPECT_EQ(component(both[1], 4).values, transferred({component(tensor, 4)}).fields[0].values);
}

TEST_P(AnyTransfer, GivesTheSameBitsOnAnyNumberOfThreads) {
  const std::vector<Field> fields = {test::sampled_field(from, test::smooth_function)};
  const Transferred one = transfer(from, fields, to, {.method = method, .threads = 1});
  for (const int threads : {2, 3, 8}) {
    const Transferred more = transfer(from, fields, to, {.method = method, .threads = threads});
    EXPECT_EQ(more.fields[0].values, one.fields[0].values);
    EXPECT_EQ(more.report.covered_volume, one.report.covered_volume);
    EXPECT_EQ(more.report.fields[0][0].mass_after, one.report.fields[0][0].mass_after);
  }
}

}  // namespace
}  // namespace taut
