// Parts from CAD with their exact surfaces and volumes. The meshes in tests/data/parts are what gmsh makes from the
// .geo files beside them (gmsh -3 -o part.mesh part.geo), written in binary. No edge turns by more than about 35
// degrees.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include "base/vec3.hpp"
#include "taut/io.hpp"

namespace taut::test {

/// An exact curved surface.
struct Shape {
  std::function<double(const Vec3&)> distance;  ///< signed
  std::function<double(const Vec3&)> radius;    ///< the smallest radius of curvature at a point of it
};

struct Part {
  std::string name;              ///< of the files
  std::map<int, double> volume;  ///< of each region, exact
  std::vector<Shape> shapes;     ///< all curved surfaces; the others are planar
  // Measured over all metrics of the tests, with some room. Edges longer than a wall is thick leave no good elements.
  double accuracy = 0;    ///< distance of the surface that these triangles stand for from the exact one
  double worst_Q = 3;     ///< of a tetrahedron
  double unit_edges = 0;  ///< share
};

inline std::ostream& operator<<(std::ostream& out, const Part& part) {
  return out << part.name;
}

inline Mesh mesh_of(const Part& part) {
  return read_mesh(std::filesystem::path(TAUT_TEST_DATA) / "parts" / (part.name + ".meshb"));
}

inline Shape sphere_at(const Vec3& centre, double radius) {
  return {[=](const Vec3& x) { return norm(x - centre) - radius; }, [=](const Vec3&) { return radius; }};
}

/// `axis` is a unit vector.
inline Shape cylinder_at(const Vec3& centre, const Vec3& axis, double radius) {
  return {[=](const Vec3& x) { return norm(cross(x - centre, axis)) - radius; }, [=](const Vec3&) { return radius; }};
}

/// A tube around the circle of radius `large` around the axis, a unit vector.
inline Shape torus_at(const Vec3& centre, const Vec3& axis, double large, double small) {
  return {
      [=](const Vec3& x) { return std::hypot(dot(x - centre, axis), norm(cross(x - centre, axis)) - large) - small; },
      [=](const Vec3&) { return small; }};
}

/// Around the z axis, with its base in the plane z = 0.
inline Shape cone_of(double base, double height) {
  const double side = std::hypot(base, height);
  return {[=](const Vec3& x) { return ((std::hypot(x[0], x[1]) - base) * height + x[2] * base) / side; },
          [=](const Vec3& x) { return std::hypot(x[0], x[1]) * side / height; }};
}

inline constexpr Vec3 along_x = {1, 0, 0}, along_y = {0, 1, 0}, along_z = {0, 0, 1};

inline std::vector<Shape> three_holes() {
  std::vector<Shape> shapes = {sphere_at({}, 1.25)};
  for (const Vec3& axis : {along_x, along_y, along_z}) shapes.push_back(cylinder_at({}, axis, 0.7));
  return shapes;
}

/// Of the unit cube, of radius 0.3.
inline std::vector<Shape> fillets() {
  std::vector<Shape> shapes;
  for (const double a : {0.3, 0.7})
    for (const double b : {0.3, 0.7}) {
      shapes.push_back(cylinder_at({0, a, b}, along_x, 0.3));
      shapes.push_back(cylinder_at({a, 0, b}, along_y, 0.3));
      shapes.push_back(cylinder_at({a, b, 0}, along_z, 0.3));
      for (const double c : {0.3, 0.7}) shapes.push_back(sphere_at({a, b, c}, 0.3));
    }
  return shapes;
}

inline std::vector<Part> parts() {
  constexpr double pi = std::numbers::pi;
  const auto ball = [](double radius) { return 4 * pi / 3 * radius * radius * radius; };
  return {
      {"chamfered-block", {{1, 1.935}}, {}, 0, 3, 0.95},
      {"embedded", {{1, 1}}, {}, 0, 100, 0.8},  // the line inside, which is on no triangle, is kept edge by edge
      {"plate-with-hole", {{3, 1.2 - pi * 0.036}}, {cylinder_at({2, 1.5, 0}, along_z, 0.6)}, 3e-4, 9, 0.45},
      {"torus", {{1, 2 * pi * pi * 0.35 * 0.35}}, {torus_at({}, along_z, 1, 0.35)}, 3e-3, 3, 0.85},
      {"pipe-bend",
       {{1, pi * (0.3 * 0.3 - 0.22 * 0.22) * pi / 2}},
       {torus_at({1, 0, 0}, along_y, 1, 0.3), torus_at({1, 0, 0}, along_y, 1, 0.22)},
       3e-3,
       5,
       0.6},
      {"csg", {{8, 1.4511037}}, three_holes(), 1.2e-2, 8, 0.2},  // walls and faces 0.05 wide
      {"thin-tube",
       {{3, 0.6 * pi * (0.5 * 0.5 - 0.47 * 0.47)}},
       {cylinder_at({}, along_z, 0.5), cylinder_at({}, along_z, 0.47)},
       4e-4,
       7,
       0.4},
      {"ball-in-box", {{2, ball(0.5)}, {3, 8 - ball(0.5)}}, {sphere_at({0.1, 0, 0}, 0.5)}, 1.5e-3, 7.5, 0.85},
      {"cone", {{1, pi * 0.8 * 0.8 * 0.5}}, {cone_of(0.8, 1.5)}, 2e-2, 6, 0.9},
      {"cavities",
       {{8, ball(0.3) / 2}, {9, 0.738 - ball(0.35) / 8 - ball(0.3) / 2}},
       {sphere_at({0, 0.8, 0}, 0.35), sphere_at({1.2, 0.4, 0.4}, 0.3)},
       1.2e-2,
       9,
       0.8},
      {"fillets", {{1, 0.064 + 0.6 * 3 * 0.16 + pi * 0.09 * 1.2 + ball(0.3)}}, fillets(), 1.1e-2, 3, 0.85},
  };
}

}  // namespace taut::test
