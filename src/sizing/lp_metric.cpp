#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "mesh/door.hpp"
#include "metric/intersection.hpp"
#include "metric/spectral.hpp"
#include "sizing/absolute.hpp"
#include "sizing/limits.hpp"
#include "sizing/nodal.hpp"
#include "sizing/scaling.hpp"
#include "taut/error.hpp"
#include "taut/sizing.hpp"

namespace taut {
namespace {

void require(const LpOptions& o) {
  require_limits(o.limits);
  if (!(o.complexity > 0 && std::isfinite(o.complexity)))
    throw InputError(fmt::format("complexity {} found, expected a number above 0", o.complexity));
  if (!(o.norm >= 1)) throw InputError(fmt::format("norm {} found, expected 1 or more", o.norm));
}

/// The power of det|H| that makes the metric optimal: 0 for the maximum norm, which weighs all places alike.
double exponent_of(double norm) {
  return std::isfinite(norm) ? -1 / (2 * norm + 3) : 0;
}

std::vector<Spectrum> optimal_shape(const Tensors& hessian, double norm) {
  std::vector<Spectrum> shape = absolute_spectra(hessian);
  const double exponent = exponent_of(norm);
  for_each_index(shape.size(), [&](std::size_t v) {
    Vec3& l = shape[v].values;
    l = std::pow(l[0] * l[1] * l[2], exponent) * l;
  });
  return shape;
}

/// Each field's metric gets the whole complexity: what one field needs does not depend on the unit of another.
std::vector<Spectrum> joint_shape(const Mesh& mesh, std::span<const Tensors> hessians, const LpOptions& options,
                                  const Limits& bounds) {
  std::vector<Sym3> joint;
  for (const Tensors& hessian : hessians) {
    auto metric = scaled_to(options.complexity, mesh, optimal_shape(hessian, options.norm), bounds).metric;
    if (joint.empty()) {
      joint = std::move(metric);
      continue;
    }
    for_each_index(joint.size(), [&](std::size_t v) { joint[v] = intersect(joint[v], metric[v]); });
  }
  std::vector<Spectrum> shape(joint.size());
  for_each_index(joint.size(), [&](std::size_t v) { shape[v] = spectrum(joint[v]); });
  return shape;
}

}  // namespace

ScaledMetric lp_metric(const Mesh& mesh, std::span<const Tensors> hessians, const LpOptions& options) {
  require_sound_arrays(mesh);
  require(options);
  if (hessians.empty()) throw InputError("no field found, expected one or more");
  for (const Tensors& hessian : hessians) require_tensors(hessian, mesh.points.size());
  const Limits limits = within_domain(mesh, options.limits);
  Limits bounds = limits;
  bounds.gradation.reset();
  auto shape =
      hessians.size() == 1 ? optimal_shape(hessians[0], options.norm) : joint_shape(mesh, hessians, options, bounds);
  return scaled_to(options.complexity, mesh, std::move(shape), limits);
}

Tensors error_metric(const Mesh& mesh, const Tensors& hessian, double error, const Limits& limits) {
  require_sound_arrays(mesh);
  require_limits(limits);
  require_tensors(hessian, mesh.points.size());
  if (!(error > 0 && std::isfinite(error)))
    throw InputError(fmt::format("error {} found, expected a number above 0", error));
  constexpr double c = 9.0 / 32;
  const std::vector<Spectrum> spectra = absolute_spectra(hessian);
  Tensors metric(spectra.size());
  for_each_index(metric.size(), [&](std::size_t v) {
    metric[v] = assemble({c / error * spectra[v].values, spectra[v].vectors});
  });
  return limited(mesh, std::move(metric), within_domain(mesh, limits));
}

}  // namespace taut
