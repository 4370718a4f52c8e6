// The files of a run: who is to blame for an error, and what may be written.
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

/// Throws InputError unless `file` has one of the extensions and can be written. As each kind of output has its own
/// extensions, no two outputs are one file. An empty name stands for no output.
void require_output(const std::string& file, std::span<const std::string_view> extensions);

/// Writes a temporary file beside `file`, then renames it. Throws Failure.
void write_text(const std::string& file, std::string_view text);

/// The message of the library on a mesh in `mesh` with the metric in `metric`, with the file that it is about in front.
[[nodiscard]] std::string with_file(std::string_view message, std::string_view mesh, std::string_view metric);

/// Calls work(). The library does not know the names of the files that its arrays come from, so they are added here.
template <class Work>
auto with_files(std::string_view mesh, std::string_view metric, Work work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw InputError(with_file(error.what(), mesh, metric));
  }
}

}  // namespace taut::program
