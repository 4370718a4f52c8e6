#include "transfer/overlap.hpp"

#include <algorithm>

namespace taut {
namespace {

constexpr double thinnest = 1e-14;  // relative to the smaller tetrahedron

std::array<Weights4, 4> weights_in(const TetFrame& frame, const std::array<Vec3, 4>& corners) {
  return {frame.weights_of(corners[0]), frame.weights_of(corners[1]), frame.weights_of(corners[2]),
          frame.weights_of(corners[3])};
}

// Whether all corners lie on the wrong side of one face.
bool are_apart(const std::array<Weights4, 4>& corners) {
  for (std::size_t k = 0; k < 4; ++k)
    if (std::max(std::max(corners[0][k], corners[1][k]), std::max(corners[2][k], corners[3][k])) <= 0) return true;
  return false;
}

void add_product(Matrix4& sum, const Weights4& a, const Weights4& b) {
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) sum[i][j] += a[i] * b[j];
}

void scale(Matrix4& matrix, double by) {
  for (Weights4& row : matrix)
    for (double& x : row) x *= by;
}

Weights4 sum_of(const Weights4& a, const Weights4& b, const Weights4& c, const Weights4& d) {
  Weights4 sum;
  for (std::size_t k = 0; k < 4; ++k) sum[k] = (a[k] + b[k]) + (c[k] + d[k]);
  return sum;
}

Weights4 scaled(double by, const Weights4& a) {
  return {by * a[0], by * a[1], by * a[2], by * a[3]};
}

// The part of the volume of the tetrahedron that has these weights. Three of the four weights say it all.
double part(const Weights4& a, const Weights4& b, const Weights4& c, const Weights4& d) {
  const Vec3 u = {b[1] - a[1], b[2] - a[2], b[3] - a[3]};
  const Vec3 v = {c[1] - a[1], c[2] - a[2], c[3] - a[3]};
  const Vec3 w = {d[1] - a[1], d[2] - a[2], d[3] - a[3]};
  return dot(cross(u, v), w);
}

// The integral of f g over a tetrahedron of volume V with linear f and g is V / 20 (sum of f_v g_v + sum f sum g). The
// polyhedron is a fan of tetrahedra around its first vertex.
template <Weights4 Polyhedron::Vertex::*target, Weights4 Polyhedron::Vertex::*source>
void integrate(const Polyhedron& polyhedron, double whole, Overlap& result) {
  const auto v = polyhedron.vertices();
  std::array<double, Polyhedron::most> share;  // volume of the tetrahedra at each vertex
  std::fill_n(share.begin(), v.size(), 0.0);
  polyhedron.for_each_triangle_seen_from_first([&](std::size_t i, std::size_t j, std::size_t k) {
    const double volume = part(v[0].own, v[i].own, v[k].own, v[j].own);
    result.volume += volume;
    for (const std::size_t at : {std::size_t{0}, i, j, k}) share[at] += volume;
    const Weights4 t = sum_of(v[0].*target, v[i].*target, v[j].*target, v[k].*target);
    const Weights4 s = sum_of(v[0].*source, v[i].*source, v[j].*source, v[k].*source);
    add_product(result.target_source, scaled(volume, t), s);
    add_product(result.target_target, scaled(volume, t), t);
  });
  for (std::size_t i = 0; i < v.size(); ++i) {
    const Weights4 t = scaled(share[i], v[i].*target);
    add_product(result.target_source, t, v[i].*source);
    add_product(result.target_target, t, v[i].*target);
  }
  result.volume *= whole;
  scale(result.target_source, whole / 20);
  scale(result.target_target, whole / 20);
}

template <Weights4 Polyhedron::Vertex::*source>
std::array<bool, 4> faces_reached(const Polyhedron& polyhedron) {
  std::array<int, 4> on_face{};
  for (const auto& vertex : polyhedron.vertices())
    for (std::size_t f = 0; f < 4; ++f) on_face[f] += (vertex.*source)[f] == 0 ? 1 : 0;
  return {on_face[0] > 2, on_face[1] > 2, on_face[2] > 2, on_face[3] > 2};
}

// The smaller tetrahedron is cut by the larger: in its own weights the polyhedron is large, so that differences of
// weights keep their digits.
template <Weights4 Polyhedron::Vertex::*target, Weights4 Polyhedron::Vertex::*source>
std::optional<Overlap> cut(const TetFrame& whole, const std::array<Weights4, 4>& in_other) {
  if (are_apart(in_other)) return std::nullopt;
  Polyhedron polyhedron(in_other);
  if (!polyhedron.clip()) return std::nullopt;
  std::optional<Overlap> result(Overlap{});
  integrate<target, source>(polyhedron, whole.volume, *result);
  if (!(result->volume > thinnest * whole.volume)) return std::nullopt;
  result->reaches = faces_reached<source>(polyhedron);
  return result;
}

}  // namespace

std::optional<Overlap> overlap(const TetFrame& target, const std::array<Vec3, 4>& source) {
  using Both = Polyhedron::Vertex;
  const TetFrame frame(source);
  if (frame.volume < target.volume) return cut<&Both::other, &Both::own>(frame, weights_in(target, source));
  return cut<&Both::own, &Both::other>(target, weights_in(frame, target.corners));
}

}  // namespace taut
