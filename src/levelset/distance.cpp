#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/box.hpp"
#include "base/parallel.hpp"
#include "levelset/samples.hpp"
#include "levelset/surface_door.hpp"
#include "locate/triangle_tree.hpp"
#include "taut/surface_distance.hpp"

namespace taut {
namespace {

constexpr std::size_t rows_per_distance_task = 1024;
constexpr double samples_across = 500;  // the diagonal, if no spacing is given

void require_triangles(const SurfaceMesh& surface, const char* name) {
  require_sound(surface, name);
  if (surface.triangles.empty()) throw InputError(fmt::format("{}: no triangles found, expected at least one", name));
}

void require_options(const DistanceOptions& options) {
  if (!(options.spacing >= 0 && std::isfinite(options.spacing)))
    throw InputError(fmt::format("spacing: {} found, expected a number, 0 or more", options.spacing));
  if (options.divisions < 1)
    throw InputError(fmt::format("divisions: {} found, expected 1 or more", options.divisions));
}

double diagonal_of_both(const SurfaceMesh& first, const SurfaceMesh& second) {
  Box box;
  for (const SurfaceMesh* surface : {&first, &second})
    for (const auto& triangle : surface->triangles)
      for (const Index v : triangle) box.include(surface->points[v]);
  return box.diagonal();
}

/// What the samples of some rows add up to.
struct RowSum {
  double worst = -1, integral = 0, area = 0;
  Point where{};
  std::size_t samples = 0;

  void add_sample(const Vec3& x, double share, double distance) {
    integral += share * distance;
    area += share;
    ++samples;
    if (distance > worst) {
      worst = distance;
      where = x;
    }
  }
  RowSum& operator+=(const RowSum& other) {
    integral += other.integral;
    area += other.area;
    samples += other.samples;
    if (other.worst > worst) {
      worst = other.worst;
      where = other.where;
    }
    return *this;
  }
};

RowSum sum_of_rows(const Samples& samples, const TriangleTree& other) {
  const Chunks chunks(samples.rows(), rows_per_distance_task);
  std::vector<RowSum> sums(chunks.size());
  for_each_task(chunks.size(), [&](std::size_t chunk, int) {
    RowSum sum;
    Index guess = 0;  // only makes the search faster
    for (std::size_t row = chunks.begin(chunk); row < chunks.end(chunk); ++row)
      samples.for_each_in_row(row, [&](const Vec3& x, double share) {
        const TriangleTree::Nearest nearest = other.closest(x, guess);
        guess = nearest.triangle;
        sum.add_sample(x, share, std::sqrt(nearest.squared_distance));
      });
    sums[chunk] = sum;
  });
  RowSum total;
  for (const RowSum& sum : sums) total += sum;
  return total;
}

/// The mean of a surface without area is not defined; no mean is above the worst.
double mean_of(const RowSum& sum) {
  return sum.area > 0 ? sum.integral / sum.area : sum.worst;
}

Deviation deviation_of(const RowSum& sum) {
  return {.worst = sum.worst, .where = sum.where, .mean = mean_of(sum), .area = sum.area, .samples = sum.samples};
}

RowSum sum_from(const SurfaceMesh& surface, const SurfaceMesh& other, double spacing, int divisions) {
  return sum_of_rows(Samples(surface, spacing, divisions), TriangleTree(other.points, other.triangles));
}

}  // namespace

SurfaceDistance distance(const SurfaceMesh& first, const SurfaceMesh& second, const DistanceOptions& options) {
  require_triangles(first, "first surface");
  require_triangles(second, "second surface");
  require_options(options);
  // Two single points have no diagonal; any spacing does for them.
  const double diagonal = std::max(diagonal_of_both(first, second), std::numeric_limits<double>::min());
  const double spacing = options.spacing > 0 ? options.spacing : diagonal / samples_across;
  RowSum there = sum_from(first, second, spacing, options.divisions);
  const RowSum back = sum_from(second, first, spacing, options.divisions);
  SurfaceDistance result{.from_first = deviation_of(there), .from_second = deviation_of(back)};
  there += back;
  result.worst = there.worst;
  result.mean = mean_of(there);
  return result;
}

}  // namespace taut
