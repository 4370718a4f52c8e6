#include "elasticity/elements.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"

namespace taut {
namespace {

// Of the product of three edges: below this a determinant is rounding.
constexpr double least_determinant = 1e-14;

struct Largest {
  double value = 0;
  void operator+=(const Largest& other) { value = std::max(value, other.value); }
};

// Its weight is the volume alone.
Element element_at(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 ab = b - a, ac = c - a, ad = d - a;
  const std::array<Vec3, 3> normal = {cross(ac, ad), cross(ad, ab), cross(ab, ac)};
  const double flat = least_determinant * norm(ab) * norm(ac) * norm(ad);
  const double six = std::max(dot(normal[2], ad), flat);
  Element element{{}, six / 6};
  for (std::size_t k = 0; k < 3; ++k) element.gradient[k + 1] = (1 / six) * normal[k];
  element.gradient[0] = -1 * (element.gradient[1] + element.gradient[2] + element.gradient[3]);
  return element;
}

}  // namespace

RawArray<Element> elements_of(const TetMesh& mesh, const Stiffening& stiffening) {
  RawArray<Element> elements(mesh.tets.size());
  const auto largest = sum_in_order<Largest>(mesh.tets.size(), [&](Largest& own, std::size_t t) {
    const auto& [v, links, state] = mesh.tets[t];
    if (!mesh.tets[t].alive()) return;
    elements[t] = element_at(mesh.x(v[0]), mesh.x(v[1]), mesh.x(v[2]), mesh.x(v[3]));
    own += Largest{elements[t].weight};
  });
  for_each_index(mesh.tets.size(), [&](std::size_t t) {
    if (!mesh.tets[t].alive()) return;
    double& weight = elements[t].weight;
    if (stiffening.exponent != 0) weight *= std::pow(weight / largest.value, -stiffening.exponent);
    if (!stiffening.factor_of_tet.empty()) weight *= stiffening.factor_of_tet[t];
  });
  return elements;
}

}  // namespace taut
