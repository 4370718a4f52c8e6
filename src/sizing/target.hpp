// The target metric as a function on the input domain.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/ids.hpp"
#include "base/placement.hpp"
#include "base/sym3.hpp"
#include "locate/background.hpp"
#include "taut/limits.hpp"
#include "taut/metric.hpp"
#include "taut/rigid_motion.hpp"

namespace taut {

/// Either the caller's function, or the field on the input mesh, interpolated log-Euclidean in the tetrahedron that
/// contains the point. Averages of averages along split edges would smear a front within a few passes.
class Target {
public:
  /// The function's values, truncated. A function cannot be graded.
  Target(MetricFunction function, const Limits& limits);

  /// The field with the metric `metrics[v]` at vertex v of the background mesh, which must outlive the target.
  Target(const Background& background, const std::vector<Sym3>& metrics);

  /// Where the function or field lies now: it is first moved by `placement`, which carries its tensors along.
  void place(const RigidMotion& placement);

  /// The metric at x. Of a field: `host` is the cell where the search starts, and becomes the one where x was found; a
  /// point outside the domain takes the value at the nearest place of that cell. Of a function: `host` stays as it is;
  /// throws InputError naming x if the value is not finite and positive definite.
  [[nodiscard]] Sym3 at(const Vec3& x, CellId& host) const;

private:
  [[nodiscard]] Sym3 at_home(const Vec3& x, CellId& host) const;
  [[nodiscard]] Sym3 interpolate(const Vec3& x, CellId& host) const;
  [[nodiscard]] Sym3 call(const Vec3& x) const;

  MetricFunction function_;
  Limits limits_;
  const Background* background_ = nullptr;
  std::vector<Sym3> log_metrics_;  // at the vertices of the background mesh
  Placement placement_;
};

}  // namespace taut
