// ParaView's unstructured grids, and their collections in time.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <set>
#include <span>
#include <string_view>

#include "io/vtu_array.hpp"
#include "taut/io.hpp"

namespace taut::vtu {
namespace {

constexpr std::uint8_t triangle_type = 5, tetrahedron_type = 10;

/// Where the numbers of a symmetric tensor stand in taut::Tensor, row by row.
constexpr std::array<std::size_t, 9> rows_of_tensor = {0, 1, 2, 1, 3, 4, 2, 4, 5};
constexpr std::array<std::size_t, 3> rows_of_vector = {0, 1, 2};

void require_extension(const std::filesystem::path& path, const char* extension) {
  if (path.extension() == extension) return;
  throw InputError(fmt::format("{}: unknown extension \"{}\", expected {}, of ParaView", path.string(),
                               path.extension().string(), extension));
}

template <class Elements>
void check_elements(const char* name, const Elements& elements, const std::vector<int>& refs, std::size_t points) {
  if (!refs.empty() && refs.size() != elements.size())
    throw InputError(fmt::format("{}: {} references found, expected 0 or {}", name, refs.size(), elements.size()));
  for (std::size_t i = 0; i < elements.size(); ++i)
    for (const Index vertex : elements[i])
      if (vertex >= points)
        throw InputError(fmt::format("{} [{}]: index {} found, expected below {}", name, i, vertex, points));
}

void check_fields(const std::vector<NamedField>& fields, std::size_t points) {
  std::set<std::string_view> names;
  for (const auto& [name, field] : fields) {
    if (name.empty()) throw InputError("field: no name found, expected one");
    if (!names.insert(name).second) throw InputError(fmt::format("field: name {} found twice", name));
    if (field.values.size() != points * field.size())
      throw InputError(fmt::format("field: {}: {} values found, expected {} for each of {} vertices", name,
                                   field.values.size(), field.size(), points));
  }
}

/// The place in a vertex's values of each number that is written for it.
std::span<const std::size_t> places_of(const Field& field) {
  if (field.kind == Field::Kind::tensor) return rows_of_tensor;
  return std::span(rows_of_vector).first(field.size());
}

Array array_of_field(const NamedField& named) {
  const Field& field = named.field;
  const std::span<const std::size_t> places = places_of(field);
  const std::size_t count = field.values.size() / field.size();
  return array_of<double>(named.name, count, places.size(), [&field, places, count](RawSink& out) {
    for (std::size_t i = 0; i < count; ++i)
      for (const std::size_t place : places) out.put(field.values[i * field.size() + place]);
  });
}

Section point_data(const std::vector<NamedField>& fields) {
  Section section{"PointData", {}};
  for (const NamedField& field : fields) section.arrays.push_back(array_of_field(field));
  return section;
}

void put_refs(RawSink& out, const std::vector<int>& refs, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) out.put(std::int32_t{refs.empty() ? 0 : refs[i]});
}

Array references(const Mesh& mesh) {
  const std::size_t cells = mesh.tetrahedra.size() + mesh.triangles.size();
  return array_of<std::int32_t>("reference", cells, 1, [&mesh](RawSink& out) {
    put_refs(out, mesh.tetrahedron_refs, mesh.tetrahedra.size());
    put_refs(out, mesh.triangle_refs, mesh.triangles.size());
  });
}

Array coordinates(const Mesh& mesh) {
  return array_of<double>("points", mesh.points.size(), 3, [&mesh](RawSink& out) {
    for (const Point& point : mesh.points)
      for (const double x : point) out.put(x);
  });
}

template <class Elements>
void put_vertices(RawSink& out, const Elements& elements) {
  for (const auto& element : elements)
    for (const Index vertex : element) out.put(std::int64_t{vertex});
}

/// The vertices of all cells, one cell after another.
Array connectivity(const Mesh& mesh) {
  const std::size_t numbers = 4 * mesh.tetrahedra.size() + 3 * mesh.triangles.size();
  return array_of<std::int64_t>("connectivity", numbers, 1, [&mesh](RawSink& out) {
    put_vertices(out, mesh.tetrahedra);
    put_vertices(out, mesh.triangles);
  });
}

/// Where the vertices of each cell end.
Array offsets(const Mesh& mesh) {
  const std::size_t cells = mesh.tetrahedra.size() + mesh.triangles.size();
  return array_of<std::int64_t>("offsets", cells, 1, [&mesh](RawSink& out) {
    std::int64_t end = 0;
    for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i) out.put(end += 4);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) out.put(end += 3);
  });
}

Array types(const Mesh& mesh) {
  const std::size_t cells = mesh.tetrahedra.size() + mesh.triangles.size();
  return array_of<std::uint8_t>("types", cells, 1, [&mesh](RawSink& out) {
    for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i) out.put(tetrahedron_type);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) out.put(triangle_type);
  });
}

}  // namespace
}  // namespace taut::vtu

namespace taut {

void write_vtu(const std::filesystem::path& path, const Mesh& mesh, const std::vector<NamedField>& fields) {
  vtu::require_extension(path, ".vtu");
  vtu::check_elements("tetrahedra", mesh.tetrahedra, mesh.tetrahedron_refs, mesh.points.size());
  vtu::check_elements("triangles", mesh.triangles, mesh.triangle_refs, mesh.points.size());
  vtu::check_fields(fields, mesh.points.size());
  const std::vector<vtu::Section> sections = {
      vtu::point_data(fields),
      {"CellData", {vtu::references(mesh)}},
      {"Points", {vtu::coordinates(mesh)}},
      {"Cells", {vtu::connectivity(mesh), vtu::offsets(mesh), vtu::types(mesh)}},
  };
  gmf::AtomicFile file(path);
  vtu::RawSink out(file);
  out.text(vtu::opening("UnstructuredGrid"));
  out.text(fmt::format("  <UnstructuredGrid>\n    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
                       mesh.points.size(), mesh.tetrahedra.size() + mesh.triangles.size()));
  out.text(vtu::head_of(sections));
  out.text("    </Piece>\n  </UnstructuredGrid>\n  <AppendedData encoding=\"raw\">\n_");
  vtu::write_appended(out, sections);
  out.text("\n  </AppendedData>\n</VTKFile>\n");
  file.commit();
}

void write_pvd(const std::filesystem::path& path, const std::vector<TimedFile>& files) {
  vtu::require_extension(path, ".pvd");
  for (const auto& [time, file] : files)
    if (!std::isfinite(time)) throw InputError(fmt::format("{}: time {} found, expected a finite number", file, time));
  gmf::AtomicFile file(path);
  vtu::RawSink out(file);
  out.text(vtu::opening("Collection"));
  out.text("  <Collection>\n");
  for (const auto& [time, name] : files)
    out.text(fmt::format("    <DataSet timestep=\"{}\" file=\"{}\"/>\n", time, vtu::escaped(name)));
  out.text("  </Collection>\n</VTKFile>\n");
  file.commit();
}

}  // namespace taut
