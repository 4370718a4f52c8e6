// The function whose zeros are the surface.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "adapt/session.hpp"
#include "sizing/derivatives.hpp"
#include "taut/placing.hpp"

namespace taut {

/// Either the caller's function, or what is recovered from its values at the points of the input.
class LevelFunction {
public:
  explicit LevelFunction(const ScalarFunction& function) : function_(&function) {}

  /// `values` at the points of `mesh`, which the session was set up from.
  LevelFunction(const Mesh& mesh, std::span<const double> values, const Session& session);

  /// `host` is a cell near x of the session's background.
  [[nodiscard]] double at(const Vec3& x, CellId& host) const;

  /// By central differences over the step h.
  [[nodiscard]] Vec3 gradient(const Vec3& x, CellId& host, double h) const;

private:
  const ScalarFunction* function_ = nullptr;
  const Background* background_ = nullptr;
  std::vector<double> values_;  ///< by vertex of the background
  std::vector<Derivatives> derivatives_;
  std::vector<Vec3> points_;
};

}  // namespace taut
