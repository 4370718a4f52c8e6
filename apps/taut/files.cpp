#include "files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <system_error>

#include "taut/io.hpp"

namespace taut::program {
namespace {

void require_extension(const std::string& file, std::span<const std::string_view> extensions) {
  const std::string found = std::filesystem::path(file).extension().string();
  if (std::ranges::find(extensions, found) != extensions.end()) return;
  throw InputError(
      fmt::format("{}: unknown extension \"{}\", expected {}", file, found, fmt::join(extensions, " or ")));
}

// The library reports a failure of the work. Here no work has begun, and the name is what is wrong.
void require_place(const std::string& file) {
  try {
    require_writable(file);
  } catch (const Failure& failure) {
    throw InputError(failure.what());
  }
}

std::vector<NamedField> named(const std::vector<Field>& fields, const Tensors& metric) {
  std::vector<NamedField> all;
  all.reserve(fields.size() + 1);
  for (const Field& field : fields) all.push_back({fmt::format("field {}", all.size() + 1), field});
  all.push_back({"metric", field_of(metric)});
  return all;
}

}  // namespace

void require_output(const std::string& file, std::span<const std::string_view> extensions) {
  if (file.empty()) return;
  require_extension(file, extensions);
  require_place(file);
}

void require_different(std::string_view what, const std::string& file, std::string_view other_what,
                       const std::string& other) {
  if (file.empty() || other.empty()) return;
  const auto place = [](const std::string& name) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(name));
  };
  if (place(file) == place(other))
    throw InputError(
        fmt::format("{}: found as the file for the {} and for the {}, expected two files", other, what, other_what));
}

void write_text(const std::string& file, std::string_view text) {
  const std::string temporary = fmt::format("{}.{:08x}.tmp", file, std::random_device{}());
  std::ofstream out(temporary, std::ios::binary);
  out << text;
  out.close();
  std::error_code error;
  if (out) std::filesystem::rename(temporary, file, error);
  if (out && !error) return;
  std::filesystem::remove(temporary, error);
  throw Failure(fmt::format("{}: cannot be written", file));
}

void write_output(const std::string& file, const Mesh& mesh, const std::vector<Field>& fields, const Tensors& metric) {
  if (std::filesystem::path(file).extension() == ".vtu") {
    write_vtu(file, mesh, named(fields, metric));
  } else {
    write_mesh(file, mesh);
  }
}

std::string with_file(std::string_view message, std::string_view mesh, std::span<const Source> others) {
  for (const auto& [prefix, file] : others)
    if (message.starts_with(prefix)) return fmt::format("{}: {}", file, message.substr(prefix.size()));
  return fmt::format("{}: {}", mesh, message);
}

}  // namespace taut::program
