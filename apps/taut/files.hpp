// The files of a run: which one an error is about, and which ones can be written.
#pragma once

#include <array>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "taut/error.hpp"
#include "taut/field.hpp"
#include "taut/mesh.hpp"
#include "taut/metric.hpp"

namespace taut::program {

inline constexpr std::array<std::string_view, 2> mesh_files = {".mesh", ".meshb"};
inline constexpr std::array<std::string_view, 3> mesh_outputs = {".mesh", ".meshb", ".vtu"};
inline constexpr std::array<std::string_view, 2> solution_files = {".sol", ".solb"};
inline constexpr std::array<std::string_view, 1> report_files = {".json"};

/// Throws InputError unless `file` has one of the extensions and can be written. Each kind of output has its own
/// extensions, so only two outputs of one kind can be the same file. An empty name means no output.
void require_output(const std::string& file, std::span<const std::string_view> extensions);

/// Throws InputError if both names lead to the same file, unless one is empty. The message says what each is for.
void require_different(std::string_view what, const std::string& file, std::string_view other_what,
                       const std::string& other);

/// Writes a temporary file beside `file`, then renames it. Throws Failure.
void write_text(const std::string& file, std::string_view text);

/// Writes one of the mesh_outputs. Only a .vtu file, which ParaView opens, holds the values at the vertices: the fields
/// as "field 1" and so on, and the metric. Throws Failure.
void write_output(const std::string& file, const Mesh& mesh, const std::vector<Field>& fields, const Tensors& metric);

/// A file that the library's messages may be about. They then begin with `prefix`, because the library does not know
/// where its arrays come from.
struct Source {
  std::string_view prefix, file;
};

/// The library's message with the prefix replaced by the name of the file; about `mesh` if it has none of the prefixes.
[[nodiscard]] std::string with_file(std::string_view message, std::string_view mesh, std::span<const Source> others);

/// Calls work() and adds the names of the files to its errors.
template <class Work>
auto with_files(std::string_view mesh, std::initializer_list<Source> others, Work work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw InputError(with_file(error.what(), mesh, {others.begin(), others.size()}));
  }
}

/// The same for one file of values at the vertices.
template <class Work>
auto with_files(std::string_view mesh, std::string_view values, Work work) {
  return with_files(mesh, {{"metric: ", values}, {"field: ", values}}, std::move(work));
}

}  // namespace taut::program
