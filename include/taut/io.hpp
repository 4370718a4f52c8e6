// Files. Gamma Mesh Format, versions 1 to 4: .mesh and .sol (text), .meshb and .solb (binary). For ParaView: .vtu,
// .pvd.
#pragma once

#include <filesystem>
#include <string>
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

/// Reads a mesh with tetrahedra, triangles or both, with references, edges and corners: what a Geometry is made from.
/// Throws InputError.
[[nodiscard]] TAUT_EXPORT Mesh read_boundary(const std::filesystem::path& path);

/// Reads a mesh that need not have tetrahedra or triangles, but has edges: what with_ridges() takes. Throws InputError.
[[nodiscard]] TAUT_EXPORT Mesh read_edges(const std::filesystem::path& path);

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

/// A field and the name that ParaView shows for it.
struct NamedField {
  std::string name;  ///< not empty
  Field field;       ///< one value for each point of the mesh
};

/// Writes the tetrahedra and triangles as one unstructured grid of ParaView (.vtu, binary), with the cell data
/// `reference` and the fields as point data; tensors have nine numbers, row by row. As write_mesh() does, it writes a
/// temporary file, then renames it. Throws Failure if the file cannot be written; InputError if the arrays do not fit
/// each other, or if two fields have one name.
TAUT_EXPORT void write_vtu(const std::filesystem::path& path, const Mesh& mesh,
                           const std::vector<NamedField>& fields = {});

/// A file of a collection in time.
struct TimedFile {
  double time = 0;   ///< in the unit of the user
  std::string file;  ///< the name of the .vtu file, relative to the folder of the .pvd file
};

/// Writes the collection of time steps (.pvd) that ParaView opens as one animation. The named files need not exist yet,
/// so the collection can be written anew after every step. Throws Failure if it cannot be written, InputError if a time
/// is not finite.
TAUT_EXPORT void write_pvd(const std::filesystem::path& path, const std::vector<TimedFile>& files);

/// Throws Failure if a file cannot be created at `path`. Leaves nothing behind and changes no existing file.
TAUT_EXPORT void require_writable(const std::filesystem::path& path);

}  // namespace taut
