// Example 5.2 of Dobrzynski and Frey 2008: a mesh that resolves the surface r = 0.45 + 0.3 sin(3 phi), phi the
// latitude.
//
// usage: interface ERROR GROWTH ACROSS DEVIATION FOLDER
//
// Starts from a uniform mesh of [-1.2, 1.2]^3 with h = 0.2 and adapts it eight times to the metric of the level set,
// whose function is evaluated anew on each mesh. The first passes ask for less: the error halves from pass to pass
// until it is ERROR in the last two. If DEVIATION is above 0, vertices are then placed on the surface. Writes
// mesh.meshb and u.solb to FOLDER, and prints the seconds.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <taut/taut.hpp>
#include <vector>

namespace {

constexpr int passes = 8;
constexpr double error_ratio = 1.5;    // of a pass to the next
constexpr int rounds_before_last = 6;  // a mesh that is adapted again needs no polish

double distance_to_origin(const taut::Point& p) {
  return std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
}

double level(const taut::Point& p) {
  const double latitude = std::atan2(p[2], std::hypot(p[0], p[1]));
  return distance_to_origin(p) - (0.45 + 0.3 * std::sin(3 * latitude));
}

std::vector<double> level_at(const std::vector<taut::Point>& points) {
  std::vector<double> values(points.size());
  std::ranges::transform(points, values.begin(), level);
  return values;
}

/// The eight corners of the cube as six tetrahedra, adapted to one size.
taut::Mesh start() {
  taut::Mesh cube;
  for (const double x : {-1.2, 1.2})
    for (const double y : {-1.2, 1.2})
      for (const double z : {-1.2, 1.2}) cube.points.push_back({x, y, z});
  cube.tetrahedra = {{0, 4, 6, 7}, {0, 6, 2, 7}, {0, 2, 3, 7}, {0, 3, 1, 7}, {0, 1, 5, 7}, {0, 5, 4, 7}};
  return taut::adapt(cube, taut::Sizes(8, 0.2)).mesh;
}

taut::AdaptResult adapted_to(taut::Mesh mesh, const taut::LevelSetOptions& asked) {
  taut::AdaptResult result;
  for (int left = passes - 1; left >= 0; --left) {
    taut::LevelSetOptions options = asked;
    options.error *= std::pow(error_ratio, left);
    const taut::Tensors metric = taut::level_set_metric(mesh, level_at(mesh.points), options);
    taut::AdaptOptions how;
    if (left > 0) how.max_rounds = rounds_before_last;
    result = taut::adapt(mesh, metric, how);
    mesh = result.mesh;
  }
  return result;
}

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 6) return 2;
  const taut::LevelSetOptions options = {.error = std::atof(argv[1]),
                                         .across = std::atof(argv[3]),
                                         .growth = std::atof(argv[2]),
                                         .refinement = 3,
                                         .limits = {.hmax = 0.2}};
  const double deviation = std::atof(argv[4]);
  const std::filesystem::path folder = argv[5];

  const auto begin = std::chrono::steady_clock::now();
  taut::AdaptResult result = adapted_to(start(), options);
  std::vector<double> values = level_at(result.mesh.points);
  if (deviation > 0) {
    taut::Placed placed = taut::place_on_level_set(result.mesh, result.metric, level, {.deviation = deviation});
    result = std::move(placed.adapted);
    values = std::move(placed.values);
  }
  std::printf("%.2f\n", seconds_since(begin));

  taut::write_mesh(folder / "mesh.meshb", result.mesh);
  taut::write_solution(folder / "u.solb", {{.kind = taut::Field::Kind::scalar, .values = values}});
}
