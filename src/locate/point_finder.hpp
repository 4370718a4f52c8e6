// Points, to be found by their places.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.hpp"
#include "taut/mesh.hpp"

namespace taut {

/// Points in boxes as wide as the distance at which they are looked for, so that a search visits 27 boxes.
class PointFinder {
public:
  /// For the given ones of `points`, which must outlive it. The tolerance is above 0, and at least 2^-21 of the extent.
  PointFinder(std::span<const Point> points, std::span<const Index> wanted, double tolerance);

  /// The nearest point within the tolerance from x, and all others at its place, ascending. Empty if there is none.
  [[nodiscard]] std::vector<Index> at(const Point& x) const;

private:
  using Box = std::array<std::int64_t, 3>;

  struct Boxed {
    std::uint64_t key;  ///< of the box
    Index point;
    auto operator<=>(const Boxed&) const = default;
  };

  [[nodiscard]] Box box_of(const Point& x) const;
  template <class Visit>
  void visit_around(const Point& x, Visit visit) const;

  std::span<const Point> points_;
  double tolerance_;
  Vec3 low_{};
  std::vector<Boxed> boxed_;  ///< ascending
};

}  // namespace taut
