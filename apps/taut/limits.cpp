#include "limits.hpp"

#include <fmt/format.h>

#include <cmath>

#include "check.hpp"
#include "taut/error.hpp"

namespace taut::program {

void add_limits(CLI::App& command, Limits& limits) {
  command.add_option("--hmin", limits.hmin, "smallest size; smaller ones become H")
      ->type_name("H")
      ->check(positive_number());
  command.add_option("--hmax", limits.hmax, "largest size; larger ones become H")
      ->type_name("H")
      ->check(positive_number());
  command
      .add_option("--anisotropy", limits.anisotropy,
                  "largest ratio of two sizes at one place; longer ones are shortened")
      ->type_name("A")
      ->check(number([](double x) { return x >= 1; }, "a number, 1 or more"));
  const auto set_gradation = [&limits](const std::string& word) {
    limits.gradation.reset();
    if (const auto beta = number_in(word)) limits.gradation = Gradation{.beta = *beta};
  };
  command
      .add_option_function<std::string>("--gradation", set_gradation,
                                        "largest factor by which sizes may grow per unit length, or off (the default)")
      ->type_name("BETA")
      ->check(word_or("off", number([](double x) { return x > 1 && std::isfinite(x); }, "a number above 1")));
}

void add_norm(CLI::App& command, double& norm) {
  command.add_option("--norm", norm, "p of the norm of the error that becomes least: a number, 1 or more, or inf")
      ->type_name("P")
      ->capture_default_str()
      ->check(number([](double x) { return x >= 1; }, "a number, 1 or more, or inf"));
}

void require_sound(const Limits& limits, const CLI::App& command) {
  if (limits.hmin > limits.hmax)
    throw InputError(fmt::format("--hmin: {} found, expected at most --hmax {}; see 'taut {} --help'", limits.hmin,
                                 limits.hmax, command.get_name()));
}

}  // namespace taut::program
