#include "cavity/face_batch.hpp"

#include <cmath>

namespace taut {
namespace {

// 1/Q = V6 sqrt(det M) / S^(3/2) times this, where S is the sum of the six squared lengths; it does not change if M is
// four times as large.
constexpr double regular = 20.784609690826528;  // 12 sqrt 3

// Shewchuk's bound (7 + 56 eps) eps for det(a-p, b-p, c-p), times the 6 products of the permanent.
constexpr double rounding = 6 * 7.8e-16;

inline double larger(double a, double b) {
  return a > b ? a : b;  // one instruction, which std::max is not
}
inline double widest(double a, double b, double c) {
  return larger(larger(std::fabs(a), std::fabs(b)), std::fabs(c));
}

}  // namespace

void FaceBatch::push(const Vertex& a, const Vertex& b, const Vertex& c) {
  const int i = size_++;
  for (int d = 0; d < 3; ++d) {
    x_[d][i] = a.x[d];
    x_[3 + d][i] = b.x[d];
    x_[6 + d][i] = c.x[d];
  }
  for (int k = 0; k < 6; ++k) m_[k][i] = (a.m[k] + b.m[k]) + c.m[k];
}

bool FaceBatch::all_see(const Vec3& p) const {
  double least = 1;
  for (int i = 0; i < size_; ++i) {
    const double ax = x_[0][i] - p[0], ay = x_[1][i] - p[1], az = x_[2][i] - p[2];
    const double bx = x_[3][i] - p[0], by = x_[4][i] - p[1], bz = x_[5][i] - p[2];
    const double cx = x_[6][i] - p[0], cy = x_[7][i] - p[1], cz = x_[8][i] - p[2];
    const double v = ax * (by * cz - bz * cy) - ay * (bx * cz - bz * cx) + az * (bx * cy - by * cx);
    least = least < v ? least : v;
  }
  return least >= 0;
}

void FaceBatch::evaluate(const Vertex& apex) {
  const double px = apex.x[0], py = apex.x[1], pz = apex.x[2];
  const Sym3 m = apex.m;
  const int lanes = (size_ + 3) & ~3;  // whole vectors: nothing reads the lanes beyond the end
  for (int i = 0; i < lanes; ++i) {
    const double ax = x_[0][i] - px, ay = x_[1][i] - py, az = x_[2][i] - pz;
    const double bx = x_[3][i] - px, by = x_[4][i] - py, bz = x_[5][i] - pz;
    const double cx = x_[6][i] - px, cy = x_[7][i] - py, cz = x_[8][i] - pz;
    const double m0 = m_[0][i] + m[0], m1 = m_[1][i] + m[1], m2 = m_[2][i] + m[2];
    const double m3 = m_[3][i] + m[3], m4 = m_[4][i] + m[4], m5 = m_[5][i] + m[5];
    const double v = ax * (by * cz - bz * cy) - ay * (bx * cz - bz * cx) + az * (bx * cy - by * cx);
    // The determinant from the pivots: cofactors lose all digits on a rotated metric of anisotropy 1e4.
    const double i0 = 1 / m0, d1 = m3 - m1 * i0 * m1, r = m4 - m2 * i0 * m1;
    const double det = m0 * (d1 * (m5 - m2 * i0 * m2) - r * r);
    const auto form = [&](double x, double y, double z) { return quadratic_form(m0, m1, m2, m3, m4, m5, x, y, z); };
    // With p at the origin the six squared lengths add up to 4 (|a|^2 + |b|^2 + |c|^2) - |a + b + c|^2.
    const double s =
        4 * (form(ax, ay, az) + form(bx, by, bz) + form(cx, cy, cz)) - form(ax + bx + cx, ay + by + cy, az + bz + cz);
    volume[i] = v;
    quality[i] = regular * v * std::sqrt(det / (s * s * s));
    doubtful_volume[i] = rounding * widest(ax, bx, cx) * widest(ay, by, cy) * widest(az, bz, cz);
  }
}

}  // namespace taut
