// Checks of single values of the command line; each names what was found and what was expected.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace taut::program {

/// The number that the whole `word` spells, if it is one.
[[nodiscard]] std::optional<double> number_in(std::string_view word);

/// A number for which fits() holds. `expected` ends the sentence "... found, expected ...".
[[nodiscard]] CLI::Validator number(std::function<bool(double)> fits, std::string expected);

[[nodiscard]] CLI::Validator positive_number();
[[nodiscard]] CLI::Validator count();

/// The option --threads.
void add_threads(CLI::App& command, int& threads);

/// Either `word` or what `other` accepts.
[[nodiscard]] CLI::Validator word_or(std::string word, const CLI::Validator& other);

[[nodiscard]] CLI::Validator one_of(std::vector<std::string> words);

}  // namespace taut::program
