// What the examples of moving bodies write for each step.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <string>
#include <taut/taut.hpp>
#include <vector>

namespace steps {

struct Seconds {
  double elapsed = 0;
  double busy = 0;  ///< of all threads
};

class Watch {
public:
  [[nodiscard]] Seconds seconds() const {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
    return {elapsed.count(), static_cast<double>(std::clock() - busy_before_) / CLOCKS_PER_SEC};
  }

private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::clock_t busy_before_ = std::clock();
};

/// One line of comma-separated numbers for each step, measured by taut::measure: a solver needs no such thing, so it is
/// not part of the seconds.
class Log {
public:
  explicit Log(const std::filesystem::path& path) : file_(std::fopen(path.c_str(), "w")) {
    std::fprintf(file_, "step,vertices,tetrahedra,tau,Q_up_to_3,Q_max,share,parts,iterations,seconds,busy");
    for (const char* phase : phases) std::fprintf(file_, ",%s", phase);
    std::fprintf(file_, "\n");
  }
  Log(const Log&) = delete;
  Log& operator=(const Log&) = delete;
  ~Log() { std::fclose(file_); }

  void add(int step, const taut::MovingMesh& moving, const taut::Advance& done, const Seconds& took) {
    const taut::Quality q = taut::measure(moving.mesh(), moving.metric());
    std::fprintf(file_, "%d,%zu,%zu,%.6f,%.8f,%.4f,%.4f,%d,%d,%.4f,%.4f", step, q.vertices, q.tetrahedra, q.tau,
                 q.Q_up_to_3, q.Q_max, done.share, done.parts, done.iterations, took.elapsed, took.busy);
    for (const char* phase : phases) std::fprintf(file_, ",%.4f", of_phase(done, phase));
    std::fprintf(file_, "\n");
    std::fflush(file_);
  }

private:
  static constexpr const char* phases[] = {"solve", "move", "optimise", "result", "transfer"};

  static double of_phase(const taut::Advance& done, const std::string& phase) {
    const auto found = std::ranges::find(done.seconds, phase, [](const auto& entry) { return entry.first; });
    return found == done.seconds.end() ? 0 : found->second;
  }

  std::FILE* file_;
};

/// FOLDER/mesh-STEP.meshb and its metric, FOLDER/mesh-STEP.solb.
inline void write(const std::filesystem::path& folder, int step, const taut::MovingMesh& moving) {
  const std::string name = "mesh-" + std::to_string(step);
  taut::Field metric{.kind = taut::Field::Kind::tensor, .values = {}};
  for (const taut::Tensor& m : moving.metric()) metric.values.insert(metric.values.end(), m.begin(), m.end());
  taut::write_mesh(folder / (name + ".meshb"), moving.mesh());
  taut::write_solution(folder / (name + ".solb"), {metric});
}

}  // namespace steps
