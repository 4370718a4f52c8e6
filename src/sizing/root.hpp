// The root of an increasing function of one variable.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace taut {

/// Asks for the value at next(), takes it by add(), and so on until done(). Secants, of which the first takes the slope
/// 3/2: that of the logarithm of a complexity over the logarithm of a factor of the metric. Once the root lies between
/// two places, no step leaves them.
class RootSearch {
public:
  RootSearch(double tolerance, int most_values, double first = 0)
      : next_(first), tolerance_(tolerance), left_(most_values) {}

  [[nodiscard]] double next() const { return next_; }
  [[nodiscard]] bool done() const { return done_; }

  void add(double value) {
    --left_;
    if (std::abs(value) <= tolerance_ || left_ == 0) {
      done_ = true;
      return;
    }
    const double slope =
        is_first_ ? first_slope : std::clamp((value - last_value_) / (next_ - last_place_), flattest, steepest);
    (value < 0 ? below_ : above_) = next_;
    is_first_ = false;
    last_place_ = next_;
    last_value_ = value;
    const double step = next_ - value / slope;
    next_ = step > below_ && step < above_ ? step : 0.5 * (below_ + above_);
  }

private:
  // Bounds and gradation flatten the function; where it is flat, the secant would leap.
  static constexpr double flattest = 0.1, steepest = 10, first_slope = 1.5;

  double next_, tolerance_;
  int left_;
  bool done_ = false, is_first_ = true;
  double last_place_ = 0, last_value_ = 0;
  double below_ = -std::numeric_limits<double>::infinity(), above_ = std::numeric_limits<double>::infinity();
};

}  // namespace taut
