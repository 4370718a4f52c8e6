#include "locate/triangle_tree.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <random>

#include "base/with_threads.hpp"
#include "locate/closest_on_triangle.hpp"

namespace taut {
namespace {

using Triangles = std::vector<std::array<Index, 3>>;

struct Soup {
  std::vector<Vec3> points;
  Triangles triangles;
};

class Random {
public:
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }
  Vec3 point(double half) { return {number(-half, half), number(-half, half), number(-half, half)}; }
  Index index(std::size_t count) { return static_cast<Index>(number(0, static_cast<double>(count) - 0.5)); }

private:
  std::mt19937 generator_{7};
};

/// Triangles of this size at random places; they share vertices if there are few points.
Soup scattered(std::size_t count, double size) {
  Random random;
  Soup soup;
  for (std::size_t t = 0; t < count; ++t) {
    const Vec3 centre = random.point(1);
    const auto first = static_cast<Index>(soup.points.size());
    for (int k = 0; k < 3; ++k) soup.points.push_back(centre + random.point(size));
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

TriangleTree::Nearest by_trying_all(const Soup& soup, const Vec3& x) {
  TriangleTree::Nearest best;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    const auto& [a, b, c] = soup.triangles[t];
    const OnTriangle at = closest_on_triangle(x, {soup.points[a], soup.points[b], soup.points[c]});
    if (t == 0 || at.squared_distance < best.squared_distance)
      best = {static_cast<Index>(t), at.point, at.weights, at.squared_distance};
  }
  return best;
}

void expect_equal(const TriangleTree::Nearest& a, const TriangleTree::Nearest& b) {
  EXPECT_EQ(a.triangle, b.triangle);
  EXPECT_EQ(a.point, b.point);
  EXPECT_EQ(a.weights, b.weights);
  EXPECT_EQ(a.squared_distance, b.squared_distance);
}

void expect_as_by_trying_all(const Soup& soup, const std::vector<Vec3>& places) {
  const TriangleTree tree(soup.points, soup.triangles);
  Random random;
  for (const Vec3& x : places) {
    const auto expected = by_trying_all(soup, x);
    expect_equal(tree.closest(x), expected);
    expect_equal(tree.closest(x, random.index(soup.triangles.size())), expected);
  }
}

std::vector<Vec3> places(std::size_t count, double half) {
  Random random;
  std::vector<Vec3> list(count);
  for (Vec3& x : list) x = random.point(half);
  return list;
}

TEST(TriangleTree, FindsWhatTryingAllFinds) {
  for (const std::size_t count : {1, 2, 4, 5, 8, 9, 33, 1000})
    for (const double size : {1e-3, 0.1, 2.0}) expect_as_by_trying_all(scattered(count, size), places(100, 1.5));
}

TEST(TriangleTree, OnTheTrianglesThemselves) {
  const Soup soup = scattered(300, 0.3);
  expect_as_by_trying_all(soup, soup.points);
}

// Every vertex of a closed surface is equally close to all triangles around it.
TEST(TriangleTree, TheFirstOfSeveralAtTheSameDistance) {
  Soup soup;
  for (Index i = 0; i <= 20; ++i)
    for (Index j = 0; j <= 20; ++j) soup.points.push_back({i / 20.0, j / 20.0, 0});
  for (Index i = 0; i < 20; ++i)
    for (Index j = 0; j < 20; ++j) {
      const Index a = 21 * i + j;
      soup.triangles.push_back({a, a + 21, a + 22});
      soup.triangles.push_back({a, a + 22, a + 1});
    }
  std::vector<Vec3> above = soup.points;
  for (Vec3& x : above) x[2] = 0.25;
  expect_as_by_trying_all(soup, soup.points);
  expect_as_by_trying_all(soup, above);
}

TEST(TriangleTree, ManyTimesTheSameTriangle) {
  Soup soup = scattered(1, 1);
  soup.triangles.resize(100, soup.triangles[0]);
  for (const Vec3& x : places(20, 2)) EXPECT_EQ(TriangleTree(soup.points, soup.triangles).closest(x, 60).triangle, 0U);
}

TEST(TriangleTree, FlatTrianglesAndSinglePoints) {
  Soup soup = scattered(200, 0.2);
  for (std::size_t t = 0; t < 200; ++t) {
    const auto& [a, b, c] = soup.triangles[t];
    if (t % 2 == 0) soup.points[c] = 0.5 * (soup.points[a] + soup.points[b]);
    if (t % 4 == 0) soup.points[b] = soup.points[c] = soup.points[a];
  }
  expect_as_by_trying_all(soup, places(200, 1.5));
}

TEST(TriangleTree, IsTheSameOnAnyNumberOfThreads) {
  const Soup soup = scattered(40000, 0.02);
  const auto find = [&] {
    const TriangleTree tree(soup.points, soup.triangles);
    std::vector<Vec3> found;
    for (const Vec3& x : places(500, 1.2)) found.push_back(tree.closest(x).point);
    return found;
  };
  EXPECT_EQ(test::with_threads(1, find), test::with_threads(3, find));
}

const std::array<Vec3, 3> right_angle = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};

struct Region {
  Vec3 x, closest;
};

// Inside, at each corner, along each edge.
constexpr Region regions[] = {
    {{0.25, 0.25, 3}, {0.25, 0.25, 0}},
    {{-1, -2, 1}, {0, 0, 0}},
    {{3, -1, 1}, {1, 0, 0}},
    {{-1, 3, 1}, {0, 1, 0}},
    {{0.25, -1, -1}, {0.25, 0, 0}},
    {{1, 1, 1}, {0.5, 0.5, 0}},
    {{-1, 0.75, 2}, {0, 0.75, 0}},
    {{0.25, 0.5, 0}, {0.25, 0.5, 0}},
};

TEST(ClosestOnTriangle, InEveryRegion) {
  for (const auto& [x, closest] : regions) {
    const OnTriangle at = closest_on_triangle(x, right_angle);
    EXPECT_LT(norm(at.point - closest), 1e-15);
    EXPECT_NEAR(at.squared_distance, dot(x - closest, x - closest), 1e-14);
  }
}

TEST(ClosestOnTriangle, WeightsGiveThePoint) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const std::array<Vec3, 3> v = {random.point(1), random.point(1), random.point(1)};
    const auto [point, w, squared_distance] = closest_on_triangle(random.point(2), v);
    EXPECT_LT(norm(w[0] * v[0] + w[1] * v[1] + w[2] * v[2] - point), 1e-14);
    EXPECT_NEAR(w[0] + w[1] + w[2], 1, 1e-14);
    for (const double weight : w) EXPECT_GE(weight, 0);
  }
}

