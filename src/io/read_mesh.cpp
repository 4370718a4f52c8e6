#include "io/read_mesh.hpp"

#include <fmt/format.h>

#include <limits>

#include "io/mesh_blocks.hpp"
#include "io/open_block.hpp"
#include "taut/io.hpp"

namespace taut::gmf {
namespace {

template <class In>
Index read_index(In& in, std::size_t limit, std::string_view what) {
  const std::int64_t found = in.integer();
  // Zero and negative numbers wrap round to huge ones.
  const std::uint64_t index = static_cast<std::uint64_t>(found) - 1;
  if (index >= limit) in.fail(fmt::format("{} {} found, expected 1..{}", what, found, limit));
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
  rows.points.resize(count);
  rows.refs.resize(count);
  for_each_row(in, count, rows.row, [&](In& from, std::size_t i) {
    for (double& x : rows.points[i]) x = finite(from);
    rows.refs[i] = read_ref(from);
  });
}

template <class In, class Elements, class Refs>
void read_rows(In& in, std::size_t count, const ElementRows<Elements, Refs>& rows) {
  rows.elements.resize(count);
  rows.refs.resize(count);
  for_each_row(in, count, rows.row, [&](In& from, std::size_t i) {
    for (Index& vertex : rows.elements[i]) vertex = read_index(from, rows.limit, "vertex");
    rows.refs[i] = read_ref(from);
  });
}

template <class In, class Indices>
void read_rows(In& in, std::size_t count, const IndexRows<Indices>& rows) {
  rows.indices.resize(count);
  for_each_row(in, count, rows.row,
               [&](In& from, std::size_t i) { rows.indices[i] = read_index(from, rows.limit, rows.what); });
}

void refuse_foreign_elements(const GmfFile& file) {
  for (const Keyword& keyword : keywords) {
    const Block* block = keyword.foreign_element ? file.find(keyword.code) : nullptr;
    if (block == nullptr) continue;
    std::visit(
        [](auto&& in) {
          const std::size_t count = in.count();
          if (count != 0) in.fail(fmt::format("{} found, but taut takes tetrahedra in three dimensions only", count));
        },
        cursor_at(file, *block));
  }
}

}  // namespace

Mesh read_mesh(const GmfFile& file) {
  require_three_dimensions(file);
  refuse_foreign_elements(file);
  Mesh mesh;
  for_each_block(mesh, [&](Code code, const auto& rows) {
    const Block* block = is_required(code) ? &file.require(code) : file.find(code);
    if (block == nullptr) return;
    read_block(file, *block, [&](auto& in) {
      const std::size_t count = in.count();
      in.expect(count, rows.row);
      read_rows(in, count, rows);
    });
  });
  return mesh;
}

}  // namespace taut::gmf

namespace taut {

Mesh read_mesh(const std::filesystem::path& path) {
  return gmf::read_mesh(gmf::open(path, gmf::encoding_of(path, ".mesh", ".meshb")));
}

}  // namespace taut
