// Where something lies that was made elsewhere and has been moved rigidly since.
#pragma once

#include <optional>

#include "base/sym3.hpp"
#include "base/vec3.hpp"
#include "taut/rigid_motion.hpp"

namespace taut {

/// At first where it was made: everything then keeps its bits.
class Placement {
public:
  Placement() = default;
  explicit Placement(const RigidMotion& there) : ways_({there, there.inverse()}) {}

  /// Moves it on. Errors do not add up beyond rounding: the whole way is one motion, and the way back is made from it.
  void move(const RigidMotion& motion) { *this = Placement(ways_ ? motion * ways_->there : motion); }

  /// Where a point is now, of which `back` is where it was made.
  [[nodiscard]] Vec3 there(const Vec3& x) const { return ways_ ? Vec3{ways_->there(x)} : x; }
  [[nodiscard]] Vec3 back(const Vec3& x) const { return ways_ ? Vec3{ways_->back(x)} : x; }

  /// A direction or a tensor as it is now.
  [[nodiscard]] Vec3 turned(const Vec3& direction) const {
    if (!ways_) return direction;
    const auto& [x, y, z] = ways_->there.matrix();
    return {dot(Vec3{x}, direction), dot(Vec3{y}, direction), dot(Vec3{z}, direction)};
  }
  [[nodiscard]] Sym3 turned(const Sym3& tensor) const { return ways_ ? ways_->there.rotated(tensor) : tensor; }

private:
  struct Ways {
    RigidMotion there, back;
  };
  std::optional<Ways> ways_;
};

}  // namespace taut
