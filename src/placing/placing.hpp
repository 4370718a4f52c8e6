// Vertices moved to and inserted on a level set, on a working mesh.
#pragma once

#include <optional>
#include <vector>

#include "operators/kernel.hpp"
#include "placing/level_function.hpp"

namespace taut {

/// Works on the whole mesh, on one thread: what is near a surface is a small part of the mesh.
class Placing {
public:
  Placing(Session& session, const LevelFunction& function, const PlaceOptions& options);

  /// All of it, in this order.
  void run();

  [[nodiscard]] std::size_t moved() const { return moved_; }
  [[nodiscard]] std::size_t inserted() const { return inserted_; }
  [[nodiscard]] std::size_t crossed() const;
  [[nodiscard]] const std::vector<double>& values() const { return values_; }  ///< by vertex

private:
  /// Moves vertices of crossed edges: of each the end that is nearer to the surface, then also the other.
  void move();

  /// Inserts vertices on the edges that are still crossed, where the surface crosses them.
  void split_crossed();

  /// Inserts vertices on the edges on the surface that deviate from it, until none does or nothing can be done.
  void split_deviating();

  enum class End { nearer, farther };
  struct Split {
    int edge;
    Vec3 near;
  };

  [[nodiscard]] bool is_crossed(VertexId a, VertexId b) const;
  [[nodiscard]] std::vector<VertexId> candidates(End end) const;
  [[nodiscard]] bool has_crossed_edge(VertexId v);
  bool move(VertexId v);
  bool insert(TetId t, int edge, const Vec3& near);
  template <class Choose>
  std::size_t split_where(Choose choose);
  [[nodiscard]] std::optional<Split> at_crossing(TetId t) const;
  [[nodiscard]] std::optional<Split> at_deviation(TetId t) const;
  [[nodiscard]] double deviation_at(const Vec3& x, VertexId near) const;
  void relax();
  [[nodiscard]] std::optional<Vec3> on_surface(Vec3 x, Tag tag, CellId host, double size) const;
  [[nodiscard]] double size_at(VertexId v) const;
  void lend_ids();

  Kernel kernel_;
  Block whole_;
  TetMesh& mesh_;
  const LevelFunction& function_;
  const PlaceOptions& options_;
  double worst_inserted_;  ///< 1/Q that an insertion may leave
  std::vector<double> values_;
  std::size_t moved_ = 0, inserted_ = 0;
};

}  // namespace taut
