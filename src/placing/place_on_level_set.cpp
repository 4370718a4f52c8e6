#include <fmt/format.h>

#include <utility>

#include "adapt/result.hpp"
#include "adapt/setup.hpp"
#include "geometry/off_surface.hpp"
#include "mesh/order.hpp"
#include "placing/placing.hpp"
#include "sizing/nodal.hpp"
#include "taut/placing.hpp"

namespace taut {
namespace {

/// The values of the vertices in their new order.
std::vector<double> renumbered(const std::vector<double>& values, const Renumbering& renumbering, std::size_t count) {
  std::vector<double> result(count);
  for (std::size_t v = 0; v < renumbering.vertex.size(); ++v)
    if (renumbering.vertex[v] != none) result[renumbering.vertex[v]] = values[v];
  return result;
}

AdaptOptions adapt_options(const PlaceOptions& options) {
  AdaptOptions result;
  result.surface = options.surface;
  result.ridge_angle = options.ridge_angle;
  result.geometry = options.geometry;
  return result;
}

template <class MakeFunction>
Placed place(const Mesh& mesh, const Metric& metric, const PlaceOptions& options, MakeFunction make_function) {
  Placed result;
  Session session = set_up(mesh, metric, adapt_options(options), result.adapted.report);
  const LevelFunction function = make_function(session);
  Placing placing(session, function, options);
  placing.run();
  result.adapted.report.off_surface = vertices_off_surface(session.mesh, session.model).size();
  result.moved = placing.moved();
  result.inserted = placing.inserted();
  result.crossed = placing.crossed();
  const Renumbering renumbering = reorder(session.mesh);
  result.values = renumbered(placing.values(), renumbering, session.mesh.vertices.size());
  assemble(std::move(session), mesh, result.adapted);
  return result;
}

void require(const PlaceOptions& o) {
  if (!(o.Q_max > 1)) throw InputError(fmt::format("Q_max {} found, expected a number above 1", o.Q_max));
  if (!(o.deviation >= 0)) throw InputError(fmt::format("deviation {} found, expected 0 or more", o.deviation));
  require_options(adapt_options(o));
}

}  // namespace

Placed place_on_level_set(const Mesh& mesh, const Metric& metric, const ScalarFunction& u,
                          const PlaceOptions& options) {
  require(options);
  return place(mesh, metric, options, [&](const Session&) { return LevelFunction(u); });
}

Placed place_on_level_set(const Mesh& mesh, const Metric& metric, std::span<const double> values,
                          const PlaceOptions& options) {
  require(options);
  require_values(values, mesh.points.size());
  return place(mesh, metric, options, [&](const Session& session) { return LevelFunction(mesh, values, session); });
}

}  // namespace taut
