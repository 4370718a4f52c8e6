// Files for ParaView: the head names what is appended, and every array is where the head says.
#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "io/gmf_builder.hpp"

namespace taut::test {
namespace {

using Vtu = InDirectory;
using Pvd = InDirectory;

std::vector<NamedField> some_fields() {
  const auto counted = [](Field::Kind kind) {
    Field field{.kind = kind, .values = {}};
    for (std::size_t i = 0; i < 5 * field.size(); ++i) field.values.push_back(0.5 + static_cast<double>(i));
    return field;
  };
  return {{"a<b>&\"c\"", counted(Field::Kind::scalar)},
          {"velocity", counted(Field::Kind::vector)},
          {"metric", counted(Field::Kind::tensor)}};
}

/// A file taken apart: the head, and the raw bytes that its offsets count.
struct Parts {
  std::string head, raw;

  explicit Parts(const std::string& content) {
    const std::string mark = "<AppendedData encoding=\"raw\">\n_", tail = "\n  </AppendedData>\n</VTKFile>\n";
    const std::size_t at = content.find(mark);
    EXPECT_NE(at, std::string::npos);
    EXPECT_TRUE(content.ends_with(tail));
    head = content.substr(0, at);
    raw = content.substr(at + mark.size(), content.size() - at - mark.size() - tail.size());
  }

  /// The offset in the head's line for an array, whose other attributes must be those given.
  [[nodiscard]] std::size_t offset_of(const std::string& name, const char* type, std::size_t components) const {
    const std::string line =
        fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"", type,
                    name, components);
    const std::size_t at = head.find(line);
    EXPECT_NE(at, std::string::npos) << line << " in\n" << head;
    return std::stoul(head.substr(at + line.size()));
  }

  template <class T>
  [[nodiscard]] std::vector<T> numbers(const std::string& name, const char* type, std::size_t components) const {
    const std::size_t offset = offset_of(name, type, components);
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, &raw.at(offset), sizeof bytes);
    std::vector<T> numbers(bytes / sizeof(T));
    EXPECT_LE(offset + sizeof bytes + bytes, raw.size());
    std::memcpy(numbers.data(), raw.data() + offset + sizeof bytes, bytes);
    return numbers;
  }
};

TEST_F(Vtu, HoldsCellsAndReferences) {
  const Mesh mesh = two_tets();
  write_vtu(directory / "a.vtu", mesh);
  const Parts parts(content_of(directory / "a.vtu"));
  EXPECT_TRUE(parts.head.starts_with(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "  <UnstructuredGrid>\n"
      "    <Piece NumberOfPoints=\"5\" NumberOfCells=\"5\">\n"))
      << parts.head;
  const std::vector<double> points = parts.numbers<double>("points", "Float64", 3);
  ASSERT_EQ(points.size(), 15U);
  EXPECT_EQ(std::memcmp(points.data(), mesh.points.data(), sizeof(Point) * 5), 0);
  EXPECT_EQ(parts.numbers<std::int32_t>("reference", "Int32", 1), (std::vector<std::int32_t>{7, 8, 4, 5, 6}));
  EXPECT_EQ(parts.numbers<std::int64_t>("connectivity", "Int64", 1),
            (std::vector<std::int64_t>{0, 1, 2, 3, 0, 2, 1, 4, 0, 1, 2, 1, 2, 3, 0, 3, 1}));
  EXPECT_EQ(parts.numbers<std::int64_t>("offsets", "Int64", 1), (std::vector<std::int64_t>{4, 8, 11, 14, 17}));
  EXPECT_EQ(parts.numbers<std::uint8_t>("types", "UInt8", 1), (std::vector<std::uint8_t>{10, 10, 5, 5, 5}));
  const std::size_t last = parts.offset_of("types", "UInt8", 1);
  EXPECT_EQ(parts.raw.size(), last + 8 + 5);
}

TEST_F(Vtu, HoldsFields) {
  write_vtu(directory / "a.vtu", two_tets(), some_fields());
  const Parts parts(content_of(directory / "a.vtu"));
  EXPECT_EQ(parts.numbers<double>("a&lt;b&gt;&amp;&quot;c&quot;", "Float64", 1),
            (std::vector<double>{0.5, 1.5, 2.5, 3.5, 4.5}));
  EXPECT_EQ(parts.numbers<double>("velocity", "Float64", 3), some_fields()[1].field.values);
  const std::vector<double> tensors = parts.numbers<double>("metric", "Float64", 9);
  ASSERT_EQ(tensors.size(), 45U);
  EXPECT_EQ(std::vector<double>(tensors.begin() + 9, tensors.begin() + 18),
            (std::vector<double>{6.5, 7.5, 8.5, 7.5, 9.5, 10.5, 8.5, 10.5, 11.5}));
}

