#include "partition/bisection.hpp"

#include <algorithm>
#include <cmath>

namespace taut {
namespace {

constexpr std::size_t samples_per_part = 512;
constexpr std::ptrdiff_t enough_samples = 1024;  // to choose a direction
constexpr double golden = 0.6180339887498949;
constexpr double sway = 0.16;  // how far the share below a plane varies around one half

// The directions to the sides, edges and corners of a cube. Their lengths do not matter.
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

// Multiples of the golden ratio, modulo 1: successive values are far apart, and no value occurs twice.
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

// Offset of the plane that has the given share of the samples below it.
double Bisection::place(const Vec3& normal, double share, Samples begin, Samples end) {
  for (auto s = begin; s != end; ++s) s->along = dot(normal, s->x);
  const auto middle = begin + std::max<std::ptrdiff_t>(1, std::lround(share * static_cast<double>(end - begin)));
  std::nth_element(begin, middle, end, [](const Sample& a, const Sample& b) { return a.along < b.along; });
  return middle->along;
}

// The normal of the plane that the fewest edges cross, estimated from some of the samples.
Vec3 Bisection::best_normal(double share, Samples begin, Samples end) {
  const std::ptrdiff_t stride = (end - begin) / enough_samples + 1;
  std::vector<Sample> some;
  for (auto s = begin; end - s > 0; s += std::min(stride, end - s)) some.push_back(*s);
  std::ptrdiff_t fewest = end - begin + 1;
  Vec3 best = normals[0];
  for (const Vec3& normal : normals) {
    const double offset = place(normal, share, some.begin(), some.end());
    const auto is_crossed = [&](const Sample& s) {
      return (s.along - offset) * (s.along - offset) < quadratic_form(s.ball, normal);
    };
    const auto crossed = std::ranges::count_if(some, is_crossed);
    if (crossed < fewest) best = normal;
    fewest = std::min(fewest, crossed);
  }
  return best;
}

void Bisection::split(Samples begin, Samples end, std::uint32_t parts, unsigned depth, unsigned round) {
  const auto at = nodes_.size();
  nodes_.emplace_back();
  if (parts == 1 || end - begin < 2) {
    nodes_[at].above = parts_++;
    return;
  }
  const double share = share_below(round, depth);
  const Vec3 normal = best_normal(share, begin, end);
  const double offset = place(normal, share, begin, end);
  const auto border = std::partition(begin, end, [&](const Sample& s) { return s.along < offset; });
  const auto below = std::clamp(static_cast<std::uint32_t>(std::lround(share * parts)), 1U, parts - 1);
  nodes_[at] = {false, 0, normal, offset};
  split(begin, border, below, depth + 1, round);
  nodes_[at].above = static_cast<std::uint32_t>(nodes_.size());
  split(border, end, parts - below, depth + 1, round);
}

}  // namespace taut
