// Feature edges joined to smooth lines.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/features.hpp"
#include "geometry/model.hpp"

namespace taut {

/// The feature edges of a surface as a graph over the vertices of the mesh. Triangles must know their patches.
class FeatureGraph {
public:
  using FeatureIndex = std::uint32_t;

  /// Refers to all that it is given. Chains are straight up to `tolerance`, or smooth curves of the reference.
  FeatureGraph(const TetMesh& mesh, std::span<const Feature> features, const std::vector<std::uint8_t>& fixed,
               double tolerance, const Reference* reference);

  [[nodiscard]] std::span<const Feature> features() const { return features_; }
  [[nodiscard]] const std::vector<FeatureIndex>& at(VertexId v) const { return features_at_[v]; }
  [[nodiscard]] bool is_fixed(VertexId v) const { return fixed_[v] != 0; }

  /// Whether the two features at v are one line: they are smooth there and of the same kind, and nothing else fixes v.
  [[nodiscard]] bool is_on_line(VertexId v) const;

  [[nodiscard]] VertexId other_end(FeatureIndex f, VertexId v) const {
    return features_[f].edge[0] == v ? features_[f].edge[1] : features_[f].edge[0];
  }

  /// The curve on which a feature lies; `none` if it is straight.
  [[nodiscard]] LineId bent_along(FeatureIndex f) const;

  /// The patches of the triangles that meet at a feature, ascending: twice if a patch is on both sides.
  [[nodiscard]] std::vector<PatchId> patches_of(FeatureIndex f) const;

private:
  const TetMesh& mesh_;
  std::span<const Feature> features_;
  const std::vector<std::uint8_t>& fixed_;
  double tolerance_;
  const Reference* reference_;
  std::vector<std::vector<FeatureIndex>> features_at_;
};

struct Lines {
  std::vector<Line> lines;
  std::vector<LineId> line_of_feature;
};

[[nodiscard]] Lines find_lines(const TetMesh& mesh, const FeatureGraph& graph);

}  // namespace taut
