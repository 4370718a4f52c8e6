#include "motion/numbering.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "adapt/result.hpp"
#include "base/parallel.hpp"

namespace taut {
namespace {

// The number of each vertex: those with an origin in its order, then new ones, whose origin is the largest number.
std::vector<Index> numbers_of(const TetMesh& mesh) {
  std::vector<Index> in_order(mesh.vertices.size());
  std::iota(in_order.begin(), in_order.end(), Index{0});
  std::ranges::stable_sort(in_order, {}, [&](Index v) { return mesh.origin_of_vertex[v]; });
  std::vector<Index> numbers(in_order.size());
  for (std::size_t i = 0; i < in_order.size(); ++i) numbers[in_order[i]] = static_cast<Index>(i);
  return numbers;
}

template <class Value>
void permute(std::vector<Value>& values, const std::vector<Index>& numbers) {
  if (values.empty()) return;
  std::vector<Value> moved(values.size());
  for_each_index(values.size(), [&](std::size_t v) { moved[numbers[v]] = values[v]; });
  values = std::move(moved);
}

template <std::size_t n>
void renumber(std::vector<std::array<Index, n>>& entities, const std::vector<Index>& numbers) {
  for_each_index(entities.size(), [&](std::size_t i) {
    for (Index& v : entities[i]) v = numbers[v];
  });
}

void renumber(std::vector<Index>& points, const std::vector<Index>& numbers) {
  for (Index& v : points)
    if (v != AdaptResult::gone) v = numbers[v];
}

void renumber(Mesh& mesh, const std::vector<Index>& numbers) {
  permute(mesh.points, numbers);
  permute(mesh.point_refs, numbers);
  renumber(mesh.tetrahedra, numbers);
  renumber(mesh.triangles, numbers);
  renumber(mesh.edges, numbers);
  renumber(mesh.corners, numbers);
  renumber(mesh.required_points, numbers);
}

}  // namespace

AdaptResult numbered(Session& session, const Mesh& before) {
  AdaptResult result;
  assemble_mesh(session, before, result);
  const std::vector<Index> numbers = numbers_of(session.mesh);
  renumber(result.mesh, numbers);
  permute(result.metric, numbers);
  renumber(result.new_of_old, numbers);
  for (InnerEdge& edge : session.model.inner_edges)
    for (std::uint32_t& point : edge.points) point = result.new_of_old[point];
  session.mesh.origin_of_vertex.assign(numbers.begin(), numbers.end());
  return result;
}

}  // namespace taut
