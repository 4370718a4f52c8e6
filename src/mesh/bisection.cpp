#include "mesh/bisection.hpp"

#include <algorithm>
#include <cmath>

namespace taut {
namespace {

constexpr std::size_t samples_per_part = 512;
constexpr double golden = 0.6180339887498949;
constexpr double sway = 0.16;  // of the share below a plane, about one half

// Across the sides, edges and corners of a cube. Their lengths do not matter.
constexpr std::array<Vec3, 13> normals = {{{1, 0, 0},
                                           {0, 1, 0},
                                           {0, 0, 1},
                                           {1, 1, 0},
                                           {1, -1, 0},
                                           {1, 0, 1},
                                           {1, 0, -1},
                                           {0, 1, 1},
                                           {0, 1, -1},
                                           {1, 1, 1},
                                           {1, 1, -1},
                                           {1, -1, 1},
                                           {-1, 1, 1}}};

// Multiples of the golden ratio, modulo 1: successive ones are far apart, and no place is visited twice.
double share_below(unsigned round, unsigned depth) {
  const double place = round * golden + depth * golden * golden;
  return 0.5 + sway * (2 * (place - std::floor(place)) - 1);
}

Sym3 inverse(const Sym3& m) {
  const Sym3 a = adjugate(m);
  return 1 / (m[0] * a[0] + m[1] * a[1] + m[2] * a[2]) * a;
}

}  // namespace

Bisection::Bisection(const TetMesh& mesh, std::size_t part_size, unsigned round) {
  const auto wanted = static_cast<double>(mesh.vertex_count()) / static_cast<double>(part_size);
  const auto parts = static_cast<std::uint32_t>(std::max(1.0, std::round(wanted)));
  std::vector<Sample> samples;
  const std::size_t stride = std::max<std::size_t>(1, part_size / samples_per_part);
  for (std::size_t v = 0; parts > 1 && v < mesh.vertices.size(); v += stride)
    if (mesh.is_vertex_alive(static_cast<VertexId>(v)))
      samples.push_back({mesh.vertices[v].x, inverse(mesh.vertices[v].m)});
  split(samples.begin(), samples.end(), parts, 0, round);
}

Bisection::Plane Bisection::plane_across(const Vec3& normal, Samples begin, Samples middle, Samples end) {
  for (auto s = begin; s != end; ++s) s->along = dot(normal, s->x);
  std::nth_element(begin, middle, end, [](const Sample& a, const Sample& b) { return a.along < b.along; });
  const double offset = middle->along;
  const auto crosses = [&](const Sample& s) {
    const double distance = s.along - offset;
    return distance * distance < quadratic_form(s.ball, normal);
  };
  return {normal, offset, std::count_if(begin, end, crosses)};
}

void Bisection::split(Samples begin, Samples end, std::uint32_t parts, unsigned depth, unsigned round) {
  const auto at = nodes_.size();
  nodes_.emplace_back();
  if (parts == 1 || end - begin < 2) {
    nodes_[at].above = parts_++;
    return;
  }
  const double share = share_below(round, depth);
  const auto middle = begin + std::max<std::ptrdiff_t>(1, std::lround(share * static_cast<double>(end - begin)));
  Plane best = plane_across(normals[0], begin, middle, end);
  for (std::size_t i = 1; i < normals.size(); ++i) {
    const Plane plane = plane_across(normals[i], begin, middle, end);
    if (plane.crossed < best.crossed) best = plane;
  }
  const auto border = std::partition(begin, end, [&](const Sample& s) { return dot(best.normal, s.x) < best.offset; });
  const auto below = std::clamp(static_cast<std::uint32_t>(std::lround(share * parts)), 1U, parts - 1);
  nodes_[at] = {false, 0, best.normal, best.offset};
  split(begin, border, below, depth + 1, round);
  nodes_[at].above = static_cast<std::uint32_t>(nodes_.size());
  split(border, end, parts - below, depth + 1, round);
}

}  // namespace taut
