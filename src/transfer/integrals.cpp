#include "transfer/integrals.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "base/parallel.hpp"
#include "locate/cell_tree.hpp"
#include "transfer/overlap.hpp"

namespace taut {
namespace {

constexpr std::size_t cells_of_task = 1024;
constexpr double covered = 1e-12;  // part of a tetrahedron that may be missing: rounding

// What one thread needs: the source tetrahedra that it has compared with the current target tetrahedron.
struct Scratch {
  std::vector<std::uint32_t> seen;  // by source tetrahedron: the last target tetrahedron, plus 1
  std::vector<CellId> queue;
};

struct Count {
  std::size_t overlaps = 0;
  double volume = 0;
  Count& operator+=(const Count& other) {
    overlaps += other.overlaps;
    volume += other.volume;
    return *this;
  }
};

class Integration {
public:
  Integration(const Background& source, const Values& values, const Background& target,
              const std::vector<Place>& places)
      : source_(source), values_(values), target_(target), places_(places) {
    result_.components = values.size;
    result_.all.resize(result_.stride() * target.cell_count());
    counts_.resize(target.cell_count());
    is_partly_.assign(target.cell_count(), 0);
  }

  Integrals run() {
    flood_all();
    search_rest();
    const Count sum = sum_in_order<Count>(counts_.size(), [&](Count& s, std::size_t t) { s += counts_[t]; });
    result_.overlaps = sum.overlaps;
    result_.volume = sum.volume;
    return std::move(result_);
  }

private:
  void flood_all() {
    std::vector<Scratch> scratch(static_cast<std::size_t>(worker_count()));
    const Chunks tasks(target_.cell_count(), cells_of_task);
    for_each_task(tasks.size(), [&](std::size_t task, int worker) {
      Scratch& own = scratch[static_cast<std::size_t>(worker)];
      if (own.seen.empty()) own.seen.assign(source_.cell_count(), 0);
      for (std::size_t t = tasks.begin(task); t < tasks.end(task); ++t) flood(static_cast<CellId>(t), own);
    });
  }

  // From the source tetrahedron that contains the centre to its neighbours, as far as they overlap.
  void flood(CellId t, Scratch& scratch) {
    const TetFrame frame(target_.corners_of(t));
    scratch.queue.assign(1, start_of(t, frame));
    scratch.seen[scratch.queue[0]] = t + 1;
    for (std::size_t i = 0; i < scratch.queue.size(); ++i) {
      const CellId s = scratch.queue[i];
      const std::optional<Overlap> common = overlap(frame, source_.corners_of(s));
      if (!common) continue;
      add(t, s, *common);
      for (std::size_t f = 0; f < 4; ++f) {
        const CellId next = source_.neighbours_of(s)[f];
        if (!common->reaches[f] || next == none || scratch.seen[next] == t + 1) continue;
        scratch.seen[next] = t + 1;
        scratch.queue.push_back(next);
      }
    }
    is_partly_[t] = std::abs(counts_[t].volume - frame.volume) > covered * frame.volume ? 1 : 0;
  }

  [[nodiscard]] CellId start_of(CellId t, const TetFrame& frame) const {
    CellId host = places_[target_.vertices_of(t)[0]].cell;
    Weights weights;
    const auto& x = frame.corners;
    (void)source_.walk(0.25 * ((x[0] + x[1]) + (x[2] + x[3])), host, weights);
    return host;
  }

  // The domain of the source may end inside a target tetrahedron and begin again: neighbours do not lead everywhere.
  void search_rest() {
    const auto rest = indices_where(is_partly_.size(), [&](std::size_t t) { return is_partly_[t] != 0; });
    if (rest.empty()) return;
    const CellTree tree(source_);
    const Chunks tasks(rest.size(), cells_of_task / 16);
    for_each_task(tasks.size(), [&](std::size_t task, int) {
      for (std::size_t i = tasks.begin(task); i < tasks.end(task); ++i) search(static_cast<CellId>(rest[i]), tree);
    });
  }

  void search(CellId t, const CellTree& tree) {
    const TetFrame frame(target_.corners_of(t));
    Box box;
    for (const Vec3& x : frame.corners) box.include(x);
    const auto all = numbers(t);
    std::fill(all.begin(), all.end(), 0.0);
    counts_[t] = {};
    tree.for_each_near(box, [&](CellId s) {
      if (const auto common = overlap(frame, source_.corners_of(s))) add(t, s, *common);
    });
  }

  void add(CellId t, CellId s, const Overlap& common) {
    double* mass = numbers(t).data();
    double* volumes = mass + 10;
    for (std::size_t i = 0; i < 4; ++i) {
      const Weights4& row = common.target_source[i];
      volumes[i] += (row[0] + row[1]) + (row[2] + row[3]);
      for (std::size_t k = i; k < 4; ++k) mass[Integrals::pair_of[i][k]] += common.target_target[i][k];
    }
    add_values(t, s, common.target_source, counts_[t].overlaps == 0);
    counts_[t] += {1, common.volume};
  }

  void add_values(CellId t, CellId s, const Matrix4& integrals, bool is_first) {
    const std::size_t n = values_.size;
    const auto& v = source_.vertices_of(s);
    const std::array<const double*, 4> rows = {values_[v[0]].data(), values_[v[1]].data(), values_[v[2]].data(),
                                               values_[v[3]].data()};
    double* moments = numbers(t).data() + 14;
    double *least = moments + 4 * n, *greatest = least + n;
    for (std::size_t c = 0; c < n; ++c) {
      const Weights4 u = {rows[0][c], rows[1][c], rows[2][c], rows[3][c]};
      for (std::size_t i = 0; i < 4; ++i) {
        const Weights4& w = integrals[i];
        moments[i * n + c] += (w[0] * u[0] + w[1] * u[1]) + (w[2] * u[2] + w[3] * u[3]);
      }
      const auto [low, high] = std::minmax({u[0], u[1], u[2], u[3]});
      least[c] = is_first ? low : std::min(least[c], low);
      greatest[c] = is_first ? high : std::max(greatest[c], high);
    }
  }

  [[nodiscard]] std::span<double> numbers(CellId t) { return {&result_.all[t * result_.stride()], result_.stride()}; }

  const Background& source_;
  const Values& values_;
  const Background& target_;
  const std::vector<Place>& places_;
  Integrals result_;
  std::vector<Count> counts_;
  std::vector<std::uint8_t> is_partly_;
};

}  // namespace

Integrals integrate(const Background& source, const Values& values, const Background& target,
                    const std::vector<Place>& places) {
  return Integration(source, values, target, places).run();
}

}  // namespace taut
