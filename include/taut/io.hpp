// Gamma Mesh Format files: .mesh and .sol (text), .meshb and .solb (binary), versions 1 to 4.
#pragma once

#include <filesystem>
#include <vector>

#include "taut/error.hpp"
#include "taut/export.hpp"
#include "taut/field.hpp"
#include "taut/mesh.hpp"
#include "taut/metric.hpp"
#include "taut/surface_mesh.hpp"

namespace taut {

/// Reads a tetrahedral mesh. Unknown keywords are skipped. Throws InputError, which names the file and the keyword,
/// line or index, if the file cannot be read or an index is out of range.
[[nodiscard]] TAUT_EXPORT Mesh read_mesh(const std::filesystem::path& path);

/// Reads the points and triangles of a mesh file; it need not have tetrahedra. Throws InputError.
[[nodiscard]] TAUT_EXPORT SurfaceMesh read_surface(const std::filesystem::path& path);

/// Reads all fields of the keyword SolAtVertices. Throws InputError.
[[nodiscard]] TAUT_EXPORT std::vector<Field> read_solution(const std::filesystem::path& path);

/// Reads a solution file as a metric: one scalar field (sizes) or one tensor field. Throws InputError.
[[nodiscard]] TAUT_EXPORT Metric read_metric(const std::filesystem::path& path);

/// Writes to a temporary file beside `path`, then renames it. The extension decides the format (.mesh or .meshb);
/// binary files have version 2, or 3 if they exceed 2 GiB. Throws Failure, and leaves no partial file, if it cannot be
/// written; InputError if the arrays do not fit each other.
TAUT_EXPORT void write_mesh(const std::filesystem::path& path, const Mesh& mesh);

/// The same for a surface: the file is that of a mesh with no tetrahedra.
TAUT_EXPORT void write_surface(const std::filesystem::path& path, const SurfaceMesh& surface);

/// The same for .sol and .solb. All fields must have the same number of vertices.
TAUT_EXPORT void write_solution(const std::filesystem::path& path, const std::vector<Field>& fields);

/// Throws Failure if a file cannot be created at `path`. Leaves nothing behind and changes no existing file.
TAUT_EXPORT void require_writable(const std::filesystem::path& path);

}  // namespace taut
