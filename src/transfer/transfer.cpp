#include "taut/transfer.hpp"

#include <algorithm>
#include <numeric>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "mesh/build.hpp"
#include "mesh/door.hpp"
#include "taut/threads.hpp"
#include "transfer/interpolation.hpp"
#include "transfer/measures.hpp"
#include "transfer/projection.hpp"

namespace taut {
namespace {

/// A mesh as the transfer needs it: vertices and tetrahedra in Hilbert order.
struct Side {
  Background mesh;
  std::vector<std::uint32_t> point_of_vertex;
};

Side side_of(const Mesh& mesh) {
  Built built = build(mesh);
  return {Background(built.mesh), std::move(built.mesh.origin_of_vertex)};
}

using Seconds = std::vector<std::pair<std::string, double>>;

template <class Work>
auto timed(Seconds& seconds, const char* phase, Work work) {
  const Stopwatch watch;
  auto result = work();
  seconds.emplace_back(phase, watch.seconds());
  return result;
}

// The message of an error says which mesh it is about.
template <class Work>
auto about_target(Work work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw InputError(std::string("target: ") + error.what());
  }
}

std::vector<std::uint32_t> all_points(std::size_t count) {
  std::vector<std::uint32_t> points(count);
  std::iota(points.begin(), points.end(), 0U);
  return points;
}

class Run {
public:
  Run(const Mesh& from, const std::vector<Field>& fields, const Mesh& to, const TransferOptions& options)
      : from_(from), fields_(fields), to_(to), options_(options) {}

  Transferred operator()() {
    require_sound_arrays(from_);
    require_sound(fields_, from_.points.size());
    about_target([&] { require_sound_arrays(to_); });
    const Side source = timed(report().seconds, "build", [&] { return side_of(from_); });
    const Values values = gathered(fields_, source.point_of_vertex);
    const auto places = timed(report().seconds, "locate", [&] { return places_of(source.mesh, to_.points); });
    count_outside(places);
    Values result = timed(report().seconds, "interpolate", [&] { return interpolated(source.mesh, values, places); });
    if (options_.method == Transfer::conservative) project(source, values, places, result);
    timed(report().seconds, "measure", [&] { return measure(result), 0; });
    result_.fields = split(result, fields_);
    return std::move(result_);
  }

private:
  void count_outside(const std::vector<Place>& places) {
    for (const Place& place : places) {
      report().outside += place.distance > 0 ? 1 : 0;
      report().distance_max = std::max(report().distance_max, place.distance);
    }
  }

  // Replaces the interpolated values at the points that belong to a tetrahedron.
  void project(const Side& source, const Values& values, const std::vector<Place>& places, Values& result) {
    const Side target =
        timed(report().seconds, "build target", [&] { return about_target([&] { return side_of(to_); }); });
    const auto& points = target.point_of_vertex;
    std::vector<Place> starts(points.size());
    Values values_there(values.size, points.size());
    for_each_index(points.size(), [&](std::size_t v) {
      starts[v] = places[points[v]];
      std::ranges::copy(std::as_const(result)[points[v]], values_there[v].begin());
    });
    const System system = timed(report().seconds, "intersect", [&] {
      const Integrals integrals = integrate(source.mesh, values, target.mesh, starts);
      report().overlaps = integrals.overlaps;
      report().covered_volume = integrals.volume;
      return assemble(integrals, target.mesh);
    });
    const Values projected = timed(report().seconds, "solve", [&] {
      const Values smooth = lumped(system, std::move(values_there));
      return corrected(system, smooth, solve(system, smooth), options_.limited);
    });
    for_each_index(points.size(), [&](std::size_t v) { std::ranges::copy(projected[v], result[points[v]].begin()); });
  }

  void measure(const Values& result) {
    const MeshMeasures before = measured(from_, gathered(fields_, all_points(from_.points.size())));
    const MeshMeasures after = measured(to_, result);
    report().volume_before = before.volume;
    report().volume_after = after.volume;
    std::size_t c = 0;
    for (const Field& field : fields_) {
      auto& components = report().fields.emplace_back();
      for (const std::size_t end = c + field.size(); c < end; ++c) {
        const Measures &old = before.components[c], &now = after.components[c];
        components.push_back({old.mass, now.mass, old.least, old.greatest, now.least, now.greatest});
      }
    }
  }

  TransferReport& report() { return result_.report; }

  const Mesh& from_;
  const std::vector<Field>& fields_;
  const Mesh& to_;
  const TransferOptions& options_;
  Transferred result_;
};

}  // namespace

Transferred transfer(const Mesh& from, const std::vector<Field>& fields, const Mesh& to,
                     const TransferOptions& options) {
  Transferred result;
  on_threads(options.threads, [&] { result = Run(from, fields, to, options)(); });
  return result;
}

}  // namespace taut
