// Writing: reading back gives what was written, and a failed write changes nothing.
#include <sys/resource.h>

#include <csignal>

#include "io/gmf_builder.hpp"
#include "io/sinks.hpp"
#include "io/write_mesh.hpp"

namespace taut::test {
namespace {

using WriteMesh = InDirectory;
using WriteSolution = InDirectory;
using Atomic = InDirectory;

TEST_F(WriteMesh, RoundTripsInBothEncodings) {
  for (const char* name : {"a.mesh", "a.meshb"}) {
    write_mesh(directory / name, two_tets());
    expect_equal(read_mesh(directory / name), two_tets());
  }
  EXPECT_EQ(files(), 2U);
}

TEST_F(WriteMesh, RoundTripsInVersion3) {
  const std::filesystem::path path = directory / "a.meshb";
  gmf::AtomicFile file(path);
  gmf::write_binary(file, two_tets(), 3);
  file.commit();
  EXPECT_EQ(gmf::open(path, ".mesh", ".meshb").version, 3);
  expect_equal(read_mesh(path), two_tets());
}

TEST_F(WriteMesh, RoundTripsAMeshLargerThanItsBuffer) {
  Mesh mesh;
  for (Index i = 0; i < 50000; ++i) mesh.points.push_back({1.0 / (i + 1), i * 1e30, -0.1 * i});
  for (Index i = 0; i + 3 < 50000; ++i) mesh.tetrahedra.push_back({i, i + 1, i + 2, i + 3});
  for (const char* name : {"a.mesh", "a.meshb"}) {
    write_mesh(directory / name, mesh);
    const Mesh back = read_mesh(directory / name);
    EXPECT_EQ(back.points, mesh.points);
    EXPECT_EQ(back.tetrahedra, mesh.tetrahedra);
    EXPECT_EQ(back.tetrahedron_refs, std::vector<int>(mesh.tetrahedra.size(), 0));
  }
}

TEST_F(WriteMesh, LeavesOutWhatIsEmptyButNotWhatAMeshNeeds) {
  write_mesh(directory / "a.mesh", Mesh{});
  EXPECT_EQ(content_of(directory / "a.mesh"),
            "MeshVersionFormatted 2\nDimension 3\n\nVertices\n0\n\nTetrahedra\n0\n\nEnd\n");
  write_mesh(directory / "a.meshb", Mesh{});
  EXPECT_EQ(content_of(directory / "a.meshb"),
            GmfBuilder(2, std::endian::native).dimension().block(4, 0).block(8, 0).end());
  EXPECT_TRUE(read_mesh(directory / "a.meshb").points.empty());
}

TEST_F(WriteMesh, ChecksWhatItIsGiven) {
  const auto error_of = [&](const Mesh& mesh) {
    return message_of<InputError>([&] { write_mesh(directory / "a.meshb", mesh); });
  };
  Mesh mesh = two_tets();
  mesh.triangles[1][2] = 5;
  EXPECT_EQ(error_of(mesh), "Triangles [1]: index 5 found, expected below 5");
  mesh = two_tets();
  mesh.required_edges[0] = 2;
  EXPECT_EQ(error_of(mesh), "RequiredEdges [0]: index 2 found, expected below 2");
  mesh = two_tets();
  mesh.point_refs.pop_back();
  EXPECT_EQ(error_of(mesh), "Vertices: 4 references found, expected 0 or 5");
  EXPECT_EQ(message_of<InputError>([&] { write_mesh(directory / "a.vtk", mesh); }),
            (directory / "a.vtk").string() +
                ": unknown extension \".vtk\", expected .mesh or .meshb, of the Gamma Mesh Format (Medit)");
  EXPECT_EQ(files(), 0U);
}

TEST_F(WriteSolution, RoundTripsInBothEncodings) {
  const std::vector<Field> fields = {{.kind = Field::Kind::tensor, .values = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}},
                                     {.kind = Field::Kind::scalar, .values = {0.1, 5e-324}},
                                     {.kind = Field::Kind::vector, .values = {1, -2, 3, 1e300, 5, 1.0 / 3}}};
  for (const char* name : {"a.sol", "a.solb"}) {
    write_solution(directory / name, fields);
    const std::vector<Field> back = read_solution(directory / name);
    ASSERT_EQ(back.size(), fields.size());
    for (std::size_t i = 0; i < fields.size(); ++i) {
      EXPECT_EQ(back[i].kind, fields[i].kind);
      EXPECT_EQ(back[i].values, fields[i].values);
    }
  }
}

TEST_F(WriteSolution, ChecksWhatItIsGiven) {
  EXPECT_EQ(message_of<InputError>([&] { write_solution(directory / "a.sol", {}); }),
            "solution: at least one field expected, none found");
  const std::vector<Field> uneven = {{.kind = Field::Kind::scalar, .values = {1, 2}},
                                     {.kind = Field::Kind::vector, .values = {1, 2, 3, 4}}};
  EXPECT_EQ(message_of<InputError>([&] { write_solution(directory / "a.solb", uneven); }),
            "solution: field 1: 4 values found, expected 3 for each of 2 vertices");
  EXPECT_EQ(files(), 0U);
}

TEST_F(Atomic, KeepsTheOldFileWhenWritingFails) {
  save(directory / "a.mesh", "old");
  Mesh mesh = two_tets();
  mesh.required_tetrahedra = {2};
  EXPECT_THROW(write_mesh(directory / "a.mesh", mesh), InputError);
  EXPECT_EQ(content_of(directory / "a.mesh"), "old");
  EXPECT_EQ(files(), 1U);
  write_mesh(directory / "a.mesh", two_tets());
  expect_equal(read_mesh(directory / "a.mesh"), two_tets());
  EXPECT_EQ(files(), 1U);
}

TEST_F(Atomic, KeepsTheOldFileWhenSpaceRunsOut) {
  save(directory / "a.meshb", "old");
  Mesh mesh;
  mesh.points.resize(100000);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{.rlim_cur = 1500000, .rlim_max = before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string error = message_of<Failure>([&] { write_mesh(directory / "a.meshb", mesh); });
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(error, (directory / "a.meshb").string() + ": cannot be written: File too large");
  EXPECT_EQ(content_of(directory / "a.meshb"), "old");
  EXPECT_EQ(files(), 1U);
}

TEST_F(Atomic, FailsWhereNoFileCanBe) {
  std::filesystem::create_directory(directory / "a.mesh");
  const std::string base = directory.string();
  for (const auto& write : {+[](const std::filesystem::path& path) { write_mesh(path, two_tets()); },
                            +[](const std::filesystem::path& path) { require_writable(path); }}) {
    EXPECT_EQ(message_of<Failure>([&] { write(directory / "a.mesh"); }),
              base + "/a.mesh: cannot be written: it is a directory");
    EXPECT_EQ(message_of<Failure>([&] { write(directory / "none" / "a.mesh"); }),
              base + "/none/a.mesh: cannot be written: No such file or directory");
  }
  EXPECT_EQ(message_of<Failure>([] { require_writable(""); }), ": cannot be written: no file name given");
  EXPECT_EQ(files(), 1U);
}

TEST_F(Atomic, RequireWritableTouchesNothing) {
  require_writable(directory / "new.mesh");
  EXPECT_EQ(files(), 0U);
  save(directory / "old.mesh", "old");
  const auto time = std::filesystem::last_write_time(directory / "old.mesh");
  require_writable(directory / "old.mesh");
  EXPECT_EQ(content_of(directory / "old.mesh"), "old");
  EXPECT_EQ(std::filesystem::last_write_time(directory / "old.mesh"), time);
  EXPECT_EQ(files(), 1U);
}

TEST(BinaryVersion, Is3BeyondTwoGibibytes) {
  EXPECT_EQ(gmf::version_for(0), 2);
  EXPECT_EQ(gmf::version_for(2147483647 - 64), 2);
  EXPECT_EQ(gmf::version_for(2147483647), 3);
}

}  // namespace
}  // namespace taut::test
