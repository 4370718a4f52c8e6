#include "elasticity/vertex_system.hpp"

#include <algorithm>
#include <cassert>

#include "elasticity/preconditioner.hpp"

namespace taut {
namespace {

// One solution of a system. x is what is prescribed plus what is free, and only the latter is searched.
template <class Value>
class Search {
public:
  using Values = std::vector<Value>;

  Search(const VertexSystem<Value>& system, std::span<const Constraint<Value>> constraints)
      : system_(system),
        rows_(chunks_of_rows(constraints.size())),
        constraints_(constraints.size()),
        freedom_(constraints.size()) {
    for_each_index(rows_, [&](std::size_t i) {
      constraints_[i] = system.graph().uses(i).empty() ? prescribed(Value{}) : constraints[i];
      const Projector& free = constraints_[i].free;
      freedom_[i] = free == Projector{} ? Freedom::none : free == Algebra<Value>::all ? Freedom::all : Freedom::some;
    });
  }

  Solution<Value> run(std::span<const Value> start, std::span<const Value> loads, const SolveOptions& options) const {
    const Precondition<Value> precondition = preconditioner(options.preconditioner);
    Values x = with_free_part(std::span<const Value>{});
    Values residual = residual_of(x, loads);
    const double scale = square_of(residual, precondition);
    if (!start.empty() && scale != 0) {
      x = with_free_part(start);
      residual = residual_of(x, loads);
    }
    const Convergence convergence = conjugate_gradients(
        x, std::move(residual), scale,
        [&](std::size_t i, std::span<const Value> d) { return free_row_of_product(i, d); }, precondition, options.stop);
    const bool converged = convergence.residual <= options.stop.residual;
    return {with_free_part(x), convergence, converged};
  }

private:
  using Projector = typename Algebra<Value>::Projector;
  enum class Freedom : std::uint8_t { none, some, all };

  // Most time goes into reading the matrix, so rows that are not needed are left out.
  [[nodiscard]] Value free_row_of_product(std::size_t i, std::span<const Value> x) const {
    if (freedom_[i] == Freedom::none) return {};
    const Value value = system_.row_of_product(i, x);
    return freedom_[i] == Freedom::all ? value : constraints_[i].free * value;
  }

  [[nodiscard]] Precondition<Value> preconditioner(Preconditioner kind) const {
    const std::span<const Constraint<Value>> constraints = constraints_;
    if (kind == Preconditioner::incomplete_cholesky)
      if (auto found = incomplete_cholesky(system_, constraints)) return found;
    if (kind == Preconditioner::two_level)
      if (auto found = two_level(system_, constraints)) return found;
    return block_jacobi(system_, constraints);
  }

  [[nodiscard]] Values with_free_part(std::span<const Value> free) const {
    Values x(constraints_.size());
    for_each_index(rows_, [&](std::size_t i) {
      const Constraint<Value>& own = constraints_[i];
      // A value that does not count, as that of a dead vertex, need not be a number.
      x[i] = freedom_[i] == Freedom::none || free.empty() ? own.prescribed() : own.prescribed() + own.free * free[i];
    });
    return x;
  }

  [[nodiscard]] Values residual_of(const Values& x, std::span<const Value> loads) const {
    Values residual(x.size());
    for_each_index(rows_, [&](std::size_t i) {
      const Value load = loads.empty() ? Value{} : loads[i];
      residual[i] = constraints_[i].free * (load - system_.row_of_product(i, x));
    });
    return residual;
  }

  static double square_of(const Values& residual, const Precondition<Value>& precondition) {
    Values scaled(residual.size());
    return precondition(residual, scaled);
  }

  const VertexSystem<Value>& system_;
  Chunks rows_;
  std::vector<Constraint<Value>> constraints_;
  std::vector<Freedom> freedom_;
};

}  // namespace

template <class Value>
void VertexSystem<Value>::assemble(const RawArray<Element>& elements, const Law& law) {
  for_each_index(chunks_of_rows(graph_->size()), [&](std::size_t i) {
    Block* const row = blocks_.data() + graph_->first(i);
    std::fill_n(row, graph_->columns(i).size(), Block{});
    for (const VertexGraph::Use& use : graph_->uses(i)) {
      assert(use.tet < elements.size());
      const Element& element = elements.data()[use.tet];
      for (std::size_t k = 0; k < 4; ++k)
        Algebra<Value>::add(row[use.place[k]], law, element.weight, element.gradient[use.corner], element.gradient[k]);
    }
  });
}

template <class Value>
Solution<Value> VertexSystem<Value>::solve(std::span<const Constraint<Value>> constraints, std::span<const Value> start,
                                           const SolveOptions& options, std::span<const Value> loads) const {
  assert(constraints.size() == graph_->size());
  return Search<Value>(*this, constraints).run(start, loads, options);
}

template class VertexSystem<double>;
template class VertexSystem<Vec3>;

}  // namespace taut
