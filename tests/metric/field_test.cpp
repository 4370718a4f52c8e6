#include "metric/field.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "metric/spectral.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

const Mesh mesh = [] {
  Mesh m;
  m.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  return m;
}();

std::string complaint(const Metric& metric) {
  try {
    (void)tensors_at(mesh, metric);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Field, SizesBecomeTensors) {
  EXPECT_EQ(tensors_at(mesh, Sizes{1, 2, 0.5}),
            (std::vector<Sym3>{metric_of_size(1), metric_of_size(2), metric_of_size(0.5)}));
}

TEST(Field, TensorsAreTakenAsTheyAre) {
  const Tensors tensors = {identity3, {2, 1, 0, 2, 0, 2}, identity3};
  EXPECT_EQ(tensors_at(mesh, tensors), tensors);
}

TEST(Field, FunctionsAreCalledAtThePoints) {
  const MetricFunction f = [](const Point& x) { return metric_of_size(1 + x[0] + 2 * x[1]); };
  EXPECT_EQ(tensors_at(mesh, f), (std::vector<Sym3>{metric_of_size(1), metric_of_size(2), metric_of_size(3)}));
}

TEST(Field, BadValuesAreRefusedNamingTheVertex) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_NE(complaint(Sizes{1, 2}).find("2 values for 3 vertices"), std::string::npos);
  for (const double h : {0.0, -1.0, nan, inf, -inf, 1e-200, 1e200})
    EXPECT_NE(complaint(Sizes{1, 2, h}).find("vertex 3:"), std::string::npos) << h;
  EXPECT_NE(complaint(Tensors{identity3, {1, 2, 0, 1, 0, 1}, identity3}).find("vertex 2:"), std::string::npos);
  EXPECT_NE(complaint(Tensors{identity3, identity3, {1, nan, 0, 1, 0, 1}}).find("vertex 3:"), std::string::npos);
  EXPECT_NE(complaint(Tensors{identity3}).find("1 values"), std::string::npos);
  EXPECT_NE(complaint([](const Point& x) { return (1 - x[0]) * identity3; }).find("vertex 2 at ("), std::string::npos);
  EXPECT_NE(complaint(MetricFunction{}).find("empty function"), std::string::npos);
}

}  // namespace
}  // namespace taut
