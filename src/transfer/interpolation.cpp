#include "transfer/interpolation.hpp"

#include <fmt/format.h>

#include "base/parallel.hpp"
#include "mesh/door.hpp"
#include "taut/transfer.hpp"

namespace taut {
namespace {

// Only what is read here; the mesh as a whole has been checked by whoever made the hosts.
void require_hosts(const Mesh& from, const std::vector<Host>& hosts) {
  for_each_index(hosts.size(), [&](std::size_t i) {
    const Index t = hosts[i].tetrahedron;
    if (t >= from.tetrahedra.size())
      throw InputError(fmt::format("host {}: tetrahedron {} found, expected 1..{}", i + 1, std::size_t{t} + 1,
                                   from.tetrahedra.size()));
  });
}

}  // namespace

Values interpolated(const Background& mesh, const Values& values, std::span<const Place> places) {
  Values result(values.size, places.size());
  for_each_index(places.size(), [&](std::size_t i) {
    const auto& v = mesh.vertices_of(places[i].cell);
    interpolate_at(
        places[i].weights, [&](std::size_t k) { return values[v[k]]; }, result[i]);
  });
  return result;
}

std::vector<Field> interpolate(const Mesh& from, const std::vector<Field>& fields, const std::vector<Host>& hosts) {
  require_sound_arrays(from);
  require_sound(fields, from.points.size());
  require_hosts(from, hosts);
  std::vector<Field> result;
  for (const Field& field : fields) {
    const std::size_t size = field.size();
    Field out{field.kind, std::vector<double>(size * hosts.size())};
    for_each_index(hosts.size(), [&](std::size_t i) {
      const auto& v = from.tetrahedra[hosts[i].tetrahedron];
      const auto row = [&](std::size_t k) { return &field.values[v[k] * size]; };
      interpolate_at(hosts[i].weights, row, {&out.values[i * size], size});
    });
    result.push_back(std::move(out));
  }
  return result;
}

}  // namespace taut
