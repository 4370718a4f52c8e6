#include "transfer/system.hpp"

#include <algorithm>

#include "base/buckets.hpp"
#include "base/parallel.hpp"

namespace taut {
namespace {

constexpr std::size_t rows_of_task = 4096;

// A vertex of a tetrahedron, seen from the vertex.
struct Use {
  std::uint32_t tet, corner;
};

Buckets<Use> uses_of(const Background& target) {
  return gather<Use>(target.cell_count(), target.point_count(), [&](std::size_t t, auto put) {
    const auto& v = target.vertices_of(static_cast<CellId>(t));
    for (std::uint32_t k = 0; k < 4; ++k) put(v[k], Use{static_cast<std::uint32_t>(t), k});
  });
}

class Assembly {
public:
  Assembly(const Integrals& integrals, const Background& target)
      : integrals_(integrals),
        target_(target),
        system_{{},
                {},
                std::vector<double>(target.point_count()),
                Values(integrals.components, target.point_count()),
                Values(integrals.components, target.point_count()),
                Values(integrals.components, target.point_count())} {}

  System run() {
    const Buckets<Use> uses = uses_of(target_);
    system_.first.assign(system_.size() + 1, 0);
    system_.entries =
        collect_in_order<Entry>(Chunks(system_.size(), rows_of_task), [&](std::vector<Entry>& entries, std::size_t i) {
          const std::size_t before = entries.size();
          add_row(i, uses[i], entries);
          system_.first[i + 1] = entries.size() - before;
        });
    for (std::size_t i = 0; i < system_.size(); ++i) system_.first[i + 1] += system_.first[i];
    return std::move(system_);
  }

private:
  using Entry = System::Entry;

  void add_row(std::size_t i, std::span<const Use> uses, std::vector<Entry>& entries) {
    const std::size_t begin = entries.size();
    for (const Use& use : uses) {
      const Integrals::View own = integrals_[use.tet];
      if (!(own.volumes[use.corner] > 0)) continue;
      if (entries.size() == begin) entries.push_back({static_cast<std::uint32_t>(i), 0});
      add_bounds(i, own, system_.volume[i] == 0);
      system_.volume[i] += own.volumes[use.corner];
      for (std::size_t c = 0; c < integrals_.components; ++c)
        system_.moments[i][c] += own.moments[use.corner * integrals_.components + c];
      const auto& v = target_.vertices_of(static_cast<CellId>(use.tet));
      for (std::size_t k = 0; k < 4; ++k)
        entry_for(entries, begin, v[k]).value += own.mass[Integrals::pair_of[use.corner][k]];
    }
  }

  static Entry& entry_for(std::vector<Entry>& entries, std::size_t begin, std::uint32_t column) {
    for (std::size_t e = begin; e < entries.size(); ++e)
      if (entries[e].column == column) return entries[e];
    return entries.emplace_back(Entry{column, 0});
  }

  void add_bounds(std::size_t i, const Integrals::View& own, bool is_first) {
    for (std::size_t c = 0; c < integrals_.components; ++c) {
      double &low = system_.least[i][c], &high = system_.greatest[i][c];
      low = is_first ? own.least[c] : std::min(low, own.least[c]);
      high = is_first ? own.greatest[c] : std::max(high, own.greatest[c]);
    }
  }

  const Integrals& integrals_;
  const Background& target_;
  System system_;
};

}  // namespace

System assemble(const Integrals& integrals, const Background& target) {
  return Assembly(integrals, target).run();
}

}  // namespace taut
