// The edges at which the surface is parted: ridges, where references meet, and edges of the input. On curved patches an
// edge of the input counts only if it is marked as a ridge or required: meshers write the seams of periodic surfaces,
// where nothing is to be seen.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/reference.hpp"
#include "mesh/build.hpp"
#include "surface/surface_edges.hpp"
#include "taut/mesh.hpp"

namespace taut {

/// What the input says of an edge, and the triangles that meet there.
struct Feature {
  std::array<VertexId, 2> edge{};  ///< ascending
  int ref = 0;
  bool sharp = false, required = false;
  bool implicit = false;  ///< only parts required triangles from others
  std::vector<EdgeUse> uses;
};

struct Features {
  std::vector<Feature> surface;  ///< in ascending order of their edges
  std::vector<Feature> inner;    ///< edges of the input that are on no triangle
};

/// Whether both vertices of an edge of the input belong to tetrahedra. Others are no part of the mesh, as points of no
/// tetrahedron are none: meshers save the edges of curves that they did not use.
[[nodiscard]] bool is_in_volume(const Mesh& input, const Built& built, std::size_t edge);

/// Calls visit(s, t) with the uses of each edge that is not among `features`, which are ascending and hold every edge
/// at which not two triangles meet.
template <class Visit>
void for_each_smooth_edge(const std::vector<EdgeUse>& uses_of_edges, std::span<const Feature> features, Visit visit) {
  auto feature = features.begin();
  for_each_edge(uses_of_edges, [&](std::span<const EdgeUse> uses) {
    if (feature != features.end() && feature->edge == uses[0].edge)
      ++feature;
    else
      visit(uses[0], uses[1]);
  });
}

/// Where the surface is not smooth between two triangles of one reference.
struct RidgeTest {
  double angle = 45;                     ///< degrees: where their normals differ by this or more ..
  const Reference* reference = nullptr;  ///< .. or, if there is one, where it has a ridge
};

/// Feature edges are: edges of the input; edges where other than two triangles meet, or two of different reference;
/// ridges; edges between required triangles (`required` is not 0) and others. Edges of the input that part nothing of a
/// curved patch, as seams do, are none unless they are marked as ridges or required. Edges of the input at a
/// point of no tetrahedron are passed over; throws InputError if they are required.
[[nodiscard]] Features find_features(const Mesh& input, const Built& built, const std::vector<EdgeUse>& uses,
                                     const std::vector<std::uint8_t>& required, const RidgeTest& ridges);

}  // namespace taut
