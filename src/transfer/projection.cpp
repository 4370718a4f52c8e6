#include "transfer/projection.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/parallel.hpp"

namespace taut {
namespace {

class Correction {
public:
  Correction(const System& system, const Values& lumped, const Values& consistent)
      : system_(system), lumped_(lumped), consistent_(consistent), allowed_(system.size()) {}

  // The part of all fluxes that raise a vertex, and of all that lower it, that leaves it within its bounds even if
  // none of the others came.
  void limit(std::size_t c) {
    for_each_index(system_.size(), [&](std::size_t i) {
      double raise = 0, lower = 0;
      for (const System::Entry& entry : system_.row(i)) {
        const double flow = flux(i, entry, c);
        (flow > 0 ? raise : lower) += flow;
      }
      const double u = lumped_[i][c], volume = system_.volume[i];
      allowed_[i] = {part(volume * (system_.greatest[i][c] - u), raise),
                     part(volume * (u - system_.least[i][c]), -lower)};
    });
  }

  [[nodiscard]] double limited(std::size_t i, std::size_t c) const {
    const double u = raised(i, c, [&](const System::Entry& entry, double flow) {
      const auto &here = allowed_[i], &there = allowed_[entry.column];
      return flow * (flow > 0 ? std::min(here.raise, there.lower) : std::min(here.lower, there.raise));
    });
    return std::clamp(u, system_.least[i][c], system_.greatest[i][c]);  // beyond them is rounding
  }

  [[nodiscard]] double full(std::size_t i, std::size_t c) const {
    return raised(i, c, [](const System::Entry&, double flow) { return flow; });
  }

private:
  struct Allowed {
    double raise, lower;
  };

  static double part(double room, double wanted) { return wanted > room ? std::max(room, 0.0) / wanted : 1; }

  [[nodiscard]] double flux(std::size_t i, const System::Entry& entry, std::size_t c) const {
    return entry.value * (consistent_[i][c] - consistent_[entry.column][c]);
  }

  template <class Pass>
  [[nodiscard]] double raised(std::size_t i, std::size_t c, const Pass& pass) const {
    double sum = 0;
    for (const System::Entry& entry : system_.row(i)) sum += pass(entry, flux(i, entry, c));
    return lumped_[i][c] + sum / system_.volume[i];
  }

  const System& system_;
  const Values& lumped_;
  const Values& consistent_;
  std::vector<Allowed> allowed_;
};

}  // namespace

Values lumped(const System& system, Values otherwise) {
  for_each_index(system.size(), [&](std::size_t i) {
    if (system.row(i).empty()) return;
    for (std::size_t c = 0; c < otherwise.size; ++c)
      otherwise[i][c] = std::clamp(system.moments[i][c] / system.volume[i], system.least[i][c], system.greatest[i][c]);
  });
  return otherwise;
}

Values corrected(const System& system, const Values& lumped, const Values& consistent, bool is_limited) {
  Values result = lumped;
  Correction correction(system, lumped, consistent);
  for (std::size_t c = 0; c < result.size; ++c) {
    if (is_limited) correction.limit(c);
    for_each_index(system.size(), [&](std::size_t i) {
      if (system.row(i).empty()) return;
      result[i][c] = is_limited ? correction.limited(i, c) : correction.full(i, c);
    });
  }
  return result;
}

}  // namespace taut
