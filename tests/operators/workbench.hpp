// A mesh ready for operations, and what no operation may change.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <set>
#include <tuple>

#include "adapt/setup.hpp"
#include "geometry/classified.hpp"
#include "mesh/invariants.hpp"
#include "mesh/shapes.hpp"
#include "metric/quality.hpp"
#include "metric/random_metrics.hpp"
#include "operators/kernel.hpp"
#include "surface/surface_edges.hpp"

namespace taut::test {

class Workbench {
public:
  explicit Workbench(const Mesh& input, const Metric& metric, Surface surface = Surface::adapt)
      : session_(set_up(input, metric, with(surface), report_)) {
    block.borrow(mesh, ids);
  }
  Workbench(const Workbench&) = delete;
  Workbench& operator=(const Workbench&) = delete;

private:
  static AdaptOptions with(Surface surface) {
    AdaptOptions options;
    options.surface = surface;
    return options;
  }

  Report report_;
  Session session_;

public:
  TetMesh& mesh = session_.mesh;
  const Model& model = session_.model;
  const Target& target = *session_.target;
  Block block;  // the whole mesh
  Kernel kernel{mesh, model, target, &block};

  /// Returns the unused ids, so that the mesh can be inspected, and borrows new ones.
  template <class Inspection>
  void settled(Inspection inspect) {
    block.give_back(mesh);
    inspect();
    block.borrow(mesh, ids);
  }
  /// As many ids as at the start.
  void replenish() {
    settled([] {});
  }

private:
  static constexpr IdNeed ids{.vertices = 20, .tets = 200, .triangles = 40};
};

/// The living entities of a mesh from which ids are borrowed.
inline std::vector<VertexId> living_vertices(const TetMesh& mesh) {
  std::vector<VertexId> living;
  for (const VertexId v : ids<VertexId>(mesh.vertices.size()))
    if (mesh.is_vertex_alive(v)) living.push_back(v);
  return living;
}
inline std::vector<TetId> living_tets(const TetMesh& mesh) {
  std::vector<TetId> living;
  for (const TetId t : ids<TetId>(mesh.tets.size()))
    if (mesh.tets[t].alive()) living.push_back(t);
  return living;
}
inline std::size_t living_triangle_count(const TetMesh& mesh) {
  return static_cast<std::size_t>(std::ranges::count_if(mesh.triangles, &Triangle::alive));
}

/// All that a refused operation must not touch: everything but the adaptation's notes, of which it must not touch the
/// qualities.
struct Snapshot {
  explicit Snapshot(const TetMesh& m)
      : mesh(m), living{living_vertices(m).size(), living_tets(m).size(), living_triangle_count(m)} {}

  [[nodiscard]] bool operator==(const Snapshot& o) const {
    return living == o.living && values_of(mesh) == values_of(o.mesh);
  }

  TetMesh mesh;
  std::array<std::size_t, 3> living;  ///< vertices, tetrahedra, triangles

private:
  using Values = std::vector<double>;

  static void add(Values& values, const Vertex& v) {
    values.insert(values.end(), v.x.begin(), v.x.end());
    values.insert(values.end(), v.m.begin(), v.m.end());
  }
  static void add(Values& values, const Tet& t) {
    values.insert(values.end(), t.v.begin(), t.v.end());
    for (FaceLink n : t.n) values.push_back(n.bits());
    values.push_back(t.state.quality);
  }
  static void add(Values& values, const Triangle& t) {
    values.insert(values.end(), t.v.begin(), t.v.end());
    for (FaceLink side : t.side) values.push_back(side.bits());
    values.insert(values.end(), t.line.begin(), t.line.end());
    values.push_back(t.patch);
  }
  static void add(Values& values, Tag tag) {
    values.insert(values.end(), {double(tag.dimension()), double(tag.patch())});
  }
  static void add(Values& /*values*/, const VertexState& /*notes*/) {}
  template <class Id>
  static void add(Values& values, Id id) {
    values.push_back(id);
  }

