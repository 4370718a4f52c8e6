// Parts from CAD: sharp, smooth, thin, of several regions, to sizes of all kinds, and to and fro.
#include "adapt/part_accuracy.hpp"
#include "adapt/part_metrics.hpp"

namespace taut::test {
namespace {

/// Patches, lines, corners and planes as before; the rest on the exact surfaces.
void expect_part(const Mesh& out, const Part& part, const Mesh& in) {
  const std::map<int, Shape> shapes = shapes_of(part, in);
  expect_same_topology(out, in);
  expect_same_lines(out, in);
  expect_same_planes(out, in, shapes);
  const Accuracy accuracy = accuracy_of(out, shapes);
  EXPECT_LE(accuracy.of_vertices, part.accuracy);
  EXPECT_LE(accuracy.excess, part.accuracy) << "triangles are farther from the surface than flat ones need to be";
  const auto found = volumes(out);
  ASSERT_EQ(found.size(), part.volume.size());
  for (const auto& [ref, volume] : part.volume) {
    ASSERT_TRUE(found.contains(ref));
    EXPECT_NEAR(found.at(ref), volume, accuracy.volume + 1e-12 * volume) << "region " << ref;
  }
}

using Case = std::tuple<Part, Wanted>;

class Parts : public ::testing::TestWithParam<Case> {};

TEST_P(Parts, StayWhatTheyAre) {
  const auto& [part, wanted] = GetParam();
  const Mesh in = mesh_of(part);
  AdaptOptions options;
  if (wanted == Wanted::deviation) options.deviation = deviation_for(in);
  const AdaptResult result = adapt(in, metric_for(in, wanted, diagonal_of(in)), options);
  expect_valid(result, in);
  expect_part(result.mesh, part, in);
  EXPECT_EQ(result.report.triangles_frozen, 0);
  EXPECT_LE(result.report.quality.Q_max, part.worst_Q);
  EXPECT_GE(result.report.quality.unit_edges, wanted == Wanted::finer ? 0.75 : part.unit_edges);
  // Edges of the metric for half of the deviation may be twice as far, the centre of triangles a third more.
  if (options.deviation > 0) {
    EXPECT_LE(accuracy_of(result.mesh, shapes_of(part, in)).of_triangles, 2 * options.deviation + part.accuracy);
  }
}

class PartGeometry : public ::testing::TestWithParam<Part> {};

/// Vertices of coarse spheres next to a ridge look like tips.
TEST_P(PartGeometry, HasTheCornersOfThePart) {
  const Mesh in = mesh_of(GetParam());
  std::set<Point> on_surface;
  for (const Index p : surface_points(in)) on_surface.insert(in.points[p]);
  const auto corners = std::ranges::count_if(corners_of(in), [&](const Point& p) { return on_surface.contains(p); });
  const int tips = GetParam().name == "cone" ? 1 : 0;
  EXPECT_EQ(Geometry(in).corners(), static_cast<std::size_t>(corners + tips));
}

std::string letters_of(std::string name) {
  std::ranges::replace(name, '-', '_');
  return name;
}

Part part_of(const std::string& name) {
  const std::vector<Part> all = parts();
  return *std::ranges::find(all, name, &Part::name);
}

INSTANTIATE_TEST_SUITE_P(FromCad, PartGeometry, ::testing::ValuesIn(parts()),
                         [](const auto& of) { return letters_of(of.param.name); });

INSTANTIATE_TEST_SUITE_P(FromCad, Parts,
                         ::testing::Combine(::testing::ValuesIn(parts()),
                                            ::testing::Values(Wanted::finer, Wanted::coarser, Wanted::random,
                                                              Wanted::deviation, Wanted::curvature)),
                         [](const auto& of) {
                           std::ostringstream name;
                           name << std::get<0>(of.param) << '_' << std::get<1>(of.param);
                           return letters_of(name.str());
                         });

class PartsInCycles : public ::testing::TestWithParam<Part> {};

double missing_volume(const Mesh& mesh, const Part& part) {
  const auto [ref, volume] = *part.volume.begin();
  return volumes(mesh).at(ref) - volume;
}

// On one geometry errors do not add up. Compared are meshes of one size, which miss some of the volume.
TEST_P(PartsInCycles, ErrorsAfterTwentyAreThoseAfterOne) {
  const Part part = GetParam();
  const Mesh in = mesh_of(part);
  const auto shapes = shapes_of(part, in);
  const Geometry geometry(in);
  const auto adapted = [&](const Mesh& mesh, double share) {
    return adapt(mesh, Sizes(mesh.points.size(), share * size_of(in)), {.geometry = geometry});
  };
  Mesh first, last = in;
  for (int cycle = 0; cycle < 20; ++cycle) {
    const AdaptResult coarse = adapted(last, 1.7), fine = adapted(coarse.mesh, 0.8);
    expect_valid(fine, coarse.mesh);
    EXPECT_EQ(fine.report.off_surface, 0);
    last = fine.mesh;
    if (cycle == 0) first = last;
  }
  expect_part(last, part, in);
  const Accuracy before = accuracy_of(first, shapes), after = accuracy_of(last, shapes);
  EXPECT_LT(after.of_vertices, 1.1 * before.of_vertices);
  EXPECT_LT(after.mean, 1.1 * before.mean);
  EXPECT_NEAR(missing_volume(last, part) / missing_volume(first, part), 1, 0.1);
}

INSTANTIATE_TEST_SUITE_P(FromCad, PartsInCycles, ::testing::Values(part_of("plate-with-hole"), part_of("ball-in-box")),
                         [](const auto& of) { return letters_of(of.param.name); });

}  // namespace
}  // namespace taut::test
