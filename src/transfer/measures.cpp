#include "transfer/measures.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "base/vec3.hpp"

namespace taut {
namespace {

struct Sums {
  MeshMeasures measures;

  Sums& operator+=(const Sums& other) {
    auto& own = measures.components;
    measures.volume += other.measures.volume;
    if (own.empty())
      own = other.measures.components;
    else
      for (std::size_t c = 0; c < own.size(); ++c) {
        const Measures& more = other.measures.components[c];
        own[c].mass += more.mass;
        own[c].least = std::min(own[c].least, more.least);
        own[c].greatest = std::max(own[c].greatest, more.greatest);
      }
    return *this;
  }

  void add(double volume, const std::array<std::span<const double>, 4>& rows) {
    auto& own = measures.components;
    const bool is_first = own.empty();
    measures.volume += volume;
    own.resize(rows[0].size());
    for (std::size_t c = 0; c < own.size(); ++c) {
      const auto [low, high] = std::minmax({rows[0][c], rows[1][c], rows[2][c], rows[3][c]});
      own[c].mass += volume * (0.25 * ((rows[0][c] + rows[1][c]) + (rows[2][c] + rows[3][c])));
      own[c].least = is_first ? low : std::min(own[c].least, low);
      own[c].greatest = is_first ? high : std::max(own[c].greatest, high);
    }
  }
};

}  // namespace

MeshMeasures measured(const Mesh& mesh, const Values& values) {
  return sum_in_order<Sums>(mesh.tetrahedra.size(),
                            [&](Sums& sums, std::size_t t) {
                              const auto& v = mesh.tetrahedra[t];
                              const auto& x = mesh.points;
                              const double volume = std::abs(six_volumes(x[v[0]], x[v[1]], x[v[2]], x[v[3]])) / 6;
                              sums.add(volume, {values[v[0]], values[v[1]], values[v[2]], values[v[3]]});
                            })
      .measures;
}

}  // namespace taut
