// Conjugate gradients for the mass matrix.
#include <vector>

#include "base/conjugate_gradients.hpp"
#include "transfer/system.hpp"

namespace taut {
namespace {

// A condition number of 5 needs 36 steps for 16 digits. Where the source covers only a corner of a support it is worse.
constexpr StopAt rounding = {.residual = 1e-16, .iterations = 100};

using Vector = std::vector<double>;

class Solver {
public:
  explicit Solver(const System& system) : system_(system), inverse_diagonal_(system.size(), 0) {
    for_each_index(rows(), [&](std::size_t i) {
      if (const auto row = system_.row(i); !row.empty()) inverse_diagonal_[i] = 1 / row[0].value;
    });
  }

  // Improves x until the residual is rounding.
  void run(const Vector& right, Vector& x) const {
    Vector residual(x.size());
    for_each_index(rows(), [&](std::size_t i) { residual[i] = right[i] - row_of_product(i, x); });
    const double scale = sum_in_order<double>(
        rows(), [&](double& sum, std::size_t i) { sum += right[i] * right[i] * inverse_diagonal_[i]; });
    conjugate_gradients(
        x, std::move(residual), scale, [&](std::size_t i, const Vector& d) { return row_of_product(i, d); },
        [&](std::span<const double> r, std::span<double> z) {
          return sum_in_order<double>(rows(), [&](double& sum, std::size_t i) {
            z[i] = inverse_diagonal_[i] * r[i];
            sum += r[i] * z[i];
          });
        },
        rounding);
  }

private:
  [[nodiscard]] Chunks rows() const { return chunks_of_rows(system_.size()); }

  [[nodiscard]] double row_of_product(std::size_t i, const Vector& x) const {
    double sum = 0;
    for (const auto& [column, value] : system_.row(i)) sum += value * x[column];
    return sum;
  }

  const System& system_;
  Vector inverse_diagonal_;
};

}  // namespace

Values solve(const System& system, const Values& start) {
  const Solver solver(system);
  Values result = start;
  Vector right(system.size()), x(system.size());
  for (std::size_t c = 0; c < start.size; ++c) {
    for_each_index(x.size(), [&](std::size_t i) {
      right[i] = system.row(i).empty() ? 0 : system.moments[i][c];
      x[i] = start[i][c];
    });
    solver.run(right, x);
    for_each_index(x.size(), [&](std::size_t i) { result[i][c] = x[i]; });
  }
  return result;
}

}  // namespace taut
