// The metrics that `taut metric` makes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limits.hpp"
#include "taut/taut.hpp"

namespace taut::program {

struct MetricJob {
  std::string mesh, output;
  std::vector<std::string> inputs;  ///< solutions or metrics
  AskedLimits limits;
  LpOptions lp;                ///< without the limits
  LevelSetOptions level_set;   ///< without the limits
  CurvatureOptions curvature;  ///< without the limits
  double error = 0, level = 0;
  std::optional<double> size;
  Recovery recovery = Recovery::least_squares;
  int threads = 0;
  bool quiet = false;
};

/// Each makes the metric that its name says for `mesh`, which job.mesh holds, writes it and says how large it is.
void run_lp(const MetricJob& job, const Mesh& mesh);
void run_error(const MetricJob& job, const Mesh& mesh);
void run_level_set(const MetricJob& job, const Mesh& mesh);
void run_curvature(const MetricJob& job, const Mesh& mesh);
void run_hessian(const MetricJob& job, const Mesh& mesh);
void run_implied(const MetricJob& job, const Mesh& mesh);
void run_size(const MetricJob& job, const Mesh& mesh);
void run_intersect(const MetricJob& job, const Mesh& mesh);

}  // namespace taut::program
