#include "io/write_mesh.hpp"

#include <fmt/format.h>

#include "io/gmf_file.hpp"
#include "io/mesh_blocks.hpp"
#include "io/sinks.hpp"
#include "taut/io.hpp"

namespace taut::gmf {
namespace {

/// The number of an entity in a file. Nothing is written that could not be read back.
std::int64_t number_of(Index index, std::size_t limit, Code code, std::size_t row) {
  if (index >= limit) {
    throw InputError(fmt::format("{} [{}]: index {} found, expected below {}", name_of(code), row, index, limit));
  }
  return std::int64_t{index} + 1;
}

int ref_at(const std::vector<int>& refs, std::size_t row) {
  return refs.empty() ? 0 : refs[row];
}

template <class Rows>
void check_refs(Code code, const Rows& rows) {
  if (!rows.refs.empty() && rows.refs.size() != rows.size()) {
    throw InputError(
        fmt::format("{}: {} references found, expected 0 or {}", name_of(code), rows.refs.size(), rows.size()));
  }
}

template <class Sink, class Points, class Refs>
void write_rows(Sink& out, Code code, const PointRows<Points, Refs>& rows) {
  check_refs(code, rows);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const double x : rows.points[i]) out.real(x);
    out.integer(ref_at(rows.refs, i));
    out.end_row();
  }
}

template <class Sink, class Elements, class Refs>
void write_rows(Sink& out, Code code, const ElementRows<Elements, Refs>& rows) {
  check_refs(code, rows);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const Index vertex : rows.elements[i]) out.integer(number_of(vertex, rows.limit, code, i));
    out.integer(ref_at(rows.refs, i));
    out.end_row();
  }
}

template <class Sink, class Indices>
void write_rows(Sink& out, Code code, const IndexRows<Indices>& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    out.integer(number_of(rows.indices[i], rows.limit, code, i));
    out.end_row();
  }
}

/// Calls visit(code, rows) for the blocks that a file of this mesh has.
template <class Visitor>
void for_each_written_block(const Mesh& mesh, Visitor visit) {
  for_each_block(mesh, [&](Code code, const auto& rows) {
    if (rows.size() != 0 || is_required(code)) visit(code, rows);
  });
}

template <class Sink>
void write_blocks(Sink&& out, const Mesh& mesh) {
  for_each_written_block(mesh, [&](Code code, const auto& rows) {
    out.begin(code, rows.size(), rows.row);
    write_rows(out, code, rows);
  });
  out.finish();
}

int version_of(const Mesh& mesh) {
  std::size_t bytes = 0;
  for_each_written_block(
      mesh, [&](Code, const auto& rows) { bytes += BinarySink::block_bytes(2, rows.size(), rows.row, 0); });
  return version_for(bytes);
}

}  // namespace

void write_text(AtomicFile& file, const Mesh& mesh) {
  write_blocks(TextSink(file), mesh);
}

void write_binary(AtomicFile& file, const Mesh& mesh, int version) {
  write_blocks(BinarySink(file, version), mesh);
}

}  // namespace taut::gmf

namespace taut {

void write_mesh(const std::filesystem::path& path, const Mesh& mesh) {
  const gmf::Encoding encoding = gmf::encoding_of(path, ".mesh", ".meshb");
  gmf::AtomicFile file(path);
  if (encoding == gmf::Encoding::text) {
    gmf::write_text(file, mesh);
  } else {
    gmf::write_binary(file, mesh, gmf::version_of(mesh));
  }
  file.commit();
}

void write_surface(const std::filesystem::path& path, const SurfaceMesh& surface) {
  Mesh mesh;
  mesh.points = surface.points;
  mesh.triangles = surface.triangles;
  write_mesh(path, mesh);
}

}  // namespace taut