  [[nodiscard]] static Values values_of(const TetMesh& m) {
    Values values;
    const auto add_all = [&](const auto& array, const auto&) {
      for (const auto& entry : array) add(values, entry);
    };
    TetMesh::for_each_vertex_array(m, add_all);
    TetMesh::for_each_tet_array(m, add_all);
    TetMesh::for_each_triangle_array(m, add_all);
    return values;
  }
};

/// What no operation may change: volumes of regions, areas of patches, lengths of lines, places of corners. Where the
/// surface is curved, flat triangles and straight edges only come near it: what is bent may change a little.
struct Conserved {
  struct Sums {
    std::map<std::uint32_t, double> of;
    std::set<std::uint32_t> bent{};
  };
  Sums volume, area, length;
  std::set<Vec3> corners;
};

inline Conserved conserved_by(const Workbench& bench) {
  const TetMesh& m = bench.mesh;
  Conserved sums;
  for (TetId t : living_tets(m)) {
    const auto& v = m.tets[t].v;
    sums.volume.of[m.region_of_tet[t]] += six_volumes(m.x(v[0]), m.x(v[1]), m.x(v[2]), m.x(v[3])) / 6;
  }
  for (const Triangle& t : m.triangles) {
    if (!t.alive()) continue;
    sums.area.of[t.patch] += norm(cross(m.x(t.v[1]) - m.x(t.v[0]), m.x(t.v[2]) - m.x(t.v[0]))) / 2;
    if (bench.model.patches[t.patch].curved() != nullptr) {
      sums.area.bent.insert(t.patch);
      for (const FaceLink side : t.side)
        if (side != outside) sums.volume.bent.insert(m.region_of_tet[side.tet()]);
    }
    for (int k = 0; k < 3; ++k) {
      if (t.line[k] == none) continue;
      sums.length.of[t.line[k]] += norm(m.x(t.v[(k + 1) % 3]) - m.x(t.v[(k + 2) % 3]));
      if (!std::holds_alternative<Bent>(bench.model.lines[t.line[k]].shape)) continue;
      sums.length.bent.insert(t.line[k]);
      sums.area.bent.insert(t.patch);
    }
  }
  for (VertexId v : living_vertices(m))
    if (m.tag_of_vertex[v].dimension() == 0) sums.corners.insert(m.x(v));
  return sums;
}

inline void expect_near(const Conserved::Sums& found, const Conserved::Sums& expected, const char* what) {
  ASSERT_EQ(found.of.size(), expected.of.size()) << what;
  for (const auto& [id, value] : expected.of)
    ASSERT_NEAR(found.of.at(id), value, expected.bent.contains(id) ? 0.15 * value : 1e-13 * (1 + value))
        << what << " " << id;
}

inline void expect_on_geometry(const Workbench& bench) {
  const TetMesh& m = bench.mesh;
  for (VertexId v : living_vertices(m)) {
    const Tag tag = m.tag_of_vertex[v];
    if (tag.dimension() == 0 || tag.dimension() == 3) continue;
    const double tolerance = bench.model.surface.exists() ? 1e-9 : 1e-13;  // where Newton's method ends
    ASSERT_LT(norm(bench.model.project(tag, m.x(v)) - m.x(v)), tolerance) << "vertex " << v << " has left its place";
  }
  std::vector<Triangle> living;
  for (const Triangle& t : m.triangles) {
    if (!t.alive()) continue;
    living.push_back(t);
    if (bench.model.patches[t.patch].frozen()) continue;
    for (VertexId v : t.v) ASSERT_TRUE(bench.model.on_patch(m.tag_of_vertex[v], t.patch)) << "patch " << t.patch;
  }
  for_each_edge(edge_uses(corners_of(living)), [&](std::span<const EdgeUse> uses) {
    const Triangle& first = living[uses[0].triangle];
    const LineId line = first.line[uses[0].corner];
    bool one_patch = uses.size() == 2;
    for (const EdgeUse& use : uses) {
      const Triangle& t = living[use.triangle];
      one_patch &= t.patch == first.patch;
      ASSERT_EQ(t.line[use.corner], line) << "the triangles at an edge differ about its line";
    }
    ASSERT_TRUE(one_patch || line != none) << "patches meet where there is no line";
    if (line == none || bench.model.lines[line].frozen) return;
    for (VertexId v : uses[0].edge) ASSERT_TRUE(bench.model.on_line(m.tag_of_vertex[v], line));
  });
}

inline double quality_of(const TetMesh& m, TetId t) {
  const Vertex* p[4];
  for (int k = 0; k < 4; ++k) p[k] = &m.vertices[m.tets[t].v[k]];
  return shape_quality(p[0]->x, p[1]->x, p[2]->x, p[3]->x, p[0]->m, p[1]->m, p[2]->m, p[3]->m);
}

inline void expect_sound(Workbench& bench, const Conserved& before) {
  std::vector<int> refs;
  for (const Region& region : bench.model.regions) refs.push_back(region.ref);
  bench.settled([&] { ASSERT_EQ(first_broken_invariant(bench.mesh, refs), ""); });
  const Conserved now = conserved_by(bench);
  expect_near(now.volume, before.volume, "region");
  expect_near(now.area, before.area, "patch");
  expect_near(now.length, before.length, "line");
  ASSERT_EQ(now.corners, before.corners);
  expect_on_geometry(bench);
  for (TetId t : living_tets(bench.mesh))
    ASSERT_NEAR(bench.mesh.tets[t].state.quality, quality_of(bench.mesh, t), 1e-6);
}

/// Does an operation. If it is refused, nothing may have changed; if it is accepted, all invariants must hold.
class Attempts {
public:
  explicit Attempts(Workbench& bench) : bench_(bench), conserved_(conserved_by(bench)) {}

