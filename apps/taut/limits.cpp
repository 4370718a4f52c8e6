#include "limits.hpp"

#include <fmt/format.h>

#include <cmath>

#include "check.hpp"
#include "taut/error.hpp"

namespace taut::program {

namespace {

void add_bounds(CLI::App& command, Limits& bounds) {
  command.add_option("--hmin", bounds.hmin, "smallest size; smaller ones become H")
      ->type_name("H")
      ->check(positive_number());
  command.add_option("--hmax", bounds.hmax, "largest size; larger ones become H")
      ->type_name("H")
      ->check(positive_number());
  command.add_option("--anisotropy", bounds.anisotropy, "largest ratio of two sizes at one place; longer ones shrink")
      ->type_name("A")
      ->check(number([](double x) { return x >= 1; }, "a number, 1 or more"));
}

void add_gradation(CLI::App& command, AskedLimits& limits) {
  const auto set_beta = [&limits](const std::string& word) { limits.beta = number_in(word); };
  CLI::Option* beta =
      command
          .add_option_function<std::string>(
              "--gradation", set_beta, "largest factor by which sizes may grow per unit length, or off (the default)")
          ->type_name("BETA")
          ->check(word_or("off", number([](double x) { return x > 1 && std::isfinite(x); }, "a number above 1")));
  command
      .add_option("--gradation-mix", limits.mix,
                  "0: growth per unit length in the metric; 1: per physical size; or a mix of both")
      ->type_name("T")
      ->capture_default_str()
      ->needs(beta)
      ->check(number([](double x) { return x >= 0 && x <= 1; }, "a number from 0 to 1"));
}

}  // namespace

void add_limits(CLI::App& command, AskedLimits& limits) {
  add_bounds(command, limits.bounds);
  add_gradation(command, limits);
}

Limits limits_of(const AskedLimits& asked) {
  Limits limits = asked.bounds;
  if (asked.beta) limits.gradation = Gradation{.beta = *asked.beta, .mix = asked.mix};
  return limits;
}

void require_sound(const AskedLimits& limits, std::string_view command) {
  const auto& [hmin, hmax, anisotropy, gradation] = limits.bounds;
  if (hmin > hmax)
    throw InputError(
        fmt::format("--hmin: {} found, expected at most --hmax {}; see 'taut {} --help'", hmin, hmax, command));
}

}  // namespace taut::program