// Nothing on the triangle is closer: compared with a fine lattice on it.
TEST(ClosestOnTriangle, NothingIsCloser) {
  Random random;
  constexpr int n = 40;
  for (int i = 0; i < 200; ++i) {
    const double height = std::pow(10.0, -random.number(0, 12));  // from fair triangles to almost flat ones
    const Vec3 a = random.point(1), b = random.point(1);
    const std::array<Vec3, 3> v = {a, b, a + random.number(0, 1) * (b - a) + height * random.point(1)};
    const Vec3 x = random.point(1);
    const double distance = std::sqrt(closest_on_triangle(x, v).squared_distance);
    for (int p = 0; p <= n; ++p)
      for (int q = 0; p + q <= n; ++q) {
        const Vec3 y = v[0] + (1.0 * p / n) * (v[1] - v[0]) + (1.0 * q / n) * (v[2] - v[0]);
        EXPECT_LE(distance, norm(x - y) + 1e-13);
      }
  }
}

/// Each triangle stands for something that is farther than it or nearer, by at most its slack.
TEST(TriangleTree, SearchesWhatTrianglesStandFor) {
  for (const double most : {0.0, 0.05, 3.0}) {  // with 3 there are more candidates than are kept
    const Soup soup = scattered(300, 0.2);
    Random random;
    std::vector<double> slack, off;
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
      slack.push_back(random.number(0, most));
      off.push_back(random.number(-1, 1) * slack.back());
    }
    const TriangleTree tree(soup.points, soup.triangles, slack);
    const auto distance = [&](Index t, double flat) { return std::abs(flat + off[t]); };
    for (int i = 0; i < 200; ++i) {
      const Vec3 x = random.point(1.5);
      double expected = std::numeric_limits<double>::infinity();
      for (Index t = 0; t < soup.triangles.size(); ++t) {
        const auto& [a, b, c] = soup.triangles[t];
        const OnTriangle at = closest_on_triangle(x, {soup.points[a], soup.points[b], soup.points[c]});
        expected = std::min(expected, distance(t, std::sqrt(at.squared_distance)));
      }
      const auto found = [&](std::optional<Index> guess, double bound) {
        double least = std::numeric_limits<double>::infinity();
        tree.search(x, guess, bound, [&](Index t, const OnTriangle& at) {
          const double here = distance(t, std::sqrt(at.squared_distance));
          least = std::min(least, here);
          return here;
        });
        return least;
      };
      EXPECT_EQ(found(std::nullopt, std::numeric_limits<double>::infinity()), expected);
      EXPECT_EQ(found(random.index(soup.triangles.size()), std::numeric_limits<double>::infinity()), expected);
      EXPECT_EQ(found(std::nullopt, expected + 0.1), expected);
      EXPECT_GE(found(std::nullopt, 0.9 * expected), expected);
    }
  }
}

}  // namespace
}  // namespace taut
