#include "sizing/surface_curvature.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/each_once.hpp"
#include "base/parallel.hpp"
#include "geometry/patches.hpp"
#include "sizing/jet.hpp"
#include "sizing/neighbourhood.hpp"
#include "sizing/principal_curvatures.hpp"

namespace taut {
namespace {

constexpr std::size_t fewest_points_of_jet = 8;  // 1.5 for each coefficient of a quadratic polynomial
constexpr int fewest_rings_of_jet = 3;           // two do not hold enough points for the fourth degree
constexpr int most_rings_of_jet = 5;
constexpr double least_cosine = 0.2;  ///< between the normals of a sector and its neighbour: the surface folds beyond

struct Orientation {
  Vec3 normal{};
  bool known = false;  ///< whether the surface has an outside, so that the sense of the normal means something
};

/// The edges between sectors, each once.
std::vector<std::array<Index, 2>> edges_between(const Sectors& sectors) {
  std::vector<std::array<Index, 2>> edges;
  edges.reserve(3 * sectors.of_triangle.size());
  for (const auto& s : sectors.of_triangle)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [p, q] = std::minmax(s[k], s[(k + 1) % 3]);
      edges.push_back({p, q});
    }
  keep_each_once(edges);
  return edges;
}

/// Max's weights, with which the normals of a sphere's vertices are exact (Max 1999).
Vec3 weighted_normal(const TetMesh& mesh, const Triangle& t, std::size_t k) {
  const Vec3 a = mesh.x(t.v[(k + 1) % 3]) - mesh.x(t.v[k]), b = mesh.x(t.v[(k + 2) % 3]) - mesh.x(t.v[k]);
  return 1 / (dot(a, a) * dot(b, b)) * cross(a, b);
}

// Triangles inside the domain may have either orientation, so they are turned to agree with those before them.
std::vector<Orientation> orientations(const TetMesh& mesh, const Sectors& sectors) {
  std::vector<Orientation> all(sectors.vertices.size());
  for (const TriangleId id : mesh.triangle_ids()) {
    const Triangle& t = mesh.triangles[id];
    for (std::size_t k = 0; k < 3; ++k) {
      Orientation& of = all[sectors.of_triangle[id][k]];
      of.known = t.side[1] == outside;
      const Vec3 n = weighted_normal(mesh, t, k);
      of.normal = of.normal + (of.known || dot(n, of.normal) >= 0 ? 1.0 : -1.0) * n;
    }
  }
  for (Orientation& of : all) {
    const double length = norm(of.normal);
    of.normal = length > 0 ? 1 / length * of.normal : Vec3{0, 0, 1};  // triangles that lie on each other have none
  }
  return all;
}

class CurvatureFinder {
public:
  CurvatureFinder(const TetMesh& mesh, const Sectors& sectors)
      : mesh_(mesh),
        sectors_(sectors),
        orientations_(orientations(mesh, sectors)),
        neighbours_(neighbours_of_vertices(edges_between(sectors), sectors.vertices.size())),
        tolerance_(flatness_tolerance(mesh)) {}

  [[nodiscard]] std::vector<Spectrum> run() const {
    std::vector<Spectrum> found(sectors_.vertices.size());
    std::vector<std::optional<Neighbourhood>> scratch(static_cast<std::size_t>(worker_count()));
    const Chunks chunks(found.size(), 512);
    for_each_task(chunks.size(), [&](std::size_t chunk, int worker) {
      auto& around = scratch[static_cast<std::size_t>(worker)];
      if (!around) around.emplace(neighbours_);
      for (std::size_t s = chunks.begin(chunk); s < chunks.end(chunk); ++s)
        found[s] = principal_curvatures(
            jet(orientations_[s].normal, offsets_around(static_cast<Index>(s), *around), tolerance_));
    });
    return found;
  }

private:
  [[nodiscard]] std::vector<Vec3> offsets_around(Index centre, Neighbourhood& around) const {
    std::vector<Vec3> offsets;
    around.start_at(centre);
    std::size_t added = 1;
    for (int ring = 1; ring <= (offsets.size() < fewest_points_of_jet ? most_rings_of_jet : fewest_rings_of_jet);
         ++ring) {
      around.grow();
      for (; added < around.vertices().size(); ++added) {
        const Index s = around.vertices()[added];
        if (face_alike(centre, s))
          offsets.push_back(mesh_.x(sectors_.vertices[s]) - mesh_.x(sectors_.vertices[centre]));
      }
    }
    return offsets;
  }

  // A neighbour on the other side of a thin part belongs to another sheet of the surface.
  [[nodiscard]] bool face_alike(Index s, Index t) const {
    const double cosine = dot(orientations_[s].normal, orientations_[t].normal);
    return (orientations_[s].known ? cosine : std::abs(cosine)) >= least_cosine;
  }

  const TetMesh& mesh_;
  const Sectors& sectors_;
  std::vector<Orientation> orientations_;
  Buckets<Index> neighbours_;
  double tolerance_;
};

}  // namespace

std::vector<Spectrum> curvatures_of(const TetMesh& mesh, const Sectors& sectors) {
  return CurvatureFinder(mesh, sectors).run();
}

}  // namespace taut
