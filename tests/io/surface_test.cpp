// Surfaces as files: meshes whose triangles are what counts.
#include "io/gmf_builder.hpp"
#include "taut/io.hpp"

namespace taut::test {
namespace {

using Surfaces = InDirectory;

const SurfaceMesh square = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};

TEST_F(Surfaces, RoundTrip) {
  for (const char* name : {"a.mesh", "a.meshb"}) {
    write_surface(directory / name, square);
    const SurfaceMesh back = read_surface(directory / name);
    EXPECT_EQ(back.points, square.points);
    EXPECT_EQ(back.triangles, square.triangles);
    EXPECT_TRUE(read_mesh(directory / name).tetrahedra.empty());
  }
}

TEST_F(Surfaces, NeedTrianglesButNoTetrahedra) {
  const std::string begin = "MeshVersionFormatted 2 Dimension 3 Vertices 3 0 0 0 0 1 0 0 0 0 1 0 0 ";
  const auto file = [&](const std::string& rest) {
    std::ofstream(directory / "a.mesh") << begin << rest << " End";
    return directory / "a.mesh";
  };
  EXPECT_EQ(read_surface(file("Triangles 1 1 2 3 7")).triangles.size(), 1U);
  const std::string message = message_of<InputError>([&] { (void)read_surface(file("Tetrahedra 0")); });
  EXPECT_TRUE(message.ends_with("a.mesh: keyword Triangles expected, not found")) << message;
}

TEST_F(Surfaces, EdgesAloneAreEnoughForLines) {
  std::ofstream(directory / "a.mesh") << "MeshVersionFormatted 2 Dimension 3 Vertices 2 0 0 0 0 1 0 0 0 "
                                         "Edges 1 1 2 7 Ridges 1 1 End";
  const Mesh lines = read_edges(directory / "a.mesh");
  EXPECT_EQ(lines.edges, (std::vector<std::array<Index, 2>>{{0, 1}}));
  EXPECT_EQ(lines.edge_refs, (std::vector<int>{7}));
  EXPECT_EQ(lines.ridges, (std::vector<Index>{0}));
  write_surface(directory / "b.mesh", square);
  const std::string message = message_of<InputError>([&] { (void)read_edges(directory / "b.mesh"); });
  EXPECT_TRUE(message.ends_with("b.mesh: keyword Edges expected, not found")) << message;
}

TEST_F(Surfaces, OfAVolumeMeshAreItsTriangles) {
  write_mesh(directory / "a.meshb", two_tets());
  EXPECT_EQ(read_surface(directory / "a.meshb").triangles, two_tets().triangles);
}

}  // namespace
}  // namespace taut::test