TEST_F(Vtu, ReferencesAreZeroWithoutAny) {
  Mesh mesh = two_tets();
  mesh.triangle_refs.clear();
  write_vtu(directory / "a.vtu", mesh);
  const Parts parts(content_of(directory / "a.vtu"));
  EXPECT_EQ(parts.numbers<std::int32_t>("reference", "Int32", 1), (std::vector<std::int32_t>{7, 8, 0, 0, 0}));
  write_vtu(directory / "a.vtu", Mesh{});
  EXPECT_EQ(Parts(content_of(directory / "a.vtu")).raw, std::string(5 * 8, '\0'));
}

TEST_F(Vtu, MayBeLargerThanTheBuffer) {
  Mesh mesh;
  mesh.points.resize(100000, {1, 2, 3});
  write_vtu(directory / "a.vtu", mesh, {{std::string(3000000, 'x'), {.values = std::vector<double>(100000, 4)}}});
  const Parts parts(content_of(directory / "a.vtu"));
  EXPECT_EQ(parts.numbers<double>("points", "Float64", 3).at(299999), 3);
}

TEST_F(Vtu, ChecksWhatItIsGiven) {
  const auto error_of = [&](const Mesh& mesh, const std::vector<NamedField>& fields, const char* name = "a.vtu") {
    return message_of<InputError>([&] { write_vtu(directory / name, mesh, fields); });
  };
  Mesh mesh = two_tets();
  mesh.triangles[1][2] = 5;
  EXPECT_EQ(error_of(mesh, {}), "triangles [1]: index 5 found, expected below 5");
  mesh = two_tets();
  mesh.tetrahedron_refs.pop_back();
  EXPECT_EQ(error_of(mesh, {}), "tetrahedra: 1 references found, expected 0 or 2");
  const Field four{.kind = Field::Kind::scalar, .values = {1, 2, 3, 4}}, five{.values = {1, 2, 3, 4, 5}};
  EXPECT_EQ(error_of(two_tets(), {{"u", four}}), "field: u: 4 values found, expected 1 for each of 5 vertices");
  EXPECT_EQ(error_of(two_tets(), {{"u", five}, {"u", five}}), "field: name u found twice");
  EXPECT_EQ(error_of(two_tets(), {{"", five}}), "field: no name found, expected one");
  EXPECT_EQ(error_of(two_tets(), {}, "a.vtk"),
            (directory / "a.vtk").string() + ": unknown extension \".vtk\", expected .vtu, of ParaView");
  EXPECT_EQ(files(), 0U);
}

TEST_F(Vtu, KeepsTheOldFileWhenWritingFails) {
  save(directory / "a.vtu", "old");
  Mesh mesh = two_tets();
  mesh.tetrahedra[0][0] = 9;
  EXPECT_THROW(write_vtu(directory / "a.vtu", mesh), InputError);
  EXPECT_THROW(write_vtu(directory / "none" / "a.vtu", two_tets()), Failure);
  EXPECT_EQ(content_of(directory / "a.vtu"), "old");
  EXPECT_EQ(files(), 1U);
}

TEST_F(Pvd, ListsFilesAndTimes) {
  write_pvd(directory / "a.pvd", {{0, "out-0000.vtu"}, {0.1, "b&c.vtu"}});
  EXPECT_EQ(content_of(directory / "a.pvd"),
            "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
            "  <Collection>\n"
            "    <DataSet timestep=\"0\" file=\"out-0000.vtu\"/>\n"
            "    <DataSet timestep=\"0.1\" file=\"b&amp;c.vtu\"/>\n"
            "  </Collection>\n"
            "</VTKFile>\n");
  EXPECT_EQ(files(), 1U);
}

TEST_F(Pvd, ChecksWhatItIsGiven) {
  EXPECT_EQ(message_of<InputError>([&] {
              write_pvd(directory / "a.pvd", {{std::nan(""), "b.vtu"}});
            }),
            "b.vtu: time nan found, expected a finite number");
  EXPECT_EQ(message_of<InputError>([&] { write_pvd(directory / "a.xml", {}); }),
            (directory / "a.xml").string() + ": unknown extension \".xml\", expected .pvd, of ParaView");
  EXPECT_EQ(files(), 0U);
}

}  // namespace
}  // namespace taut::test
