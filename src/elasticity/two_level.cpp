// The diagonal blocks, and a coarse system of groups of vertices that move as one (Nicolaides 1987).
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "elasticity/eigen_vector.hpp"
#include "elasticity/preconditioner.hpp"

namespace taut {
namespace {

// Small groups mean few iterations, but many groups a factor that takes longer than all of them.
constexpr std::size_t smallest_group = 32, most_groups = 800;

// Free vertices in groups. Those that follow each other lie near to each other, if the mesh is in order.
template <class Value>
class Groups {
public:
  explicit Groups(std::span<const Constraint<Value>> constraints)
      : of_row_(constraints.size(), no_group), rows_(indices_where(constraints.size(), [&](std::size_t i) {
          return constraints[i].free != typename Algebra<Value>::Projector{};
        })) {
    size_ = std::max(smallest_group, (rows_.size() + most_groups - 1) / most_groups);
    for (std::size_t k = 0; k < rows_.size(); ++k) of_row_[rows_[k]] = static_cast<std::uint32_t>(k / size_);
  }
  static constexpr std::uint32_t no_group = ~std::uint32_t{0};

  [[nodiscard]] std::size_t count() const { return (rows_.size() + size_ - 1) / size_; }
  [[nodiscard]] std::uint32_t of_row(std::size_t row) const { return of_row_[row]; }
  [[nodiscard]] std::span<const std::uint32_t> rows(std::size_t group) const {
    return std::span(rows_).subspan(group * size_, std::min(size_, rows_.size() - group * size_));
  }

private:
  std::vector<std::uint32_t> of_row_, rows_;
  std::size_t size_ = 0;
};

// The matrix of the groups: row by row the blocks left of the diagonal, and on it.
template <class Value>
std::vector<std::map<std::uint32_t, typename Algebra<Value>::Block>> coarse_rows(
    const VertexSystem<Value>& system, std::span<const Constraint<Value>> constraints, const Groups<Value>& groups) {
  using A = Algebra<Value>;
  std::vector<std::map<std::uint32_t, typename A::Block>> result(groups.count());
  for_each_index(Chunks(groups.count(), 1), [&](std::size_t group) {
    for (const std::uint32_t i : groups.rows(group)) {
      const auto columns = system.graph().columns(i);
      for (std::size_t e = 0; e < columns.size(); ++e) {
        const std::uint32_t other = groups.of_row(columns[e]);
        if (other > group) continue;  // among them those in no group
        A::add(result[group][other], A::projected(constraints[i].free, system.row(i)[e], constraints[columns[e]].free));
      }
    }
  });
  return result;
}

using Coarse = Eigen::SparseMatrix<double>;
using CoarseFactor = Eigen::SimplicialLDLT<Coarse>;

// Where no vertex of a group can go in a direction, the row is that of the identity.
template <class Value>
Coarse coarse_matrix(const VertexSystem<Value>& system, std::span<const Constraint<Value>> constraints,
                     const Groups<Value>& groups) {
  constexpr int components = Algebra<Value>::components;
  std::vector<Eigen::Triplet<double>> entries;
  const auto rows = coarse_rows(system, constraints, groups);
  for (std::size_t group = 0; group < rows.size(); ++group)
    for (const auto& [other, block] : rows[group])
      for (int i = 0; i < components; ++i)
        for (int j = 0; j < components; ++j) {
          const double value = Algebra<Value>::entry(block, i, j);
          const bool is_idle = value == 0 && other == group && i == j;
          entries.emplace_back(components * static_cast<int>(group) + i, components * static_cast<int>(other) + j,
                               is_idle ? 1 : value);
        }
  const auto size = components * static_cast<Eigen::Index>(groups.count());
  Coarse matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// The sum over each group.
template <class Value>
Eigen::VectorXd restricted(const Groups<Value>& groups, std::span<const Value> r) {
  constexpr int components = Algebra<Value>::components;
  Eigen::VectorXd sums(components * static_cast<Eigen::Index>(groups.count()));
  for_each_index(Chunks(groups.count(), 8), [&](std::size_t group) {
    Value sum{};
    for (const std::uint32_t i : groups.rows(group)) sum = sum + r[i];
    for (int a = 0; a < components; ++a)
      sums[components * static_cast<Eigen::Index>(group) + a] = Algebra<Value>::component(sum, a);
  });
  return sums;
}

template <class Value>
class TwoLevels {
public:
  TwoLevels(const VertexSystem<Value>& system, std::span<const Constraint<Value>> constraints)
      : constraints_(constraints),
        groups_(std::make_shared<Groups<Value>>(constraints)),
        factor_(std::make_shared<CoarseFactor>(coarse_matrix(system, constraints, *groups_))),
        blocks_(block_jacobi(system, constraints)) {}

  [[nodiscard]] bool is_regular() const { return factor_->info() == Eigen::Success; }

  double operator()(std::span<const Value> r, std::span<Value> z) const {
    (void)blocks_(r, z);
    const Eigen::VectorXd coarse = factor_->solve(restricted(*groups_, r));
    return sum_in_order<double>(chunks_of_rows(r.size()), [&](double& sum, std::size_t i) {
      const std::uint32_t group = groups_->of_row(i);
      if (group != Groups<Value>::no_group) z[i] = z[i] + constraints_[i].free * value_at<Value>(coarse, group);
      sum += dot(r[i], z[i]);
    });
  }

private:
  std::span<const Constraint<Value>> constraints_;
  std::shared_ptr<const Groups<Value>> groups_;
  std::shared_ptr<const CoarseFactor> factor_;
  Precondition<Value> blocks_;
};

}  // namespace

template <class Value>
Precondition<Value> two_level(const VertexSystem<Value>& system, std::span<const Constraint<Value>> constraints) {
  TwoLevels<Value> found(system, constraints);
  return found.is_regular() ? Precondition<Value>(std::move(found)) : Precondition<Value>{};
}

template Precondition<double> two_level(const ShareSystem&, std::span<const Constraint<double>>);
template Precondition<Vec3> two_level(const ElasticSystem&, std::span<const Constraint<Vec3>>);

}  // namespace taut
