// Small meshes and metrics as the text of files.
#pragma once

#include <string>
#include <string_view>

#include "taut/mesh.hpp"
#include "taut/metric.hpp"

namespace taut::test {

/// Two tetrahedra that share the face (2 3 4), without triangles.
extern const std::string two_tets;

[[nodiscard]] std::string mesh_text(const Mesh& mesh);
[[nodiscard]] std::string metric_text(const Sizes& sizes);
[[nodiscard]] std::string metric_text(const Tensors& tensors);

/// The unit cube as n^3 boxes with all its boundary triangles.
[[nodiscard]] Mesh cube(Index n);

/// The unit cube as n^3 boxes without its middle third, n a multiple of 3. Its outer triangles have the reference 1, or
/// 2 where z = 0; those of the hole have 7.
[[nodiscard]] Mesh room(Index n);

/// `text` with `old`, which occurs once, replaced by `now`.
[[nodiscard]] std::string changed(std::string text, std::string_view old, std::string_view now);

}  // namespace taut::test
