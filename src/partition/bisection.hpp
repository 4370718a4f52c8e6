// Planes that divide space such that all parts hold about the same number of vertices, and few edges cross between
// parts.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/tet_mesh.hpp"

namespace taut {

/// Recursive bisection (Berger and Bokhari 1987). For several directions, computes the plane that has the given share
/// of the vertices below it, and takes the plane that the fewest edges cross. The number of crossed edges is estimated
/// from the widths of the metric's unit balls near the plane.
class Bisection {
public:
  /// Parts of about `part_size` living vertices. The shares, and so all planes, are different in each round.
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
    std::uint32_t above = 0;  ///< the node above the plane (the next node is below it); the part, if this is a leaf
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
