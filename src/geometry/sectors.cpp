#include "geometry/sectors.hpp"

#include "base/disjoint_sets.hpp"

namespace taut {
namespace {

std::uint32_t place_at(const TetMesh& mesh, TriangleId t, VertexId v) {
  const auto& of = mesh.triangles[t].v;
  return 3 * t + (of[0] == v ? 0U : of[1] == v ? 1U : 2U);
}

}  // namespace

Sectors find_sectors(const TetMesh& mesh, const std::vector<EdgeUse>& uses, std::vector<Feature> features) {
  std::erase_if(features, [](const Feature& f) { return !f.sharp; });
  const std::size_t places = 3 * mesh.triangles.size();  // corner k of triangle t: 3 t + k
  DisjointSets sets(places);
  for_each_smooth_edge(uses, features, [&](const EdgeUse& s, const EdgeUse& t) {
    for (const VertexId v : s.edge) sets.join(place_at(mesh, s.triangle, v), place_at(mesh, t.triangle, v));
  });
  Sectors sectors;
  sectors.of_triangle.resize(mesh.triangles.size());
  for (std::uint32_t place = 0; place < places; ++place) {
    const std::uint32_t root = sets.root(place);
    auto& sector = sectors.of_triangle[place / 3][place % 3];
    sector =
        root == place ? static_cast<std::uint32_t>(sectors.vertices.size()) : sectors.of_triangle[root / 3][root % 3];
    if (root == place) sectors.vertices.push_back(mesh.triangles[place / 3].v[place % 3]);
  }
  return sectors;
}

}  // namespace taut
