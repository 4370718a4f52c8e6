// Space parted by planes such that each part holds about as many vertices and few edges cross from part to part.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/tet_mesh.hpp"

namespace taut {

/// Recursive bisection (Berger and Bokhari 1987). Of planes in several directions, each at a given share of the
/// vertices, the one is taken that the fewest edges cross, by the widths of the unit balls of the metric near it.
class Bisection {
public:
  /// Parts of about `part_size` living vertices. The shares move from round to round, and so do all planes.
  Bisection(const TetMesh& mesh, std::size_t part_size, unsigned round);

  [[nodiscard]] std::uint32_t parts() const { return parts_; }
  [[nodiscard]] std::uint32_t part_of(const Vec3& x) const {
    std::uint32_t at = 0;
    while (!nodes_[at].is_leaf) at = dot(nodes_[at].normal, x) < nodes_[at].offset ? at + 1 : nodes_[at].above;
    return nodes_[at].above;
  }

private:
  struct Node {
    bool is_leaf = true;
    std::uint32_t above = 0;  ///< the node beyond the plane, the next one is this side of it; of a leaf, its part
    Vec3 normal{};
    double offset = 0;
  };
  struct Sample {
    Vec3 x;
    Sym3 ball;  ///< inverse of the metric: a vertex at length 1 is up to sqrt(n . ball n) away in the direction n
    double along = 0;
  };
  using Samples = std::vector<Sample>::iterator;

  static double place(const Vec3& normal, double share, Samples begin, Samples end);
  static Vec3 best_normal(double share, Samples begin, Samples end);
  void split(Samples begin, Samples end, std::uint32_t parts, unsigned depth, unsigned round);

  std::vector<Node> nodes_;
  std::uint32_t parts_ = 0;
};

}  // namespace taut
