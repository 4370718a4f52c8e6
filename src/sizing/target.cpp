#include "sizing/target.hpp"

#include <algorithm>
#include <utility>

#include "base/parallel.hpp"
#include "metric/interpolation.hpp"
#include "metric/spectral.hpp"
#include "sizing/truncation.hpp"

namespace taut {
namespace {

constexpr int most_steps = 4000;         // of a walk: a mesh of a million tetrahedra is some 200 across
constexpr std::size_t most_cells = 400;  // looked at round the place where a walk met the boundary
constexpr double inside = -1e-9;         // a barycentric coordinate above it is as good as zero

}  // namespace

Target::Target(MetricFunction function, double hmin, double hmax)
    : function_(std::move(function)), hmin_(hmin), hmax_(hmax) {}

Target::Target(const TetMesh& mesh)
    : points_(mesh.vertices.size()), log_metrics_(mesh.vertices.size()), cells_(mesh.tets.size()) {
  for_each_index(mesh.vertices.size(), [&](std::size_t v) {
    points_[v] = mesh.vertices[v].x;
    log_metrics_[v] = log_metric(mesh.vertices[v].m);
  });
  for_each_index(mesh.tets.size(), [&](std::size_t t) {
    cells_[t].v = mesh.tets[t].v;
    for (int f = 0; f < 4; ++f) {
      const FaceLink link = mesh.beyond(static_cast<TetId>(t), f);
      cells_[t].beyond[f] = link == outside ? none : link.tet();
    }
  });
}

Sym3 Target::at(const Vec3& x, std::uint32_t& host) const {
  if (function_) return truncate(function_(x), hmin_, hmax_);
  Weights weights;
  if (!walk(x, host, weights)) search_around(x, host, weights);
  const auto& v = cells_[host].v;
  double sum = 0;
  for (double& w : weights) sum += w = std::max(w, 0.0);
  Sym3 log{};
  for (int k = 0; k < 4; ++k) log = log + (weights[k] / sum) * log_metrics_[v[k]];
  return exp_metric(log);
}

Target::Weights Target::barycentric(std::uint32_t cell, const Vec3& x) const {
  const auto& v = cells_[cell].v;
  const Vec3 d = points_[v[0]] - x, a = points_[v[1]] - x, b = points_[v[2]] - x, c = points_[v[3]] - x;
  const Vec3 ab = cross(a, b), cd = cross(c, d);
  const Weights w = {dot(ab, c), -dot(cd, b), dot(cd, a), -dot(ab, d)};
  const double scale = 1 / (w[0] + w[1] + w[2] + w[3]);
  return {w[0] * scale, w[1] * scale, w[2] * scale, w[3] * scale};
}

// From cell to cell across the face that the point lies farthest beyond. False if the boundary was in the way.
bool Target::walk(const Vec3& x, std::uint32_t& host, Weights& weights) const {
  std::uint32_t from = none;
  for (int step = 0; step < most_steps; ++step) {
    weights = barycentric(host, x);
    int worst = -1;
    double least = inside;
    bool blocked = false;
    for (int f = 0; f < 4; ++f) {
      if (weights[f] >= least) continue;
      if (cells_[host].beyond[f] == none) {
        blocked = true;
      } else if (cells_[host].beyond[f] != from) {  // never straight back: rounding could make it swing to and fro
        least = weights[f];
        worst = f;
      }
    }
    if (worst < 0) return !blocked;
    from = std::exchange(host, cells_[host].beyond[worst]);
  }
  return false;
}

// The walk ended at the boundary: of the cells around, the one that the point is in, or least outside of.
void Target::search_around(const Vec3& x, std::uint32_t& host, Weights& weights) const {
  const auto lowest = [](const Weights& w) { return *std::min_element(w.begin(), w.end()); };
  double best = lowest(weights);
  if (best > -1e-6) return;  // rounding on the boundary
  std::vector<std::uint32_t> queue{host};
  for (std::size_t i = 0; i < queue.size() && queue.size() < most_cells && best < inside; ++i) {
    for (std::uint32_t next : cells_[queue[i]].beyond) {
      if (next == none || std::find(queue.begin(), queue.end(), next) != queue.end()) continue;
      queue.push_back(next);
      const Weights w = barycentric(next, x);
      if (lowest(w) <= best) continue;
      best = lowest(w);
      host = next;
      weights = w;
    }
  }
}

}  // namespace taut
