// Gamma Mesh Format files: .mesh and .sol (text), .meshb and .solb (binary), versions 1 to 4.
#pragma once

#include <filesystem>
#include <vector>

#include "taut/error.hpp"
#include "taut/mesh.hpp"
#include "taut/metric.hpp"

namespace taut {

/// One solution field at the vertices of a mesh. `values` holds `size()` numbers a vertex, in the order of the file for
/// vectors, in the order of taut::Tensor for tensors.
struct Field {
  enum class Kind { scalar = 1, vector = 2, tensor = 3 };
  Kind kind = Kind::scalar;
  std::vector<double> values;

  [[nodiscard]] std::size_t size() const { return kind == Kind::scalar ? 1 : kind == Kind::vector ? 3 : 6; }
};

/// Reads a tetrahedral mesh. Unknown keywords are passed over. Indices are checked to lie in range.
/// Throws InputError naming the file and the keyword, line or index.
[[nodiscard]] Mesh read_mesh(const std::filesystem::path& path);

/// Reads the fields of the keyword SolAtVertices. Throws InputError.
[[nodiscard]] std::vector<Field> read_solution(const std::filesystem::path& path);

/// Reads a solution file as a metric: one scalar field (sizes) or one tensor field. Throws InputError.
[[nodiscard]] Metric read_metric(const std::filesystem::path& path);

/// Writes to a temporary file beside `path`, then renames it. The format follows the extension (.mesh or .meshb);
/// the binary version is 2, or 3 where the file passes 2 GiB. Throws Failure; no partial file stays.
void write_mesh(const std::filesystem::path& path, const Mesh& mesh);

/// Likewise for .sol and .solb. All fields must have the same number of vertices.
void write_solution(const std::filesystem::path& path, const std::vector<Field>& fields);

/// Throws Failure if a file cannot be created at `path`. Leaves nothing behind, touches no existing file.
void require_writable(const std::filesystem::path& path);

}  // namespace taut
