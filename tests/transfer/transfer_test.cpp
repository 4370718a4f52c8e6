// What holds for every transfer, whatever the meshes.
#include <gtest/gtest.h>
#include "transfer/meshes.hpp"
namespace taut {
namespace {
TEST(Transfer, Smoke) {
  Mesh a = test::cube(6), b = test::cube(7);
  test::jitter(a, 0.03, 1);
  test::jitter(b, 0.03, 2);
  const auto f = [](const Point& p) { return 1 + 2 * p[0] - 3 * p[1] + 0.5 * p[2]; };
  Field u;
  for (auto& p : a.points) u.values.push_back(f(p));
  for (auto m : {Transfer::linear, Transfer::conservative}) {
    auto r = transfer(a, {u}, b, {.method = m});
    double worst = 0;
    for (size_t i = 0; i < b.points.size(); ++i)
      worst = std::max(worst, std::abs(r.fields[0].values[i] - f(b.points[i])));
    auto& c = r.report.fields[0][0];
    printf("worst %g outside %zu %g overlaps %zu covered %.17g mass %.17g %.17g\n", worst, r.report.outside,
           r.report.distance_max, r.report.overlaps, r.report.covered_volume.value_or(0), c.mass_before, c.mass_after);
    for (auto& [n, s] : r.report.seconds) printf("  %s %g\n", n.c_str(), s);
  }
}
}  // namespace
}  // namespace taut
