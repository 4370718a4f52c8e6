// The paper's preconditioner.
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <memory>
#include <vector>

#include "elasticity/eigen_vector.hpp"
#include "elasticity/preconditioner.hpp"

namespace taut {
namespace {

using Lower = Eigen::SparseMatrix<double>;
using Factor = Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::NaturalOrdering<int>>;

// The lower triangle of P A P by columns, regular where unknowns are not free. P projects on what is free.
template <class Value>
class LowerTriangle {
public:
  LowerTriangle(const VertexSystem<Value>& system, std::span<const Constraint<Value>> constraints)
      : system_(system), constraints_(constraints) {}

  Lower run() {
    const auto size = components * static_cast<Eigen::Index>(constraints_.size());
    Lower lower(size, size);
    lower.reserve(static_cast<Eigen::Index>(system_.graph().entry_count() + constraints_.size()) * components *
                  components / 2);
    for (std::size_t i = 0; i < constraints_.size(); ++i) {
      take_row(i);
      for (int j = 0; j < components; ++j) append_column(lower, static_cast<int>(i), j);
    }
    lower.finalize();
    return lower;
  }

private:
  using A = Algebra<Value>;
  static constexpr int components = A::components;

  struct Entry {
    int column;
    typename A::Block block;
  };

  // What is at and right of the diagonal.
  void take_row(std::size_t i) {
    const auto columns = system_.graph().columns(i);
    const auto blocks = system_.row(i);
    const auto& free = constraints_[i].free;
    row_.assign(1, {static_cast<int>(i), A::regular(blocks[0], free)});
    for (std::size_t e = 1; e < columns.size(); ++e)
      if (columns[e] > i)
        row_.push_back({static_cast<int>(columns[e]), A::projected(free, blocks[e], constraints_[columns[e]].free)});
    std::ranges::sort(row_, {}, &Entry::column);
  }

  // The matrix is symmetric, so a row is a column.
  void append_column(Lower& lower, int i, int j) const {
    const int at = components * i + j;
    lower.startVec(at);
    for (const auto& [column, block] : row_)
      for (int k = column == i ? j : 0; k < components; ++k)
        if (const double value = A::entry(block, j, k); value != 0)
          lower.insertBack(components * column + k, at) = value;
  }

  const VertexSystem<Value>& system_;
  std::span<const Constraint<Value>> constraints_;
  std::vector<Entry> row_;
};

}  // namespace

template <class Value>
Precondition<Value> incomplete_cholesky(const VertexSystem<Value>& system,
                                        std::span<const Constraint<Value>> constraints) {
  using A = Algebra<Value>;
  const auto factor = std::make_shared<Factor>(LowerTriangle<Value>(system, constraints).run());
  if (factor->info() != Eigen::Success) return {};
  return [factor, constraints](std::span<const Value> r, std::span<Value> z) {
    Eigen::VectorXd right(A::components * static_cast<Eigen::Index>(r.size()));
    for (std::size_t i = 0; i < r.size(); ++i)
      for (int a = 0; a < A::components; ++a)
        right[A::components * static_cast<Eigen::Index>(i) + a] = A::component(r[i], a);
    const Eigen::VectorXd result = factor->solve(right);
    return sum_in_order<double>(chunks_of_rows(r.size()), [&](double& sum, std::size_t i) {
      z[i] = constraints[i].free * value_at<Value>(result, i);  // the factor of an oblique wall mixes the directions
      sum += dot(r[i], z[i]);
    });
  };
}

template Precondition<double> incomplete_cholesky(const ShareSystem&, std::span<const Constraint<double>>);
template Precondition<Vec3> incomplete_cholesky(const ElasticSystem&, std::span<const Constraint<Vec3>>);

}  // namespace taut
