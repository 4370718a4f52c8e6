#include "adapt/hash.hpp"

#include <bit>

#include "base/parallel.hpp"

namespace taut {
namespace {

/// Fowler, Noll and Vo's hash 1a, of words.
class Fnv1a {
public:
  void mix(std::uint64_t word) { hash_ = (hash_ ^ word) * 1099511628211U; }
  void mix(double x) { mix(std::bit_cast<std::uint64_t>(x)); }
  void mix(Index i) { mix(std::uint64_t{i}); }
  void mix(int i) { mix(static_cast<std::uint64_t>(i)); }
  template <class T, std::size_t n>
  void mix(const std::array<T, n>& entries) {
    for (const T& entry : entries) mix(entry);
  }
  Fnv1a& operator+=(const Fnv1a& other) {
    mix(other.hash_);
    return *this;
  }
  [[nodiscard]] std::uint64_t value() const { return hash_; }

private:
  std::uint64_t hash_ = 14695981039346656037U;
};

// The hash of the hashes of the parts, which can be computed in parallel, and of the length.
template <class T>
Fnv1a hash_of(const std::vector<T>& entries) {
  Fnv1a hash = sum_in_order<Fnv1a>(entries.size(), [&](Fnv1a& part, std::size_t i) { part.mix(entries[i]); });
  hash.mix(std::uint64_t{entries.size()});
  return hash;
}

template <class... Arrays>
std::uint64_t hash_of_all(const Arrays&... arrays) {
  Fnv1a hash;
  ((hash += hash_of(arrays)), ...);
  return hash.value();
}

}  // namespace

std::uint64_t hash_of(const Mesh& m, const Tensors& metric) {
  return hash_of_all(m.points, m.point_refs, m.tetrahedra, m.tetrahedron_refs, m.triangles, m.triangle_refs, m.edges,
                     m.edge_refs, m.corners, m.required_points, m.ridges, m.required_edges, m.required_triangles,
                     m.required_tetrahedra, metric);
}

}  // namespace taut
