// A program outside this project: a cube of six tetrahedra, adapted to a uniform size; and what the library throws.
#include <taut/taut.hpp>

#include <algorithm>
#include <array>
#include <cstdio>

namespace {

// One tetrahedron for each path from corner 000 to corner 111 along the axes; odd paths are reversed in orientation.
taut::Mesh cube() {
  taut::Mesh mesh;
  for (int corner = 0; corner < 8; ++corner)
    mesh.points.push_back({double(corner & 1), double(corner >> 1 & 1), double(corner >> 2 & 1)});
  std::array<taut::Index, 3> step = {1, 2, 4};
  do {
    const taut::Index first = step[0], second = step[0] + step[1];
    const bool odd = (step[0] > step[1]) ^ (step[0] > step[2]) ^ (step[1] > step[2]);
    mesh.tetrahedra.push_back({0, odd ? second : first, odd ? first : second, 7});
  } while (std::next_permutation(step.begin(), step.end()));
  return mesh;
}

template <class Error, class Action>
bool throws(const Action& action) {
  try {
    action();
  } catch (const Error&) {
    return true;
  } catch (...) {
  }
  return false;
}

// An exception passes from the library to the program, and from the program through the library.
bool exceptions_arrive() {
  const taut::Mesh mesh = cube();
  return throws<taut::InputError>([&] { (void)taut::adapt(mesh, taut::Sizes{1}); }) &&
         throws<taut::Failure>([&] { taut::write_mesh("/no such folder/out.mesh", mesh); }) &&
         throws<taut::Failure>([] { taut::on_threads(2, [] { throw taut::Failure("mine"); }); });
}

}  // namespace

int main() {
  const taut::Mesh mesh = cube();
  const taut::AdaptResult result = taut::adapt(mesh, taut::Sizes(mesh.points.size(), 0.25));
  std::printf("taut %s: %zu tetrahedra, tau %.3f\n", TAUT_VERSION, result.mesh.tetrahedra.size(),
              result.report.quality.tau);
  const bool adapted = taut::defects(result.mesh).empty() && result.mesh.tetrahedra.size() > 6;
  return adapted && exceptions_arrive() ? 0 : 1;
}