  template <class Operation>
  Outcome operator()(Operation operation) {
    const Snapshot before(bench_.mesh);
    const auto ids = ids_left();
    const Outcome outcome = operation();
    ++count[outcome];
    if (outcome == Outcome::accepted)
      expect_sound(bench_, conserved_);
    else
      EXPECT_TRUE(Snapshot(bench_.mesh) == before && ids_left() == ids)
          << "changed, although refused: " << name(outcome);
    return outcome;
  }

  static const char* name(Outcome outcome) { return outcome_names[static_cast<std::size_t>(outcome)]; }

  std::map<Outcome, int> count;

private:
  // How many there are, and which is next.
  [[nodiscard]] std::array<std::size_t, 6> ids_left() const {
    const auto next = [](const auto& ids) { return ids.available() > 0 ? std::size_t{ids.next()} : 0; };
    const auto& [vertices, tets, triangles] =
        std::tie(bench_.block.vertices, bench_.block.tets, bench_.block.triangles);
    return {vertices.available(), tets.available(), triangles.available(), next(vertices), next(tets), next(triangles)};
  }

  Workbench& bench_;
  Conserved conserved_;
};

/// Calls visit(t, edge) for every edge of every tetrahedron that exists when its turn comes.
template <class Visit>
void for_each_tet_edge(const TetMesh& mesh, Visit visit) {
  for (const TetId t : mesh.tet_ids())
    for (int e = 0; e < 6 && mesh.tets[t].alive(); ++e)
      if (!testing::Test::HasFatalFailure()) visit(t, e);
}

/// A cube, a rotated cube, two regions, a domain that is not convex, and one with a curved side,
/// one with a surface that ends inside; all perturbed.
inline std::vector<Mesh> disturbed_domains() {
  std::vector<Mesh> meshes = {cube(3), two_regions(4), l_shape(4), cube(3), cube(4), cube_with_sheet(4)};
  for (unsigned i = 0; i < 6; ++i) jitter(meshes[i], i == 3 ? 0.07 : 0.05, i);
  meshes[3] = askew(meshes[3]);
  meshes[4] = vault(meshes[4]);
  return meshes;
}

/// Metrics of random sizes from `smallest` times size to size, in random directions.
inline Tensors random_field(const Mesh& mesh, double size, unsigned seed, double smallest = 0.25) {
  Random random(seed);
  Tensors field;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) field.push_back(1 / (size * size) * random.metric(smallest));
  return field;
}

}  // namespace taut::test
