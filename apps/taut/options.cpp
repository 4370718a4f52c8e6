#include "options.hpp"

#include "check.hpp"

namespace taut::program {

CLI::Option* add_complexity(CLI::App& command, double& complexity) {
  return command.add_option("--complexity", complexity, "about 0.4 times the wanted number of vertices")
      ->type_name("N")
      ->check(positive_number());
}

CLI::Option* add_norm(CLI::App& command, double& norm) {
  return command
      .add_option("--norm", norm, "p of the norm of the error that becomes least: a number, 1 or more, or inf")
      ->type_name("P")
      ->capture_default_str()
      ->check(number([](double x) { return x >= 1; }, "a number, 1 or more, or inf"));
}

CLI::Option* add_recovery(CLI::App& command, Recovery& recovery) {
  const auto set_recovery = [&recovery](const std::string& word) {
    recovery = word == word_of(Recovery::double_projection) ? Recovery::double_projection : Recovery::least_squares;
  };
  return command
      .add_option_function<std::string>("--recovery", set_recovery,
                                        "least-squares (the default): fit of a quadratic function around each vertex; "
                                        "projection: gradients averaged twice")
      ->type_name("WORD")
      ->check(one_of({word_of(Recovery::least_squares), word_of(Recovery::double_projection)}));
}

CLI::Option* add_method(CLI::App& command, const char* name, Transfer& method) {
  const auto set_method = [&method](const std::string& word) {
    method = word == word_of(Transfer::linear) ? Transfer::linear : Transfer::conservative;
  };
  return command
      .add_option_function<std::string>(name, set_method,
                                        "conservative (the default): keep the integrals; linear: interpolate")
      ->type_name("WORD")
      ->check(one_of({word_of(Transfer::conservative), word_of(Transfer::linear)}));
}

void add_surface(CLI::App& command, Surface& surface, const std::string& adapt) {
  const auto set_surface = [&surface](const std::string& word) {
    surface = word == "fixed" ? Surface::fixed : word == "planar" ? Surface::planar : Surface::adapt;
  };
  command
      .add_option_function<std::string>(
          "--surface", set_surface,
          "adapt (the default): " + adapt + "; planar: keep patches that are not planar; fixed: keep all triangles")
      ->type_name("WORD")
      ->check(one_of({"adapt", "planar", "fixed"}));
}

CLI::Option* add_size(CLI::App& command, std::optional<double>& size) {
  const auto set_size = [&size](const std::string& word) { size = number_in(word); };
  return command.add_option_function<std::string>("--size", set_size, "one size everywhere, instead of a metric")
      ->type_name("H")
      ->check(positive_number());
}

Metric metric_of_size(double size) {
  const double m = 1 / (size * size);
  return [m](const Point&) { return Tensor{m, 0, 0, m, 0, m}; };
}

namespace {

auto is_ridge_angle() {
  return number([](double x) { return x > 0 && x < 180; }, "degrees between 0 and 180");
}

}  // namespace

void add_ridge_angle(CLI::App& command, double& degrees) {
  command
      .add_option("--angle", degrees,
                  "an edge is a ridge if the normals of its triangles differ by this or more, in degrees")
      ->type_name("DEG")
      ->capture_default_str()
      ->check(is_ridge_angle());
}

void add_ridge_angle(CLI::App& command, std::optional<double>& degrees) {
  const auto set_angle = [&degrees](const std::string& word) { degrees = number_in(word); };
  command
      .add_option_function<std::string>("--angle", set_angle,
                                        "an edge is a ridge if the normals of its triangles differ by this or more, in "
                                        "degrees, instead of by the shape of the surface on its two sides")
      ->type_name("DEG")
      ->check(is_ridge_angle());
}

const char* word_of(Recovery recovery) {
  return recovery == Recovery::double_projection ? "projection" : "least-squares";
}

const char* word_of(Transfer method) {
  return method == Transfer::linear ? "linear" : "conservative";
}

const char* word_of(Surface surface) {
  return surface == Surface::fixed ? "fixed" : surface == Surface::planar ? "planar" : "adapt";
}

}  // namespace taut::program
