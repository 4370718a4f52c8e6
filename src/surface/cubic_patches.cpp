#include "surface/cubic_patches.hpp"

#include "base/parallel.hpp"
#include "surface/handles.hpp"
#include "surface/ridge_curves.hpp"

namespace taut {
namespace {

class PatchMaker {
public:
  PatchMaker(const Facets& facets, const EdgeShapes& shapes) : facets_(facets), shapes_(shapes) {}

  [[nodiscard]] CubicTriangle patch_over(TriangleId t) const {
    std::array<std::array<Vec3, 2>, 3> handles;
    for (std::size_t k = 0; k < 3; ++k) handles[k] = handles_of(t, k, (k + 1) % 3);
    return with_centre(places_of(facets_, t), handles);
  }

private:
  /// Of the edge from corner i to corner j.
  [[nodiscard]] std::array<Vec3, 2> handles_of(TriangleId t, std::size_t i, std::size_t j) const {
    const VertexId a = facets_.triangles[t][i], b = facets_.triangles[t][j];
    const Index ridge = shapes_.ridges_of[t][3 - i - j];
    if (ridge != none) {
      const CubicSegment& curve = shapes_.of_ridge[ridge];
      return a < b ? std::array{curve[1], curve[2]} : std::array{curve[2], curve[1]};
    }
    const Vec3 e = facets_.points[b] - facets_.points[a];
    const auto& sectors = shapes_.sectors.of_triangle[t];
    Vec3 out = projected_chord(e, shapes_.normals[sectors[i]]), in = projected_chord(e, shapes_.normals[sectors[j]]);
    const bool from_apex = shapes_.is_apex[a] != 0, to_apex = shapes_.is_apex[b] != 0;
    if (from_apex) out = to_apex ? 1 / norm(e) * e : reflected(in, e);
    if (to_apex) in = from_apex ? out : reflected(out, e);
    return {facets_.points[a] + handle_along(e, out), facets_.points[b] - handle_along(e, in)};
  }

  const Facets& facets_;
  const EdgeShapes& shapes_;
};

}  // namespace

std::vector<CubicTriangle> cubic_patches(const Facets& facets, const EdgeShapes& shapes) {
  const PatchMaker maker(facets, shapes);
  std::vector<CubicTriangle> patches(facets.triangles.size());
  for_each_index(patches.size(), [&](std::size_t t) { patches[t] = maker.patch_over(static_cast<TriangleId>(t)); });
  return patches;
}

}  // namespace taut
