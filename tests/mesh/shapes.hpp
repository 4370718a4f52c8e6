// Small domains with their triangles, for tests that need a surface.
#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <random>

#include "base/ids.hpp"
#include "base/vec3.hpp"
#include "mesh/grid.hpp"

namespace taut::test {

/// The sum of the volumes and, for triangles, of the areas.
inline double volume_of(const Mesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.tetrahedra)
    sum += six_volumes(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]) / 6;
  return sum;
}

inline Vec3 area_normal(const Mesh& mesh, const std::array<Index, 3>& t) {
  return 0.5 * cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]);
}

inline Vec3 centre_of(const Mesh& mesh, const std::array<Index, 3>& t) {
  return (1.0 / 3) * (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]);
}

inline Vec3 centre_of(const Mesh& mesh, const std::array<Index, 4>& t) {
  return 0.25 * (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]] + mesh.points[t[3]]);
}

/// Adds a triangle on each face of one tetrahedron and between tetrahedra of different reference, seen from the
/// tetrahedron that comes first; of reference 1 to 6 by the direction of the axis nearest to its normal, 7 inside.
inline void add_triangles(Mesh& mesh) {
  struct Seen {
    std::array<Index, 3> outward;
    std::size_t count = 0;
    int ref = 0;
    bool between = false;
  };
  std::map<std::array<Index, 3>, Seen> faces;
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    const auto& v = mesh.tetrahedra[t];
    const int ref = mesh.tetrahedron_refs.empty() ? 0 : mesh.tetrahedron_refs[t];
    for (const std::array<Index, 3> face : {std::array{v[1], v[2], v[3]}, std::array{v[0], v[3], v[2]},
                                            std::array{v[0], v[1], v[3]}, std::array{v[0], v[2], v[1]}}) {
      auto key = face;
      std::sort(key.begin(), key.end());
      Seen& seen = faces.try_emplace(key, Seen{face, 0, ref}).first->second;
      ++seen.count;
      seen.between |= seen.ref != ref;
    }
  }
  for (const auto& [key, seen] : faces) {
    if (seen.count == 2 && !seen.between) continue;
    const Vec3 n = area_normal(mesh, seen.outward);
    int axis = 0;
    for (int d = 1; d < 3; ++d)
      if (std::abs(n[d]) > std::abs(n[axis])) axis = d;
    mesh.triangles.push_back(seen.outward);
    mesh.triangle_refs.push_back(seen.between ? 7 : 1 + 2 * axis + (n[axis] > 0 ? 1 : 0));
  }
}

/// Keeps the tetrahedra whose centre satisfies the condition, and removes unused points.
inline Mesh restricted(const Mesh& mesh, const std::function<bool(const Vec3&)>& keep) {
  Mesh kept;
  std::map<Index, Index> renumber;
  for (const auto& t : mesh.tetrahedra) {
    if (!keep(centre_of(mesh, t))) continue;
    auto v = t;
    for (Index& i : v) {
      const auto [at, is_new] = renumber.try_emplace(i, static_cast<Index>(kept.points.size()));
      if (is_new) kept.points.push_back(mesh.points[i]);
      i = at->second;
    }
    kept.tetrahedra.push_back(v);
  }
  return kept;
}

/// The unit cube; sides of reference 1 (x = 0), 2 (x = 1), 3, 4, 5, 6.
inline Mesh cube(Index n) {
  Mesh mesh = grid(n);
  add_triangles(mesh);
  return mesh;
}

/// The unit cube in two regions, 1 and 2, that meet at x = 1/2 in triangles of reference 7. n is even.
inline Mesh two_regions(Index n) {
  Mesh mesh = grid(n);
  for (const auto& t : mesh.tetrahedra) mesh.tetrahedron_refs.push_back(centre_of(mesh, t)[0] < 0.5 ? 1 : 2);
  add_triangles(mesh);
  return mesh;
}

/// Adds triangles of reference 20 + axis inside the volume, on the square that spans the middle half of the plane
/// across an axis at 1/2: the volume is on both sides of this surface and around its border.
inline void add_sheet(Mesh& mesh, std::size_t axis) {
  const auto is_on_sheet = [axis](const Point& p) {
    for (std::size_t d = 0; d < 3; ++d)
      if (d == axis ? p[d] != 0.5 : p[d] < 0.25 || p[d] > 0.75) return false;
    return true;
  };
  for (const auto& t : mesh.tetrahedra)
    for (const auto& [i, j, k] : face_vertices) {
      const std::array<Index, 3> face = {t[i], t[j], t[k]};
      if (!std::ranges::all_of(face, [&](Index p) { return is_on_sheet(mesh.points[p]); })) continue;
      if (area_normal(mesh, face)[axis] < 0) continue;  // seen from the other side
      mesh.triangles.push_back(face);
      mesh.triangle_refs.push_back(20 + static_cast<int>(axis));
    }
}

