// Meshes whose vertices lie where they must not: refused, whatever the order in which their tetrahedra list them.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "mesh/build.hpp"
#include "mesh/invariants.hpp"
#include "mesh/shapes.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

double six_volumes_of(const Mesh& mesh, const std::array<Index, 4>& v) {
  return six_volumes(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]);
}

// The index of the first tetrahedron that shares a face with one of the other sign; the number of all if none does.
std::size_t first_overlap(const Mesh& mesh) {
  const auto share_a_face = [](const auto& v, const auto& w) {
    return std::ranges::count_if(v, [&](Index i) { return std::ranges::find(w, i) != w.end(); }) == 3;
  };
  const auto is_negative = [&](const auto& v) { return six_volumes_of(mesh, v) < 0; };
  const auto overlaps_one = [&](const auto& v) {
    return std::ranges::any_of(mesh.tetrahedra,
                               [&](const auto& w) { return share_a_face(v, w) && is_negative(v) != is_negative(w); });
  };
  return static_cast<std::size_t>(std::ranges::find_if(mesh.tetrahedra, overlaps_one) - mesh.tetrahedra.begin());
}

std::string complaint_about(const Mesh& mesh) {
  try {
    const Built built = build(mesh);
    EXPECT_EQ(first_broken_invariant(built.mesh), "");
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

// Turning tetrahedra round in the list must not make a difference.
Mesh flipped(Mesh mesh, unsigned seed) {
  std::mt19937 generator(seed);
  for (auto& v : mesh.tetrahedra)
    if (generator() % 2 == 0) std::swap(v[1], v[3]);
  return mesh;
}

TEST(Tangle, IsRefusedNamingTheFirstTetrahedronThatOverlapsItsNeighbour) {
  Mesh mesh = test::cube(4);
  for (int d = 0; d < 3; ++d) mesh.points[62][d] += 0.35 * std::array{1.0, 0.3, 0.1}[d];  // the middle vertex
  ASSERT_EQ(std::ranges::count_if(mesh.tetrahedra, [&](const auto& v) { return six_volumes_of(mesh, v) < 0; }), 4);
  const std::string expected = fmt::format("tetrahedron {} (", first_overlap(mesh) + 1);
  EXPECT_TRUE(complaint_about(mesh).starts_with(expected)) << complaint_about(mesh);
  EXPECT_TRUE(complaint_about(flipped(mesh, 1)).starts_with(expected)) << complaint_about(flipped(mesh, 1));
}

TEST(Tangle, OfRandomVerticesIsFoundAndOnlyThat) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> offset(-1, 1);
  int tangled = 0, sound = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    Mesh mesh = test::cube(3);
    const double amount = 0.05 + 0.001 * seed;
    for (Point& p : mesh.points)
      if (std::ranges::all_of(p, [](double c) { return c > 0 && c < 1; }))
        for (double& c : p) c += amount * offset(generator);
    const std::size_t first = first_overlap(mesh);
    const std::string complaint = complaint_about(flipped(mesh, seed));
    const bool is_sound = first == mesh.tetrahedra.size();
    ++(is_sound ? sound : tangled);
    EXPECT_EQ(complaint.empty(), is_sound) << complaint;
    const bool names_it = complaint.starts_with(fmt::format("tetrahedron {} (", first + 1));
    EXPECT_NE(names_it, is_sound) << complaint;
  }
  EXPECT_GT(tangled, 50);
  EXPECT_GT(sound, 50);
}

TEST(Tangle, IsNoMeshThatIsAllTurnedRound) {
  Mesh mesh = test::cube(3);
  for (Point& p : mesh.points) p[0] = -p[0];
  EXPECT_EQ(complaint_about(mesh), "");
}

}  // namespace
}  // namespace taut
