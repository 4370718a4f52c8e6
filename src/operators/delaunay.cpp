#include "operators/delaunay.hpp"

#include <cmath>

namespace taut {
namespace {

// K relative to its first vertex: its edges e, the rows of the inverse of their matrix times its determinant, and p.
struct Frame {
  std::array<Vec3, 3> e, dual;
  double det;
  Vec3 d;
};

Frame frame_of(const Vertex& p, const std::array<const Vertex*, 4>& k) {
  Frame f;
  for (int i = 0; i < 3; ++i) f.e[i] = k[i + 1]->x - k[0]->x;
  f.dual = {cross(f.e[1], f.e[2]), cross(f.e[2], f.e[0]), cross(f.e[0], f.e[1])};
  f.det = dot(f.dual[0], f.e[0]);
  f.d = p.x - k[0]->x;
  return f;
}

// delta^2 in the metric m. The circumcentre O solves 2 e_i^T M O = e_i^T M e_i. So c = M O needs only the inverse of
// the matrix of the edges, which does not depend on the metric; r^2 = c^T M^-1 c, and |Op|^2 = |d|^2 - 2 d.c + r^2.
inline double squared_delta(const Frame& f, double m0, double m1, double m2, double m3, double m4, double m5) {
  const auto form = [&](const Vec3& v) { return quadratic_form({m0, m1, m2, m3, m4, m5}, v); };
  const double half = 0.5 / f.det;
  const double l0 = half * form(f.e[0]), l1 = half * form(f.e[1]), l2 = half * form(f.e[2]);
  const Vec3 c = {l0 * f.dual[0][0] + l1 * f.dual[1][0] + l2 * f.dual[2][0],
                  l0 * f.dual[0][1] + l1 * f.dual[1][1] + l2 * f.dual[2][1],
                  l0 * f.dual[0][2] + l1 * f.dual[1][2] + l2 * f.dual[2][2]};
  const double a0 = m3 * m5 - m4 * m4, a1 = m2 * m4 - m1 * m5, a2 = m1 * m4 - m2 * m3;  // the adjugate of M
  const double a3 = m0 * m5 - m2 * m2, a4 = m1 * m2 - m0 * m4, a5 = m0 * m3 - m1 * m1;
  const double det = m0 * a0 + m1 * a1 + m2 * a2;
  const double r2 = (a0 * c[0] * c[0] + a3 * c[1] * c[1] + a5 * c[2] * c[2] +
                     2 * (a1 * c[0] * c[1] + a2 * c[0] * c[2] + a4 * c[1] * c[2])) /
                    det;
  return 1 + (form(f.d) - 2 * (f.d[0] * c[0] + f.d[1] * c[1] + f.d[2] * c[2])) / r2;
}

}  // namespace

bool in_conflict(const Vertex& p, const std::array<const Vertex*, 4>& k) {
  const Frame f = frame_of(p, k);
  const auto& m = p.m;
  const double at_p = squared_delta(f, m[0], m[1], m[2], m[3], m[4], m[5]);
  if (!(at_p < 1)) return false;
  alignas(32) double v[6][4];
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 6; ++j) v[j][i] = k[i]->m[j];
  alignas(32) double delta[4];
  for (int i = 0; i < 4; ++i)
    delta[i] = std::sqrt(squared_delta(f, v[0][i], v[1][i], v[2][i], v[3][i], v[4][i], v[5][i]));
  // A negative square, from rounding at the circumcentre, gives a NaN, which the comparison below treats as zero.
  double sum = std::sqrt(at_p > 0 ? at_p : 0);
  for (double x : delta) sum += x > 0 ? x : 0;
  return sum < 5;
}

}  // namespace taut
