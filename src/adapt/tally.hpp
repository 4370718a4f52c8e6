// Counts of the operations of one pass, by outcome.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "cavity/outcome.hpp"
#include "taut/adapt.hpp"

namespace taut {

class Tally {
public:
  explicit Tally(const char* name) : name_(name) {}

  void scan(std::size_t count = 1) { scanned_ += count; }
  bool record(Outcome outcome) {
    ++outcomes_[static_cast<std::size_t>(outcome)];
    return outcome == Outcome::accepted;
  }
  void add_seconds(double seconds) { seconds_ += seconds; }
  void add_busy(double seconds) { busy_ += seconds; }
  Tally& operator+=(const Tally& other) {
    scanned_ += other.scanned_;
    for (std::size_t i = 0; i < outcomes_.size(); ++i) outcomes_[i] += other.outcomes_[i];
    seconds_ += other.seconds_;
    busy_ += other.busy_;
    return *this;
  }
  [[nodiscard]] std::size_t accepted() const { return outcomes_[0]; }
  [[nodiscard]] std::size_t put_off() const { return outcomes_[static_cast<std::size_t>(Outcome::put_off)]; }
  [[nodiscard]] const char* name() const { return name_; }

  [[nodiscard]] PassReport report() const {
    PassReport report{name_, scanned_, 0, accepted(), {}, put_off(), seconds_, busy_};
    for (std::size_t i = 0; i < static_cast<std::size_t>(Outcome::put_off); ++i) {
      report.tried += outcomes_[i];
      if (i > 0 && outcomes_[i] > 0) report.refused.emplace_back(outcome_names[i], outcomes_[i]);
    }
    return report;
  }

private:
  const char* name_;
  std::size_t scanned_ = 0;
  std::array<std::size_t, outcome_names.size()> outcomes_{};
  double seconds_ = 0, busy_ = 0;
};

/// The tallies of all passes.
struct Tallies {
  Tally insertion{"insert"}, collapse{"collapse"}, swap{"swap"}, relocation{"relocate"}, repair{"repair"};
  double efficiency_gain = 0;  ///< see Kernel

  [[nodiscard]] std::array<const Tally*, 5> all() const { return {&insertion, &collapse, &swap, &relocation, &repair}; }
  [[nodiscard]] std::size_t changed() const { return insertion.accepted() + collapse.accepted(); }
  Tallies& operator+=(const Tallies& other) {
    insertion += other.insertion;
    collapse += other.collapse;
    swap += other.swap;
    relocation += other.relocation;
    repair += other.repair;
    efficiency_gain += other.efficiency_gain;
    return *this;
  }
};

}  // namespace taut
