#include "placing/level_function.hpp"

#include "base/parallel.hpp"

namespace taut {

LevelFunction::LevelFunction(const Mesh& mesh, std::span<const double> values, const Session& session)
    : background_(session.background.get()) {
  const std::vector<Derivatives> by_point = derivatives_of(mesh, values);
  const std::size_t count = session.background->point_count();
  values_.resize(count);
  derivatives_.resize(count);
  points_.resize(count);
  for (std::size_t p = 0; p < mesh.points.size(); ++p) {
    const VertexId v = session.vertex_of_point[p];
    if (v == none) continue;
    values_[v] = values[p];
    derivatives_[v] = by_point[p];
    points_[v] = mesh.points[p];
  }
}

double LevelFunction::at(const Vec3& x, CellId& host) const {
  if (function_ != nullptr) return (*function_)(x);
  const Weights weights = background_->locate(x, host);
  const auto& vertices = background_->vertices_of(host);
  double sum = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const VertexId v = vertices[k];
    const Vec3 d = x - points_[v];
    sum +=
        weights[k] * (values_[v] + dot(derivatives_[v].gradient, d) + 0.5 * quadratic_form(derivatives_[v].hessian, d));
  }
  return sum;
}

Vec3 LevelFunction::gradient(const Vec3& x, CellId& host, double h) const {
  Vec3 g;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Vec3 before = x, after = x;
    before[axis] -= h;
    after[axis] += h;
    g[axis] = (at(after, host) - at(before, host)) / (2 * h);
  }
  return g;
}

}  // namespace taut
