// What became of the operations of one pass.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <string>

#include "cavity/refusal.hpp"
#include "taut/adapt.hpp"

namespace taut {

class Tally {
public:
  explicit Tally(const char* name) : name_(name) {}

  void scan(std::size_t count = 1) { scanned_ += count; }
  bool record(Refusal outcome) {
    ++outcomes_[static_cast<std::size_t>(outcome)];
    return outcome == Refusal::accepted;
  }
  void add_seconds(double seconds) { seconds_ += seconds; }
  [[nodiscard]] std::size_t accepted() const { return outcomes_[0]; }
  [[nodiscard]] const char* name() const { return name_; }

  [[nodiscard]] PassReport report() const {
    PassReport report{name_, scanned_, 0, accepted(), {}, seconds_};
    for (std::size_t i = 0; i < outcomes_.size(); ++i) {
      report.tried += outcomes_[i];
      if (i > 0 && outcomes_[i] > 0) report.refused.emplace_back(refusal_names[i], outcomes_[i]);
    }
    return report;
  }

private:
  const char* name_;
  std::size_t scanned_ = 0;
  std::array<std::size_t, refusal_names.size()> outcomes_{};
  double seconds_ = 0;
};

/// Seconds since it was made.
class Stopwatch {
public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace taut
