// Linear elements on a mesh: the matrix and its solution, for displacements and for a share of motion.
#pragma once

#include <span>
#include <vector>

#include "elasticity/constraint.hpp"
#include "elasticity/elements.hpp"
#include "elasticity/vertex_graph.hpp"

namespace taut {

enum class Preconditioner {
  block_jacobi,         ///< the diagonal block of each vertex
  two_level,            ///< these blocks, and a coarse system for groups of vertices: a third of the iterations
  incomplete_cholesky,  ///< fewer iterations, on one thread; its set-up takes longer than the solution by the other
};

struct SolveOptions {
  /// The residual is relative to that without free displacements, in the norm of the preconditioner.
  StopAt stop{};
  Preconditioner preconditioner = Preconditioner::two_level;
};

template <class Value>
struct Solution {
  std::vector<Value> values;  ///< by vertex id; zero for dead ones
  Convergence convergence{};
  bool converged = false;  ///< if not, the values are the best so far, and of no use if the residual is not a number
};

/// One row of blocks for each vertex of the graph, which must outlive the system and keep the mesh's connectivity.
template <class Value>
class VertexSystem {
public:
  using Block = typename Algebra<Value>::Block;
  using Law = typename Algebra<Value>::Law;

  explicit VertexSystem(const VertexGraph& graph) : graph_(&graph), blocks_(graph.entry_count()) {}

  /// Sums up the matrix of elements of the graph's mesh, each time that they have changed.
  void assemble(const RawArray<Element>& elements, const Law& law = {});

  /// What fulfils the constraints and is in equilibrium with the loads, which are integrals of a force times each
  /// vertex' weight; without `loads` there are none. The search begins at `start` or, without it, at zero.
  [[nodiscard]] Solution<Value> solve(std::span<const Constraint<Value>> constraints, std::span<const Value> start = {},
                                      const SolveOptions& options = {}, std::span<const Value> loads = {}) const;

  [[nodiscard]] const VertexGraph& graph() const { return *graph_; }
  [[nodiscard]] std::span<const Block> row(std::size_t i) const {
    return {blocks_.data() + graph_->first(i), graph_->first(i + 1) - graph_->first(i)};
  }
  /// Row i of the product with x.
  [[nodiscard]] Value row_of_product(std::size_t i, std::span<const Value> x) const {
    const auto columns = graph_->columns(i);
    const Block* block = blocks_.data() + graph_->first(i);
    Value sum{};
    for (const std::uint32_t column : columns) Algebra<Value>::add_product(sum, *block++, x[column]);
    return sum;
  }

private:
  const VertexGraph* graph_;
  RawArray<Block> blocks_;
};

/// Displacements of the vertices.
using ElasticSystem = VertexSystem<Vec3>;

/// How much of a body's motion each vertex takes part in: 1 on the body, 0 on fixed walls.
using ShareSystem = VertexSystem<double>;

extern template class VertexSystem<double>;
extern template class VertexSystem<Vec3>;

}  // namespace taut
