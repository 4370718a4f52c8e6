#include "io/read_mesh.hpp"

#include <fmt/format.h>

#include <limits>
#include <utility>

#include "io/mesh_blocks.hpp"
#include "io/open_block.hpp"
#include "taut/io.hpp"

namespace taut::gmf {
namespace {

[[noreturn]] void refuse_index(const Cursor& in, std::int64_t found, std::size_t limit, std::string_view what) {
  if (limit == 0) in.fail(fmt::format("{0} {1} found, but the file has no {0}", what, found));
  in.fail(fmt::format("{} {} found, expected 1..{}", what, found, limit));
}

template <class In>
Index read_index(In& in, std::size_t limit, std::string_view what) {
  const std::int64_t found = in.integer();
  // Zero and negative numbers wrap round to huge ones.
  const std::uint64_t index = static_cast<std::uint64_t>(found) - 1;
  if (index >= limit) refuse_index(in, found, limit, what);
  return static_cast<Index>(index);
}

template <class In>
int read_ref(In& in) {
  const std::int64_t found = in.integer();
  if (found < std::numeric_limits<int>::min() || found > std::numeric_limits<int>::max()) {
    in.fail(fmt::format("reference {} found, expected a 32-bit number", found));
  }
  return static_cast<int>(found);
}

template <class In, class Points, class Refs>
void read_rows(In& in, std::size_t count, const PointRows<Points, Refs>& rows) {
  const std::size_t first = rows.size();
  rows.points.resize(first + count);
  rows.refs.resize(first + count);
  for_each_row(in, first, count, rows.row, [&](In& from, std::size_t i) {
    for (double& x : rows.points[i]) x = finite(from);
    rows.refs[i] = read_ref(from);
  });
}

template <class In, class Elements, class Refs>
void read_rows(In& in, std::size_t count, const ElementRows<Elements, Refs>& rows) {
  const std::size_t first = rows.size();
  rows.elements.resize(first + count);
  rows.refs.resize(first + count);
  for_each_row(in, first, count, rows.row, [&](In& from, std::size_t i) {
    for (Index& vertex : rows.elements[i]) vertex = read_index(from, rows.limit, "vertex");
    rows.refs[i] = read_ref(from);
  });
}

template <class In, class Indices>
void read_rows(In& in, std::size_t count, const IndexRows<Indices>& rows) {
  const std::size_t first = rows.size();
  rows.indices.resize(first + count);
  for_each_row(in, first, count, rows.row,
               [&](In& from, std::size_t i) { rows.indices[i] = read_index(from, rows.limit, rows.what); });
}

/// Empty for what taut takes.
std::string_view why_not(Role role) {
  if (role == Role::other_shape) return "tetrahedra, triangles and edges only";
  if (role == Role::curved) return "linear elements only: export the mesh with order 1";
  return {};
}

void refuse_foreign_elements(const GmfFile& file) {
  for (const Block& block : file.blocks) {
    const std::string_view reason = why_not(role_of(block.code));
    if (reason.empty()) continue;
    std::visit(
        [reason](auto&& in) {
          const std::size_t count = in.count(0);
          if (count != 0) in.fail(fmt::format("{} found, but taut takes {}", count, reason));
        },
        cursor_at(file, block));
  }
}

template <class Rows>
void append_block(const GmfFile& file, const Block& block, const Rows& rows) {
  read_block(file, block, [&](auto& in) {
    const std::size_t count = in.count(rows.size());
    in.expect(count, rows.row);
    read_rows(in, count, rows);
  });
}

}  // namespace

Mesh read_mesh(const GmfFile& file, Needs needs) {
  require_three_dimensions(file);
  refuse_foreign_elements(file);
  Mesh mesh;
  for_each_block(mesh, [&](Code code, const auto& rows) {
    if (is_required(code, needs)) (void)file.require(code);
    for (const Block& block : file.blocks) {
      if (block.code == code) append_block(file, block, rows);
    }
  });
  return mesh;
}

}  // namespace taut::gmf

namespace taut {

Mesh read_mesh(const std::filesystem::path& path) {
  return gmf::read_mesh(gmf::open(path, ".mesh", ".meshb"));
}

Mesh read_boundary(const std::filesystem::path& path) {
  const gmf::GmfFile file = gmf::open(path, ".mesh", ".meshb");
  const bool has_tetrahedra = file.find(gmf::Code::tetrahedra) != nullptr;
  return gmf::read_mesh(file, has_tetrahedra ? gmf::Needs::tetrahedra : gmf::Needs::triangles);
}

Mesh read_edges(const std::filesystem::path& path) {
  return gmf::read_mesh(gmf::open(path, ".mesh", ".meshb"), gmf::Needs::edges);
}

SurfaceMesh read_surface(const std::filesystem::path& path) {
  Mesh mesh = gmf::read_mesh(gmf::open(path, ".mesh", ".meshb"), gmf::Needs::triangles);
  return {std::move(mesh.points), std::move(mesh.triangles)};
}

}  // namespace taut
