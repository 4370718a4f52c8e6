// Adaptation to the mesh's own metric: sizes and stretching stay, quality is mended.
#include <cmath>

#include "adapt/checks.hpp"
#include "taut/sizing.hpp"

namespace taut {
namespace {

/// Moves each point inside by up to `amount` of its shortest edge, as far as no volume falls below a fiftieth.
Mesh displaced(Mesh mesh, double amount, unsigned seed) {
  const auto volume = [&](std::size_t t) {
    const auto& v = mesh.tetrahedra[t];
    return six_volumes(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]);
  };
  std::vector<std::vector<std::size_t>> tets(mesh.points.size());
  std::vector<double> before, reach(mesh.points.size(), 1e300);
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    before.push_back(volume(t));
    for (const Index p : mesh.tetrahedra[t]) {
      tets[p].push_back(t);
      for (const Index q : mesh.tetrahedra[t])
        if (p != q) reach[p] = std::min(reach[p], norm(mesh.points[p] - mesh.points[q]));
    }
  }
  std::vector<std::uint8_t> stays(mesh.points.size(), 0);
  for (const auto& t : mesh.triangles)
    for (const Index p : t) stays[p] = 1;
  test::Random random(seed);
  for (std::size_t p = 0; p < mesh.points.size(); ++p) {
    const Vec3 old = mesh.points[p];
    Vec3 way = amount * reach[p] * random.point();
    const auto is_valid = [&] {
      return std::ranges::all_of(tets[p], [&](std::size_t t) { return volume(t) > 0.02 * before[t]; });
    };
    if (stays[p] == 1) continue;
    for (int i = 0; i < 6; ++i, way = 0.5 * way) {
      mesh.points[p] = old + way;
      if (is_valid()) break;
      mesh.points[p] = old;
    }
  }
  return mesh;
}

/// Sizes from 1/100 to 1/8, growing along all axes.
Mesh graded_cube() {
  Mesh mesh = test::cube(12);
  for (Point& p : mesh.points)
    for (double& x : p) x = x == 0 || x == 1 ? x : std::expm1(2.5 * x) / std::expm1(2.5);
  return mesh;
}

/// Layers at z = 0 whose height grows by 1.3 each, from 1/70 of their width.
Mesh layers() {
  Mesh mesh = test::grid(8);
  for (Point& p : mesh.points) p[2] = p[2] == 1 ? 1 : (std::pow(1.3, 16 * p[2]) - 1) / (std::pow(1.3, 16) - 1);
  test::add_triangles(mesh);
  return mesh;
}

struct Mended {
  Quality before, after;
  AdaptResult adapted;
};

Mended optimised(const Mesh& mesh) {
  const Tensors metric = implied_metric(mesh);
  AdaptResult adapted = adapt(mesh, metric);
  return {measure(mesh, metric), adapted.report.quality, std::move(adapted)};
}

double share(std::size_t a, std::size_t b) {
  return static_cast<double>(a) / static_cast<double>(b);
}

void expect_mended(const Mended& run) {
  EXPECT_NEAR(share(run.after.tetrahedra, run.before.tetrahedra), 1, 0.15);
  EXPECT_NEAR(share(run.after.vertices, run.before.vertices), 1, 0.15);
  EXPECT_GT(run.after.mean_ratio_min, std::max(0.3, run.before.mean_ratio_min));
  EXPECT_GT(run.after.mean_ratio_mean, std::max(0.8, run.before.mean_ratio_mean));
  EXPECT_LT(run.after.Q_max, std::min(5.0, run.before.Q_max));
}

TEST(OwnSizes, MendADisplacedGrid) {
  const Mesh mesh = displaced(test::cube(10), 0.6, 1);
  const Mended run = optimised(mesh);
  EXPECT_LT(run.before.mean_ratio_min, 0.15);
  expect_mended(run);
  const Metric any = [](const Point&) { return metric_of_size(1); };
  const Quality before = measure(mesh, any), after = measure(run.adapted.mesh, any);  // as the eye sees it
  EXPECT_GT(after.mean_ratio_min, before.mean_ratio_min);
  EXPECT_GT(after.mean_ratio_mean, before.mean_ratio_mean + 0.1);
}

TEST(OwnSizes, MendStretchedLayersAndKeepThem) {
  const Mesh mesh = displaced(layers(), 0.6, 2);
  const Mended run = optimised(mesh);
  expect_mended(run);
  // The lowest points above the wall are as high as they were.
  const auto mean_height = [](const Mesh& of) {
    double sum = 0, count = 0;
    for (const auto& t : of.tetrahedra) {
      const auto at_wall = std::ranges::count_if(t, [&](Index p) { return of.points[p][2] == 0; });
      if (at_wall != 3) continue;
      for (const Index p : t) sum += of.points[p][2];
      ++count;
    }
    return sum / count;
  };
  EXPECT_NEAR(mean_height(run.adapted.mesh) / mean_height(mesh), 1, 0.25);
}

TEST(OwnSizes, KeepTheGradingOfAMesh) {
  for (const double amount : {0.0, 0.5}) {
    const Mesh mesh = displaced(graded_cube(), amount, 3);
    const Mended run = optimised(mesh);
    EXPECT_NEAR(share(run.after.tetrahedra, run.before.tetrahedra), 1, 0.15);
    // The mean length of the edges in each eighth of the diagonal.
    const auto lengths = [](const Mesh& of) {
      std::array<double, 8> sum{}, count{};
      for (const auto& t : of.tetrahedra)
        for (int i = 0; i < 4; ++i)
          for (int j = 0; j < i; ++j) {
            const Vec3 middle = 0.5 * (of.points[t[i]] + of.points[t[j]]);
            const auto bin = static_cast<std::size_t>(std::min(7.0, (middle[0] + middle[1] + middle[2]) / 3 * 8));
            sum[bin] += norm(of.points[t[i]] - of.points[t[j]]);
            ++count[bin];
          }
      for (std::size_t b = 0; b < 8; ++b) sum[b] /= count[b];
      return sum;
    };
    const auto before = lengths(mesh), after = lengths(run.adapted.mesh);
    for (std::size_t b = 0; b < 8; ++b) EXPECT_NEAR(after[b] / before[b], 1, 0.15) << b;
    EXPECT_LT(before[0], 0.6 * before[7]);
  }
}

TEST(OwnSizes, LeaveAGoodMeshAboutAsItIs) {
  const Mesh good = adapt(test::ball(test::cube(6)), Sizes(343, 0.25)).mesh;
  const Mended run = optimised(good);
  EXPECT_NEAR(share(run.after.tetrahedra, run.before.tetrahedra), 1, 0.1);
  EXPECT_GT(run.after.mean_ratio_mean, run.before.mean_ratio_mean);
}

}  // namespace
}  // namespace taut
