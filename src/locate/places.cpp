#include "locate/places.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"
#include "locate/cell_tree.hpp"
#include "locate/triangle_tree.hpp"
#include "mesh/hilbert.hpp"

namespace taut {
namespace {

constexpr std::size_t points_in_row = 1024;  // located one after another, each from the place of the one before
constexpr std::size_t sample_size = 1000;    // cells, of which the nearest begins a row
constexpr double rounding = 1e-9;            // weights above minus this count as not negative
constexpr double box_rounding = 1e-12;       // relative to the size of the mesh
constexpr int most_improvements = 8;

double least(const Weights& w) {
  return std::min(std::min(w[0], w[1]), std::min(w[2], w[3]));
}

// Of cells at equal steps along the Hilbert curve, the one nearest to x.
CellId nearest_of_sample(const Background& mesh, const Vec3& x) {
  const std::size_t step = mesh.cell_count() / sample_size + 1;
  CellId nearest{};
  double best = Box::huge;
  for (std::size_t c = 0; c < mesh.cell_count(); c += step) {
    const auto cell = static_cast<CellId>(c);
    const Vec3 away = mesh.x(mesh.vertices_of(cell)[0]) - x;
    if (dot(away, away) >= best) continue;
    best = dot(away, away);
    nearest = cell;
  }
  return nearest;
}

// A walk ends where no weight is below -1e-9. On to the neighbour that contains the point, if one does: extrapolation
// by so little would still be seen in linear fields.
void improve(const Background& mesh, const Vec3& x, Place& place) {
  for (int i = 0; i < most_improvements; ++i) {
    const auto worst = static_cast<std::size_t>(std::ranges::min_element(place.weights) - place.weights.begin());
    if (place.weights[worst] >= 0) return;
    const CellId next = mesh.neighbours_of(place.cell)[worst];
    if (next == none) return;
    const Weights weights = mesh.barycentric(next, x);
    if (!(least(weights) > place.weights[worst])) return;
    place.cell = next;
    place.weights = weights;
  }
}

// The points whose walk the boundary stopped, ascending.
std::vector<std::uint32_t> walk_to_all(const Background& mesh, std::span<const Vec3> points,
                                       std::vector<Place>& places) {
  const std::vector<std::uint32_t> order = hilbert_order(points);
  std::vector<std::uint8_t> found(points.size(), 0);
  const Chunks rows(points.size(), points_in_row);
  for_each_task(rows.size(), [&](std::size_t row, int) {
    CellId host = nearest_of_sample(mesh, points[order[rows.begin(row)]]);
    for (std::size_t i = rows.begin(row); i < rows.end(row); ++i) {
      const std::uint32_t p = order[i];
      Place& place = places[p];
      const bool arrived = mesh.walk(points[p], host, place.weights) && least(place.weights) >= -rounding;
      place.cell = host;
      if (!arrived) continue;
      improve(mesh, points[p], place);
      found[p] = 1;
    }
  });
  return indices_where(points.size(), [&](std::size_t p) { return found[p] == 0; });
}

// The first cell that contains the point or, as rounding may leave a gap between cells, comes nearest to it. False if
// none does.
bool search_cells(const Background& mesh, const CellTree& tree, const Vec3& x, Place& place) {
  const double by = box_rounding * norm(tree.around().high - tree.around().low);
  const Vec3 margin = {by, by, by};
  double best = -rounding;
  bool found = false;
  tree.for_each_near(Box{x - margin, x + margin}, [&](CellId cell) {
    if (best >= 0) return;
    const Weights weights = mesh.barycentric(cell, x);
    if (!(least(weights) > best)) return;
    best = least(weights);
    place = {cell, weights, 0};
    found = true;
  });
  return found;
}

// The boundary as triangles, and the face of a cell that each is.
class Boundary {
public:
  explicit Boundary(const Background& mesh)
      : mesh_(mesh),
        faces_(collect_in_order<Face>(Chunks(mesh.cell_count()),
                                      [&](std::vector<Face>& faces, std::size_t c) { add(faces, c); })),
        tree_(mesh.points(), triangles()) {}

  [[nodiscard]] Place nearest(const Vec3& x) const {
    const TriangleTree::Nearest at = tree_.closest(x);
    const Face& face = faces_[at.triangle];
    Place place{face.cell, {}, std::sqrt(at.squared_distance)};
    for (std::size_t k = 0; k < 3; ++k) place.weights[face_vertices[face.side][k]] = at.weights[k];
    return place;
  }

private:
  struct Face {
    CellId cell;
    std::uint32_t side;
  };

  void add(std::vector<Face>& faces, std::size_t c) const {
    const auto cell = static_cast<CellId>(c);
    for (std::uint32_t f = 0; f < 4; ++f)
      if (mesh_.neighbours_of(cell)[f] == none) faces.push_back({cell, f});
  }

  [[nodiscard]] std::vector<std::array<Index, 3>> triangles() const {
    std::vector<std::array<Index, 3>> corners(faces_.size());
    for_each_index(corners.size(), [&](std::size_t i) {
      const auto& v = mesh_.vertices_of(faces_[i].cell);
      const auto& k = face_vertices[faces_[i].side];
      corners[i] = {v[k[0]], v[k[1]], v[k[2]]};
    });
    return corners;
  }

  const Background& mesh_;
  std::vector<Face> faces_;
  TriangleTree tree_;
};

}  // namespace

std::vector<Place> places_of(const Background& mesh, std::span<const Vec3> points) {
  std::vector<Place> places(points.size());
  std::vector<std::uint32_t> lost = walk_to_all(mesh, points, places);
  if (lost.empty()) return places;
  std::vector<std::uint8_t> is_outside(points.size(), 0);
  const CellTree cells(mesh);
  for_each_index(lost.size(), [&](std::size_t i) {
    is_outside[lost[i]] = search_cells(mesh, cells, points[lost[i]], places[lost[i]]) ? 0 : 1;
  });
  const auto outside_ones = indices_where(points.size(), [&](std::size_t p) { return is_outside[p] != 0; });
  if (outside_ones.empty()) return places;
  const Boundary boundary(mesh);
  for_each_index(outside_ones.size(),
                 [&](std::size_t i) { places[outside_ones[i]] = boundary.nearest(points[outside_ones[i]]); });
  return places;
}

}  // namespace taut
