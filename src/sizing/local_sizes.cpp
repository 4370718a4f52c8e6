#include "taut/local_sizes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "base/buckets.hpp"
#include "base/parallel.hpp"
#include "mesh/door.hpp"
#include "metric/field.hpp"
#include "metric/intersection.hpp"
#include "metric/spectral.hpp"
#include "sizing/limits.hpp"
#include "sizing/surface_curvatures.hpp"
#include "sizing/truncation.hpp"
#include "surface/ridge_angle.hpp"
#include "surface/surface_input.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

/// Of the entities of one kind, all of which have one reference.
struct Wanted {
  std::string_view kind;
  int ref;
  const LocalSize& size;

  void require(bool holds, std::string_view key, double found, std::string_view expected) const {
    if (!holds)
      throw InputError(fmt::format("local sizes: {}.{}.{}: {} found, expected {}", kind, ref, key, found, expected));
  }
};

/// Whether h^-2 is a positive double.
bool is_size(double h) {
  return h > 0 && is_positive_definite(metric_of_size(h));
}

bool is_size_or_none(double h) {
  return is_size(h) || h == std::numeric_limits<double>::infinity();
}

void require_sound(const Wanted& wanted) {
  const auto& [size, min, max, deviation] = wanted.size;
  wanted.require(is_size_or_none(size), "size", size, "a number above 0");
  wanted.require(min == 0 || is_size(min), "min", min, "a number, 0 or more");
  wanted.require(is_size_or_none(max), "max", max, "a number above 0");
  wanted.require(deviation >= 0 && std::isfinite(deviation), "deviation", deviation, "a number, 0 or more");
  wanted.require(min <= max, "min", min, fmt::format("at most {}, the max", max));
  wanted.require(min <= size, "min", min, fmt::format("at most {}, the size", size));
}

void require_sound(const LocalSizes& sizes) {
  const auto all = [](std::string_view kind, const std::map<int, LocalSize>& by_ref) {
    for (const auto& [ref, size] : by_ref) {
      const Wanted wanted{kind, ref, size};
      require_sound(wanted);
      wanted.require(size.deviation == 0 || kind == "triangles", "deviation", size.deviation, "it for triangles only");
    }
  };
  all("points", sizes.points);
  all("edges", sizes.edges);
  all("triangles", sizes.triangles);
  all("tetrahedra", sizes.tetrahedra);
  require_ridge_angle(sizes.ridge_angle);
}

/// What all entities at a point want.
class Demands {
public:
  explicit Demands(std::size_t points) : of_point_(points) {}

  /// Adds the sizes for entities of one kind: points_of(i) are those of entity i, and `refs` may be empty.
  template <class PointsOf>
  void add(std::string_view kind, const std::map<int, LocalSize>& by_ref, std::size_t entities,
           std::span<const int> refs, PointsOf points_of) {
    if (by_ref.empty()) return;
    std::map<int, LocalSize> unseen = by_ref;
    for (std::size_t i = 0; i < entities; ++i) {
      const int ref = refs.empty() ? 0 : refs[i];
      const auto found = by_ref.find(ref);
      if (found == by_ref.end()) continue;
      unseen.erase(ref);
      for (const Index p : points_of(i)) add(p, found->second);
    }
    if (!unseen.empty())
      throw InputError(fmt::format("local sizes: {}.{}: none of the mesh's {} {} has this reference", kind,
                                   unseen.begin()->first, entities, kind));
  }

  /// `curved` is what deviations ask for.
  [[nodiscard]] Sym3 applied(std::size_t point, const Sym3& m, std::span<const Sym3> curved) const {
    const LocalSize& wanted = of_point_[point];
    Sym3 result = truncate(m, {.hmax = wanted.size});
    for (const Sym3& other : curved) result = intersect(result, other);
    return truncate(truncate(result, {.hmin = wanted.min}), {.hmax = wanted.max});
  }

private:
  void add(Index point, const LocalSize& wanted) {
    LocalSize& all = of_point_[point];
    all.size = std::min(all.size, wanted.size);
    all.min = std::max(all.min, wanted.min);
    all.max = std::min(all.max, wanted.max);
  }

  std::vector<LocalSize> of_point_;  ///< without deviations
};

Demands demands_of(const Mesh& mesh, const LocalSizes& sizes) {
  Demands demands(mesh.points.size());
  demands.add("points", sizes.points, mesh.points.size(), mesh.point_refs,
              [](std::size_t i) { return std::array{static_cast<Index>(i)}; });
  demands.add("edges", sizes.edges, mesh.edges.size(), mesh.edge_refs, [&](std::size_t i) { return mesh.edges[i]; });
  demands.add("tetrahedra", sizes.tetrahedra, mesh.tetrahedra.size(), mesh.tetrahedron_refs,
              [&](std::size_t i) { return mesh.tetrahedra[i]; });
  if (sizes.triangles.empty()) return demands;
  const SurfaceInput surface = surface_of(mesh);
  const auto& triangles = surface.facets.triangles;
  demands.add("triangles", sizes.triangles, triangles.size(), surface.refs,
              [&](std::size_t i) { return indices(triangles[i]); });
  return demands;
}

/// The metrics that deviations ask for, by point: one for each smooth side.
Buckets<Sym3> curved_metrics(const Mesh& mesh, const LocalSizes& sizes) {
  const auto asks = [](const auto& entry) { return entry.second.deviation > 0; };
  if (std::ranges::none_of(sizes.triangles, asks)) return gather<Sym3>(0, mesh.points.size(), [](std::size_t, auto) {});
  const SurfaceCurvatures found = surface_curvatures(mesh, sizes.ridge_angle);
  const Limits limits = within_domain(mesh, {});
  return gather<Sym3>(found.points.size(), mesh.points.size(), [&](std::size_t s, auto put) {
    const auto wanted = sizes.triangles.find(found.refs[s]);
    if (wanted == sizes.triangles.end() || wanted->second.deviation == 0) return;
    put(found.points[s],
        metric_of_curvatures(found.curvatures[s], {.deviation = deviation_of_chords * wanted->second.deviation,
                                                   .ridge_angle = sizes.ridge_angle,
                                                   .limits = limits}));
  });
}

}  // namespace

Tensors with_local_sizes(const Mesh& mesh, Tensors metric, const LocalSizes& sizes) {
  require_sound_arrays(mesh);
  require_sound(sizes);
  metric = tensors_at(mesh, Metric{std::move(metric)});
  const Demands demands = demands_of(mesh, sizes);
  const Buckets<Sym3> curved = curved_metrics(mesh, sizes);
  for_each_index(metric.size(), [&](std::size_t p) { metric[p] = demands.applied(p, metric[p], curved[p]); });
  return metric;
}

}  // namespace taut
