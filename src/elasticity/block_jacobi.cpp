#include <vector>

#include "elasticity/preconditioner.hpp"

namespace taut {

template <class Value>
Precondition<Value> block_jacobi(const VertexSystem<Value>& system, std::span<const Constraint<Value>> constraints) {
  using Inverse = typename Algebra<Value>::Projector;
  const Chunks rows = chunks_of_rows(constraints.size());
  std::vector<Inverse> inverses(constraints.size());
  for_each_index(rows,
                 [&](std::size_t i) { inverses[i] = Algebra<Value>::inverse(system.row(i)[0], constraints[i].free); });
  return [rows, inverses = std::move(inverses)](std::span<const Value> r, std::span<Value> z) {
    return sum_in_order<double>(rows, [&](double& sum, std::size_t i) {
      z[i] = inverses[i] * r[i];
      sum += dot(r[i], z[i]);
    });
  };
}

template Precondition<double> block_jacobi(const ShareSystem&, std::span<const Constraint<double>>);
template Precondition<Vec3> block_jacobi(const ElasticSystem&, std::span<const Constraint<Vec3>>);

}  // namespace taut
