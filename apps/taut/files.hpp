// The files of a run: which one an error is about, and which ones can be written.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "taut/error.hpp"

namespace taut::program {

inline constexpr std::array<std::string_view, 2> mesh_files = {".mesh", ".meshb"};
inline constexpr std::array<std::string_view, 2> solution_files = {".sol", ".solb"};
inline constexpr std::array<std::string_view, 1> report_files = {".json"};

/// Throws InputError unless `file` has one of the extensions and can be written. Each kind of output has its own
/// extensions, so no two outputs can be the same file. An empty name means no output.
void require_output(const std::string& file, std::span<const std::string_view> extensions);

/// Writes a temporary file beside `file`, then renames it. Throws Failure.
void write_text(const std::string& file, std::string_view text);

/// The library's message about a mesh from file `mesh` and a metric or field from file `values`, prefixed with the name
/// of the file that it is about.
[[nodiscard]] std::string with_file(std::string_view message, std::string_view mesh, std::string_view values);

/// Calls work() and adds the names of the files to its errors: the library does not know where its arrays come from.
template <class Work>
auto with_files(std::string_view mesh, std::string_view values, Work work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw InputError(with_file(error.what(), mesh, values));
  }
}

}  // namespace taut::program
