// Input that cannot be used, and interpolation by hosts.
#include <gtest/gtest.h>

#include "base/with_threads.hpp"
#include "transfer/meshes.hpp"

namespace taut {
namespace {

class TransferInput : public testing::Test {
protected:
  Mesh from = test::cube(2), to = test::cube(3);
  std::vector<Field> fields = {test::sampled_field(from, test::linear_function)};
  TransferOptions options;

  void expect_refused(const std::string& start) {
    for (const Transfer method : {Transfer::linear, Transfer::conservative}) {
      options.method = method;
      const std::string message = test::refusal(2, [&] { return transfer(from, fields, to, options); });
      EXPECT_TRUE(message.starts_with(start)) << message;
    }
  }
};

TEST_F(TransferInput, NoFields) {
  fields.clear();
  expect_refused("fields: none found");
}

TEST_F(TransferInput, WrongNumberOfValues) {
  fields.push_back({Field::Kind::vector, std::vector<double>(80, 1.0)});
  expect_refused("fields: field 2: 80 values found, expected 3 for each of 27 vertices");
}

TEST_F(TransferInput, ValuesThatAreNotFinite) {
  fields.push_back({Field::Kind::vector, std::vector<double>(81, 1.0)});
  fields[1].values[3 * 4 + 1] = std::nan("");
  fields[1].values[3 * 6] = std::numeric_limits<double>::infinity();
  expect_refused("fields: field 2: vertex 5, component 2: nan found, expected a finite number");
}

TEST_F(TransferInput, MeshesThatCannotBeUsed) {
  to.points[4][1] = std::nan("");
  expect_refused("target: vertex 5: coordinate nan is not finite");
  to = test::cube(3);
  to.tetrahedra[2][1] = 100;
  expect_refused("target: tetrahedron 3: vertex 101 found, expected 1..64");
  to = test::cube(3);
  from.tetrahedra[0][1] = from.tetrahedra[0][0];
  expect_refused("tetrahedron 1 (1 1");
}

TEST_F(TransferInput, Threads) {
  options.threads = -1;
  expect_refused("-1 threads found");
}

TEST(Interpolate, ByTheHostsOfAnAdaptation) {
  const Mesh from = test::shaken_cube(4, 1);
  const AdaptResult adapted = adapt(from, test::front(0.3, 0.6), {.max_rounds = 4});
  Field vector{Field::Kind::vector, {}};
  for (const Point& p : from.points) vector.values.insert(vector.values.end(), {p[0], p[1], 2 * p[2]});
  const auto fields = interpolate(from, {test::sampled_field(from, test::linear_function), vector}, adapted.hosts);
  EXPECT_LT(test::largest_error(adapted.mesh, fields[0], test::linear_function), 1e-13);
  for (std::size_t i = 0; i < adapted.mesh.points.size(); ++i)
    EXPECT_NEAR(fields[1].values[3 * i + 2], 2 * adapted.mesh.points[i][2], 1e-13);
}

TEST(Interpolate, RefusesWhatDoesNotFit) {
  const Mesh from = test::cube(2);
  const std::vector<Field> fields = {test::sampled_field(from, test::linear_function)};
  const auto message = [&](const std::vector<Field>& f, const std::vector<Host>& hosts) {
    return test::refusal(1, [&] { return interpolate(from, f, hosts); });
  };
  EXPECT_EQ(message(fields, {Host{0, {1, 0, 0, 0}}, Host{48, {1, 0, 0, 0}}}),
            "host 2: tetrahedron 49 found, expected 1..48");
  EXPECT_EQ(message({}, {}), "fields: none found, expected at least one");
}

}  // namespace
}  // namespace taut
