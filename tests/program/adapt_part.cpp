// taut adapt with many options at once, on a part from CAD: a ball of region 2 with a surface of reference 7, in a box
// with the sides 8 to 13.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "program/fixture.hpp"
#include "taut/taut.hpp"

namespace taut::test {
namespace {

using nlohmann::json;

constexpr int ball = 7, fine = 8, other = 10;  // references of triangles

double distance(const Point& p, const Point& q) {
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

class ManyOptions : public ProgramTest {
protected:
  ManyOptions() {
    std::filesystem::copy_file(std::filesystem::path(TAUT_TEST_DATA) / "parts" / "ball-in-box.meshb", "part.meshb");
    const auto triangle = part.triangles[static_cast<std::size_t>(std::ranges::find(part.triangle_refs, other) -
                                                                  part.triangle_refs.begin())];
    ridge = {part.points[triangle[0]], part.points[triangle[1]]};
    write("ridge.txt", std::to_string(triangle[0] + 1) + " " + std::to_string(triangle[1] + 1) + "\n");
    write("local.json", R"({"triangles": {"8": {"size": 0.15}, "7": {"deviation": 0.01, "min": 0.03}},
                            "tetrahedra": {"2": {"max": 0.25}}})");
  }

  Mesh adapted(const Words& more) {
    Words words = {"adapt",      "part.meshb", "-o",          "out.meshb", "--report",    "out.json",
                   "--local",    "local.json", "--ridges",    "ridge.txt", "--deviation", "0.02",
                   "--geometry", "part.meshb", "--gradation", "1.5",       "--threads",   "1"};
    words.insert(words.end(), more.begin(), more.end());
    expect_done(words);
    return read_mesh("out.meshb");
  }

  /// The mean length of the edges of triangles of this reference.
  static double size_of(const Mesh& mesh, int ref) {
    double sum = 0, count = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (mesh.triangle_refs[t] != ref) continue;
      for (std::size_t k = 0; k < 3; ++k, ++count)
        sum += distance(mesh.points[mesh.triangles[t][k]], mesh.points[mesh.triangles[t][(k + 1) % 3]]);
    }
    return sum / count;
  }

  /// The largest distance of the centre of a triangle of the ball from the sphere.
  static double sag_of_ball(const Mesh& mesh) {
    double most = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (mesh.triangle_refs[t] != ball) continue;
      Point centre = {0, 0, 0};
      for (const Index p : mesh.triangles[t])
        for (std::size_t k = 0; k < 3; ++k) centre[k] += mesh.points[p][k] / 3;
      most = std::max(most, std::abs(distance(centre, {0.1, 0, 0}) - 0.5));
    }
    return most;
  }

  /// The length of the marked ridges between its ends.
  [[nodiscard]] double length_of_ridge(const Mesh& mesh) const {
    const double whole = distance(ridge[0], ridge[1]);
    const auto on_it = [&](const Point& x) { return distance(x, ridge[0]) + distance(x, ridge[1]) < whole + 1e-12; };
    double sum = 0;
    for (const Index e : mesh.ridges) {
      const Point &p = mesh.points[mesh.edges[e][0]], &q = mesh.points[mesh.edges[e][1]];
      if (on_it(p) && on_it(q)) sum += distance(p, q);
    }
    return sum;
  }

  const Mesh part = read_mesh(std::filesystem::path(TAUT_TEST_DATA) / "parts" / "ball-in-box.meshb");
  std::array<Point, 2> ridge;
};

TEST_F(ManyOptions, AllTakeEffect) {
  for (const Words& sizes : {Words{"--optimise"}, Words{"--size", "0.4"}}) {
    const Mesh found = adapted(sizes);
    expect_done({"quality", "out.meshb", "--check"});
    EXPECT_EQ(json::parse(read("out.json"))["off_surface"], 0);
    EXPECT_LT(size_of(found, fine), 0.17) << "--local";
    EXPECT_GT(size_of(found, other), 1.2 * size_of(found, fine)) << "--local reaches too far";
    EXPECT_LT(sag_of_ball(found), 0.016) << "--local, where sizes are those for half of 0.01";
    EXPECT_NEAR(length_of_ridge(found), distance(ridge[0], ridge[1]), 1e-12) << "--ridges";
    for (const Point& end : ridge) EXPECT_EQ(std::ranges::count(found.points, end), 1);
    EXPECT_EQ(std::set<int>(found.triangle_refs.begin(), found.triangle_refs.end()),
              std::set<int>(part.triangle_refs.begin(), part.triangle_refs.end()));
  }
}

}  // namespace
}  // namespace taut::test