/// A cube with one sheet. n is a multiple of 4.
inline Mesh cube_with_sheet(Index n) {
  Mesh mesh = cube(n);
  add_sheet(mesh, 2);
  return mesh;
}

/// The unit cube without its quarter at large x and y. n is even.
inline Mesh l_shape(Index n) {
  Mesh mesh = restricted(grid(n), [](const Vec3& c) { return c[0] < 0.5 || c[1] < 0.5; });
  add_triangles(mesh);
  return mesh;
}

/// The unit cube, slit along z = 1/2: both halves have their own points there, except one common point, `pin`, in the
/// middle.
inline Mesh slit(Index& pin) {
  Mesh mesh = grid(4);
  std::map<Index, Index> twins;
  const auto is_upper = [&](const std::array<Index, 4>& t) { return centre_of(mesh, t)[2] > 0.5; };
  std::vector<std::size_t> upper;
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
    if (is_upper(mesh.tetrahedra[t])) upper.push_back(t);
  for (const std::size_t t : upper)
    for (Index& v : mesh.tetrahedra[t]) {
      const Point x = mesh.points[v];
      if (x == Point{0.5, 0.5, 0.5}) pin = v;
      if (x[2] != 0.5 || v == pin) continue;
      const auto [twin, is_new] = twins.try_emplace(v, static_cast<Index>(mesh.points.size()));
      if (is_new) mesh.points.push_back(x);
      v = twin->second;
    }
  add_triangles(mesh);
  return mesh;
}

/// Moves the points by up to `amount` in each direction in which they do not lie on one of the planes at 0, 1/2 and 1.
inline void jitter(Mesh& mesh, double amount, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<double> shift(-amount, amount);
  for (Point& p : mesh.points)
    for (double& x : p)
      if (x != 0 && x != 0.5 && x != 1) x += shift(generator);
}

/// Maps the unit cube to one with a vault: the top at z = 1 + sin(pi x) / 4 is curved, the other sides are planar.
inline Mesh vault(Mesh mesh) {
  for (Point& p : mesh.points) p[2] *= 1 + 0.25 * std::sin(3.14159265358979 * p[0]);
  return mesh;
}

/// Maps the unit cube to the unit ball around the origin, with a surface of reference 1.
inline Mesh ball(Mesh mesh) {
  for (Point& p : mesh.points) {
    const Vec3 c = 2.0 * p - Vec3{1, 1, 1};
    const Vec3 s = {c[0] * c[0], c[1] * c[1], c[2] * c[2]};
    for (int d = 0; d < 3; ++d) {
      const double a = s[(d + 1) % 3], b = s[(d + 2) % 3];
      p[d] = c[d] * std::sqrt(1 - a / 2 - b / 2 + a * b / 3);
    }
  }
  mesh.triangle_refs.assign(mesh.triangles.size(), 1);
  return mesh;
}

/// n tetrahedra around the edge from point 0 to point 1, which runs along z from -height to height. The other points
/// form a ring around the axis, at the given radii and elevations. An open ring is the half at y >= 0.
inline Mesh ring(const std::vector<double>& radius, const std::vector<double>& elevation, double height, bool closed) {
  Mesh mesh;
  mesh.points = {{0, 0, -height}, {0, 0, height}};
  const auto n = static_cast<Index>(radius.size());
  for (Index i = 0; i < n; ++i) {
    const double angle = closed ? 2 * 3.14159265358979 * i / n : 3.14159265358979 * i / (n - 1);
    const bool flat = !closed && (i == 0 || i + 1 == n);
    mesh.points.push_back({radius[i] * std::cos(angle), flat ? 0 : radius[i] * std::sin(angle), elevation[i]});
  }
  for (Index i = 0; i + (closed ? 0 : 1) < n; ++i) mesh.tetrahedra.push_back({0, 1, 2 + i, 2 + (i + 1) % n});
  add_triangles(mesh);
  return mesh;
}

}  // namespace taut::test
