// Input that cannot be used: exit status 2, one line that names the file and the place, nothing written.
#include <ostream>

#include "program/fixture.hpp"
#include "program/meshes.hpp"

namespace taut::test {
namespace {

struct Case {
  const char* name;
  std::string text;                 ///< of the file
  std::vector<std::string> places;  ///< parts of the message

  friend void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }
};

std::string name_of(const testing::TestParamInfo<Case>& info) {
  return info.param.name;
}

class BadMesh : public ProgramTest, public testing::WithParamInterface<Case> {};
class BadMetric : public ProgramTest, public testing::WithParamInterface<Case> {};

TEST_P(BadMesh, IsRefused) {
  write("in.mesh", GetParam().text);
  write("out.mesh", "what was there before");
  std::vector<std::string> parts = GetParam().places;
  parts.push_back("taut: error: in.mesh: ");
  expect_error({"adapt", "in.mesh", "--size", "0.5", "-o", "out.mesh", "--report", "r.json"}, 2, parts);
}

std::string with_third_tet() {
  const std::string text = changed(two_tets, "Vertices 5\n", "Vertices 6\n2 2 2 0\n");
  return changed(text, "Tetrahedra 2\n1 2 3 4 0\n2 3 4 5 0\n", "Tetrahedra 3\n2 3 4 5 0\n3 4 5 6 0\n3 4 5 1 0\n");
}

INSTANTIATE_TEST_SUITE_P(
    , BadMesh,
    testing::Values(
        Case{"empty", "", {}}, Case{"no_mesh", "once upon a time\n", {"MeshVersionFormatted"}},
        Case{"compressed", "\x1f\x8b\x08", {"gzip", "Gamma Mesh Format"}},
        Case{"second_order",
             changed(two_tets, "End", "TetrahedraP2 1\n1 2 3 4 5 1 2 3 4 5 0\nEnd"),
             {"line ", "TetrahedraP2", "order 1"}},
        Case{"flat_dimension", changed(two_tets, "Dimension 3", "Dimension 2"), {"line 2", "expected 3"}},
        Case{"no_tetrahedra", two_tets.substr(0, two_tets.find("Tetrahedra")) + "End\n", {"Tetrahedra"}},
        Case{"truncated", two_tets.substr(0, two_tets.find("2 3 4 5 0")), {"line ", "Tetrahedra"}},
        Case{"malformed", changed(two_tets, "1 2 3 4 0", "1 2 x 4 0"), {"line ", "Tetrahedra", "\"x\""}},
        Case{"index_out_of_range", changed(two_tets, "1 2 3 4 0", "1 2 3 9 0"), {"line 10", "9 found", "1..5"}},
        Case{"index_zero", changed(two_tets, "1 2 3 4 0", "0 2 3 4 0"), {"line 10", "0 found", "1..5"}},
        Case{"flat", changed(two_tets, "0 0 1 0", "0.25 0.25 0 0"), {"tetrahedron 1", "flat"}},
        Case{"repeated_vertex", changed(two_tets, "1 2 3 4 0", "1 2 3 3 0"), {"tetrahedron 1", "repeats vertex 3"}},
        Case{"face_of_three", with_third_tet(), {"face (", "more than two"}},
        Case{"triangle_that_is_no_face",
             changed(two_tets, "End", "Triangles 1\n1 2 5 0\nEnd"),
             {"triangle 1", "(1 2 5)"}},
        Case{"coordinate_not_finite", changed(two_tets, "0 1 0 0", "0 nan 0 0"), {"line ", "Vertices"}},
        Case{"coordinate_too_large", changed(two_tets, "0 1 0 0", "0 1e999 0 0"), {"line 6", "Vertices 3"}}),
    name_of);

TEST_P(BadMetric, IsRefused) {
  write("in.mesh", two_tets);
  write("m.sol", GetParam().text);
  std::vector<std::string> parts = GetParam().places;
  parts.push_back("taut: error: m.sol: ");
  expect_error({"adapt", "in.mesh", "--metric", "m.sol", "-o", "out.mesh", "--metric-out", "o.sol"}, 2, parts);
  expect_error({"quality", "in.mesh", "--metric", "m.sol"}, 2, parts);
}

constexpr Tensor unit = {1, 0, 0, 1, 0, 1};

INSTANTIATE_TEST_SUITE_P(
    , BadMetric,
    testing::Values(
        Case{"too_few", metric_text(Sizes{1, 1, 1, 1}), {"4", "5"}},
        Case{"too_many", metric_text(Sizes{1, 1, 1, 1, 1, 1}), {"6", "5"}},
        Case{"truncated", changed(metric_text(Sizes{1, 2, 3, 4, 5}), "4\n5\nEnd\n", ""), {"line ", "SolAtVertices"}},
        Case{"size_negative", metric_text(Sizes{1, 1, -3, 1, 1}), {"vertex", "-3"}},
        Case{"size_zero", metric_text(Sizes{1, 1, 1, 1, 0}), {"vertex"}},
        Case{"size_not_finite", changed(metric_text(Sizes{1, 1, 1, 7, 1}), "7\n", "inf\n"), {"line ", "SolAtVertices"}},
        Case{"tensor_not_finite",
             changed(metric_text(Tensors{unit, {7, 0, 0, 1, 0, 1}, unit, unit, unit}), "7", "nan"),
             {"line ", "SolAtVertices"}},
        Case{"tensor_indefinite",
             metric_text(Tensors{unit, unit, unit, {1, 2, 0, 1, 0, 1}, unit}),
             {"vertex", "positive definite"}},
        Case{"vectors",
             changed(metric_text(Sizes(15, 1.0)), "SolAtVertices 15\n1 1", "SolAtVertices 5\n1 2"),
             {"vector"}}),
    name_of);

using Missing = ProgramTest;

TEST_F(Missing, Files) {
  write("in.mesh", two_tets);
  expect_error({"adapt", "no.mesh", "--size", "1", "-o", "out.mesh"}, 2, {"no.mesh: "});
  expect_error({"adapt", "in.mesh", "--metric", "no.sol", "-o", "out.mesh"}, 2, {"no.sol: "});
  expect_error({"quality", "no.meshb"}, 2, {"no.meshb: "});
  expect_error({"quality", "in.vtu"}, 2, {"in.vtu: ", ".mesh"});
}

using Outputs = ProgramTest;

// The input is missing too: naming the output shows that it was checked first.
TEST_F(Outputs, AreCheckedBeforeAnyWork) {
  const auto refused = [&](const Words& more, const std::string& file) {
    Words words = {"adapt", "no.mesh", "--size", "1"};
    words.insert(words.end(), more.begin(), more.end());
    expect_error(words, 2, {"taut: error: " + file + ": "});
  };
  std::filesystem::create_directory("folder.mesh");
  refused({"-o", "no/out.mesh"}, "no/out.mesh");
  refused({"-o", "folder.mesh"}, "folder.mesh");
  refused({"-o", "out.vtk"}, "out.vtk");
  refused({"-o", "out"}, "out");
  refused({"-o", "out.mesh", "--report", "no/r.json"}, "no/r.json");
  refused({"-o", "out.mesh", "--report", "report"}, "report");
  refused({"-o", "out.mesh", "--metric-out", "no/m.sol"}, "no/m.sol");
  refused({"-o", "out.mesh", "--metric-out", "m.mesh"}, "m.mesh");
}

}  // namespace
}  // namespace taut::test
