#include "sizing/target.hpp"

#include <utility>

#include "base/parallel.hpp"
#include "metric/field.hpp"
#include "metric/spectral.hpp"
#include "sizing/truncation.hpp"

namespace taut {

Target::Target(MetricFunction function, const Limits& limits) : function_(std::move(function)), limits_(limits) {}

Target::Target(const Background& background, const std::vector<Sym3>& metrics)
    : background_(&background), log_metrics_(metrics.size()) {
  for_each_index(metrics.size(), [&](std::size_t v) { log_metrics_[v] = log_metric(metrics[v]); });
}

void Target::place(const RigidMotion& placement) {
  placement_ = Placement(placement);
}

Sym3 Target::at(const Vec3& x, CellId& host) const {
  return placement_.turned(at_home(placement_.back(x), host));
}

Sym3 Target::at_home(const Vec3& x, CellId& host) const {
  return background_ != nullptr ? interpolate(x, host) : call(x);
}

Sym3 Target::interpolate(const Vec3& x, CellId& host) const {
  const Weights weights = background_->locate(x, host);
  const auto& v = background_->vertices_of(host);
  Sym3 log{};
  for (int k = 0; k < 4; ++k) log = log + weights[k] * log_metrics_[v[k]];
  return exp_metric(log);
}

Sym3 Target::call(const Vec3& x) const {
  const Sym3 m = function_(x);
  require_metric(m, x);
  return truncate(m, limits_);
}

}  // namespace taut
