#include "locate/background.hpp"

#include <algorithm>
#include <utility>

#include "base/parallel.hpp"

namespace taut {
namespace {

constexpr int most_steps = 4000;         // of a walk: a mesh of a million tetrahedra is about 200 tetrahedra across
constexpr std::size_t most_cells = 400;  // searched around the place where a walk met the boundary
constexpr double least_inside = -1e-9;   // barycentric coordinates above it count as not negative
constexpr double on_boundary = -1e-6;    // rounding of a point on an oblique face

// The cells of a search: hashed, because a point outside the domain sees all of them.
class Visited {
public:
  Visited() { slots_.fill(none); }

  // False if it is there already.
  bool add(CellId cell) {
    std::size_t at = (std::uint32_t{cell} * 0x9e3779b1U) >> (32 - bits);
    while (slots_[at] != none && slots_[at] != cell) at = (at + 1) % slots_.size();
    return std::exchange(slots_[at], cell) != cell;
  }

private:
  static constexpr int bits = 10;
  static_assert(most_cells + 4 < (1U << bits) / 2);
  std::array<CellId, 1U << bits> slots_;
};

}  // namespace

Background::Background(const TetMesh& mesh) : points_(mesh.vertices.size()), cells_(mesh.tets.size()) {
  for_each_index(points_.size(), [&](std::size_t v) { points_[v] = mesh.vertices[v].x; });
  for_each_index(cells_.size(), [&](std::size_t t) {
    cells_[t].v = mesh.tets[t].v;
    for (int f = 0; f < 4; ++f) {
      const FaceLink link = mesh.beyond(static_cast<TetId>(t), f);
      cells_[t].beyond[f] = link == outside ? CellId{none} : static_cast<CellId>(link.tet());
    }
  });
}

Weights Background::locate(const Vec3& x, CellId& host) const {
  Weights weights;
  if (!walk(x, host, weights)) search_around(x, host, weights);
  double sum = 0;
  for (double& w : weights) sum += w = std::max(w, 0.0);
  for (double& w : weights) w /= sum;
  return weights;
}

Weights Background::barycentric(CellId cell, const Vec3& x) const {
  const auto& v = cells_[cell].v;
  const Vec3 d = points_[v[0]] - x, a = points_[v[1]] - x, b = points_[v[2]] - x, c = points_[v[3]] - x;
  const Vec3 ab = cross(a, b), cd = cross(c, d);
  const Weights w = {dot(ab, c), -dot(cd, b), dot(cd, a), -dot(ab, d)};
  const double scale = 1 / (w[0] + w[1] + w[2] + w[3]);
  return {w[0] * scale, w[1] * scale, w[2] * scale, w[3] * scale};
}

// From cell to cell, across the face that the point is farthest behind.
bool Background::walk(const Vec3& x, CellId& host, Weights& weights) const {
  CellId from = none;
  for (int step = 0; step < most_steps; ++step) {
    weights = barycentric(host, x);
    int worst = -1;
    double least = least_inside;
    bool blocked = false;
    for (int f = 0; f < 4; ++f) {
      if (weights[f] >= least) continue;
      if (cells_[host].beyond[f] == none) {
        blocked = true;
      } else if (cells_[host].beyond[f] != from) {  // not straight back: rounding could make the walk oscillate
        least = weights[f];
        worst = f;
      }
    }
    if (worst < 0) return !blocked;
    from = std::exchange(host, cells_[host].beyond[worst]);
  }
  return false;
}

// From x to where the weights, made non-negative, place it in the cell.
double Background::miss(CellId cell, const Vec3& x, Weights weights) const {
  double sum = 0;
  for (double& w : weights) sum += w = std::max(w, 0.0);
  Vec3 placed{};
  for (int k = 0; k < 4; ++k) placed = placed + (weights[k] / sum) * points_[cells_[cell].v[k]];
  return norm(placed - x);
}

// For a walk that ended at the boundary: finds the cell around it that contains the point, or the one that places it
// nearest. Cells cannot be compared by their weights: the larger a cell is, the less of it a distance is.
void Background::search_around(const Vec3& x, CellId& host, Weights& weights) const {
  const auto lowest = [](const Weights& w) { return *std::min_element(w.begin(), w.end()); };
  if (lowest(weights) > on_boundary) return;
  double best = miss(host, x, weights);
  bool found = false;
  std::vector<CellId> queue{host};
  Visited visited;
  visited.add(host);
  for (std::size_t i = 0; i < queue.size() && queue.size() < most_cells && !found; ++i) {
    for (const CellId next : cells_[queue[i]].beyond) {
      if (next == none || !visited.add(next)) continue;
      queue.push_back(next);
      const Weights w = barycentric(next, x);
      const double missed_by = miss(next, x, w);
      found = lowest(w) >= least_inside;
      if (missed_by >= best && !found) continue;
      best = missed_by;
      host = next;
      weights = w;
      if (found) break;
    }
  }
}

}  // namespace taut
