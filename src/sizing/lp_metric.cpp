#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "mesh/door.hpp"
#include "metric/intersection.hpp"
#include "metric/spectral.hpp"
#include "sizing/absolute.hpp"
#include "sizing/limits.hpp"
#include "sizing/nodal.hpp"
#include "sizing/optimal.hpp"
#include "sizing/scaling.hpp"
#include "taut/error.hpp"
#include "taut/sizing.hpp"

namespace taut {
namespace {

bool is_flat(const Tensors& hessian) {
  return std::ranges::all_of(hessian, [](const Tensor& h) { return h == Tensor{}; });
}

/// A field that is flat everywhere, such as a component of a velocity that is zero, asks for nothing. One is kept if
/// there is no other.
std::vector<const Tensors*> those_that_ask(std::span<const Tensors> hessians) {
  std::vector<const Tensors*> some;
  for (const Tensors& hessian : hessians)
    if (!is_flat(hessian)) some.push_back(&hessian);
  if (some.empty()) some.push_back(&hessians.front());
  return some;
}

/// |H| in the unit of its largest eigenvalue; 1 if it is zero everywhere: every uniform mesh serves a linear field
/// alike.
std::vector<Spectrum> in_own_unit(const Tensors& hessian) {
  std::vector<Spectrum> absolute = absolute_spectra(hessian);
  const double largest = largest_eigenvalue(absolute);
  if (largest > 0)
    divide(absolute, largest);
  else
    raise_flat(absolute, 0);
  return absolute;
}

/// Each field's metric gets the whole complexity: what one field needs does not depend on the unit of another.
std::vector<Spectrum> joint_spectra(const Mesh& mesh, std::span<const Tensors* const> hessians,
                                    const LpOptions& options, const Limits& bounds) {
  std::vector<Sym3> joint;
  for (const Tensors* hessian : hessians) {
    auto metric =
        scaled_to(options.complexity, Shape(mesh, in_own_unit(*hessian), {.norm = options.norm}, bounds)).metric;
    if (joint.empty()) {
      joint = std::move(metric);
      continue;
    }
    for_each_index(joint.size(), [&](std::size_t v) { joint[v] = intersect(joint[v], metric[v]); });
  }
  std::vector<Spectrum> spectra(joint.size());
  for_each_index(joint.size(), [&](std::size_t v) { spectra[v] = spectrum(joint[v]); });
  return spectra;
}

}  // namespace

ScaledMetric lp_metric(const Mesh& mesh, std::span<const Tensors> hessians, const LpOptions& options) {
  require_sound_arrays(mesh);
  require_options(options);
  if (hessians.empty()) throw InputError("no field found, expected one or more");
  for (const Tensors& hessian : hessians) require_tensors(hessian, mesh.points.size());
  const Limits limits = within_domain(mesh, options.limits);
  Limits bounds = limits;
  bounds.gradation.reset();
  const auto asking = those_that_ask(hessians);
  if (asking.size() == 1)
    return scaled_to(options.complexity, Shape(mesh, in_own_unit(*asking[0]), {.norm = options.norm}, limits));
  // What is left is a metric, which one factor scales: as for the maximum norm.
  const Optimum linear{.norm = std::numeric_limits<double>::infinity()};
  return scaled_to(options.complexity, Shape(mesh, joint_spectra(mesh, asking, options, bounds), linear, limits));
}

Tensors error_metric(const Mesh& mesh, const Tensors& hessian, double error, const Limits& limits) {
  require_sound_arrays(mesh);
  require_limits(limits);
  require_tensors(hessian, mesh.points.size());
  if (!(error > 0 && std::isfinite(error)))
    throw InputError(fmt::format("error {} found, expected a number above 0", error));
  constexpr double c = 9.0 / 32;
  std::vector<Spectrum> spectra = absolute_spectra(hessian);
  raise_flat(spectra, largest_eigenvalue(spectra));
  Tensors metric(spectra.size());
  for_each_index(metric.size(), [&](std::size_t v) {
    metric[v] = assemble({c / error * spectra[v].values, spectra[v].vectors});
  });
  return limited(mesh, std::move(metric), within_domain(mesh, limits));
}

}  // namespace taut
