#include "geometry_file.hpp"

#include <fmt/format.h>

#include <initializer_list>

#include "files.hpp"
#include "options.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut::program {

void add_geometry(CLI::App& command, std::string& file, const std::string& more) {
  command
      .add_option("--geometry", file,
                  "triangles or tetrahedra, .mesh or .meshb, whose curved surface the vertices of the boundary are to "
                  "lie on, instead of that of IN; " +
                      more)
      ->type_name("FILE");
}

void require_adapted_surface(const std::string& file, Surface surface, const std::string& command) {
  if (!file.empty() && surface != Surface::adapt)
    throw InputError(fmt::format("--geometry with --surface {} found, expected --surface adapt; see 'taut {} --help'",
                                 word_of(surface), command));
}

std::optional<Geometry> read_geometry(const std::string& file, std::optional<double> ridge_angle) {
  if (file.empty()) return std::nullopt;
  const Mesh mesh = read_boundary(file);
  return with_files(file, std::initializer_list<Source>{},
                    [&] { return Geometry(mesh, {.ridge_angle = ridge_angle}); });
}

}  // namespace taut::program
