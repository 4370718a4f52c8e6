#include "program/meshes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>

#include "mesh/grid.hpp"

namespace taut::test {
namespace {

using Face = std::array<Index, 3>;

template <std::size_t n>
void put_elements(std::ostream& out, const char* keyword, const std::vector<std::array<Index, n>>& elements) {
  out << keyword << ' ' << elements.size() << '\n';
  for (const auto& element : elements) {
    for (const Index v : element) out << v + 1 << ' ';
    out << "0\n";
  }
}

/// The faces of only one tetrahedron, pointing outward, in the order of their sorted vertices.
std::map<Face, Face> boundary(const Mesh& mesh) {
  std::map<Face, Face> open;
  for (const auto& [a, b, c, d] : mesh.tetrahedra) {
    for (const Face& face : {Face{b, c, d}, Face{a, d, c}, Face{a, b, d}, Face{a, c, b}}) {
      Face key = face;
      std::ranges::sort(key);
      if (const auto [place, added] = open.emplace(key, face); !added) open.erase(place);
    }
  }
  return open;
}

template <std::size_t n>
Point centre_of(const Mesh& mesh, const std::array<Index, n>& element) {
  Point centre{};
  for (const Index v : element)
    for (std::size_t i = 0; i < 3; ++i) centre[i] += mesh.points[v][i] / n;
  return centre;
}

double distance_from_middle(const Point& x) {
  return std::max({std::abs(x[0] - 0.5), std::abs(x[1] - 0.5), std::abs(x[2] - 0.5)});
}

}  // namespace

const std::string two_tets = R"(MeshVersionFormatted 2
Dimension 3
Vertices 5
0 0 0 0
1 0 0 0
0 1 0 0
0 0 1 0
1 1 1 0
Tetrahedra 2
1 2 3 4 0
2 3 4 5 0
End
)";

std::string mesh_text(const Mesh& mesh) {
  std::ostringstream out;
  out.precision(17);
  out << "MeshVersionFormatted 2\nDimension 3\nVertices " << mesh.points.size() << '\n';
  for (const auto& [x, y, z] : mesh.points) out << x << ' ' << y << ' ' << z << " 0\n";
  put_elements(out, "Triangles", mesh.triangles);
  put_elements(out, "Tetrahedra", mesh.tetrahedra);
  out << "End\n";
  return out.str();
}

std::string metric_text(const Sizes& sizes) {
  std::ostringstream out;
  out << "MeshVersionFormatted 2\nDimension 3\nSolAtVertices " << sizes.size() << "\n1 1\n";
  for (const double h : sizes) out << h << '\n';
  out << "End\n";
  return out.str();
}

// Files hold xx, xy, yy, xz, yz, zz.
std::string metric_text(const Tensors& tensors) {
  std::ostringstream out;
  out << "MeshVersionFormatted 2\nDimension 3\nSolAtVertices " << tensors.size() << "\n1 3\n";
  for (const auto& [xx, xy, xz, yy, yz, zz] : tensors)
    out << xx << ' ' << xy << ' ' << yy << ' ' << xz << ' ' << yz << ' ' << zz << '\n';
  out << "End\n";
  return out.str();
}

Mesh cube(Index n) {
  Mesh mesh = grid(n);
  for (const auto& [sorted, face] : boundary(mesh)) mesh.triangles.push_back(face);
  return mesh;
}

Mesh room(Index n) {
  const Mesh whole = grid(n);
  Mesh mesh;
  std::map<Index, Index> renumbered;
  for (auto tetrahedron : whole.tetrahedra) {
    if (distance_from_middle(centre_of(whole, tetrahedron)) < 1.0 / 6) continue;
    for (Index& v : tetrahedron) {
      const auto [place, is_new] = renumbered.emplace(v, static_cast<Index>(mesh.points.size()));
      if (is_new) mesh.points.push_back(whole.points[v]);
      v = place->second;
    }
    mesh.tetrahedra.push_back(tetrahedron);
  }
  for (const auto& [sorted, face] : boundary(mesh)) {
    const Point centre = centre_of(mesh, face);
    mesh.triangles.push_back(face);
    mesh.triangle_refs.push_back(distance_from_middle(centre) < 0.4 ? 7 : centre[2] == 0 ? 2 : 1);
  }
  return mesh;
}

std::string changed(std::string text, std::string_view old, std::string_view now) {
  const std::size_t place = text.find(old);
  if (place == std::string::npos) throw std::logic_error("the text to change is not there");
  return text.replace(place, old.size(), now);
}

}  // namespace taut::test
