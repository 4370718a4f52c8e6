// The target metric as a function on the input domain.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/sym3.hpp"
#include "mesh/tet_mesh.hpp"
#include "taut/metric.hpp"

namespace taut {

/// Either a function that the caller gave, or the field on the input mesh: log-Euclidean in the tetrahedron that holds
/// the point. Averages of averages along split edges would smear a front within a few passes.
class Target {
public:
  Target(MetricFunction function, double hmin, double hmax);

  /// Copies the mesh as it is; its vertices hold the metric. Afterwards host h is its tetrahedron h.
  explicit Target(const TetMesh& mesh);

  /// The metric at x. `host` is where the search starts, and becomes where x was found. A point outside the domain, as
  /// rounding on an oblique face gives, takes the value at the nearest place of the tetrahedron where the search ended.
  [[nodiscard]] Sym3 at(const Vec3& x, std::uint32_t& host) const;

private:
  struct Cell {
    std::array<VertexId, 4> v;
    std::array<std::uint32_t, 4> beyond;  ///< cell across each face; `none` at the boundary
  };
  using Weights = std::array<double, 4>;

  [[nodiscard]] Weights barycentric(std::uint32_t cell, const Vec3& x) const;
  [[nodiscard]] bool walk(const Vec3& x, std::uint32_t& host, Weights& weights) const;
  void search_around(const Vec3& x, std::uint32_t& host, Weights& weights) const;

  MetricFunction function_;
  double hmin_ = 0, hmax_ = 0;
  std::vector<Vec3> points_;
  std::vector<Sym3> log_metrics_;
  std::vector<Cell> cells_;
};

}  // namespace taut
