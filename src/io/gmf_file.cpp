#include "io/gmf_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>

#include "io/index.hpp"
#include "io/signature.hpp"
#include "taut/error.hpp"

namespace taut::gmf {

Encoding encoding_of(const std::filesystem::path& path, std::string_view text, std::string_view binary) {
  const std::string extension = path.extension().string();
  if (extension == text) return Encoding::text;
  if (extension == binary) return Encoding::binary;
  throw InputError(fmt::format("{}: unknown extension \"{}\", expected {} or {}, of the Gamma Mesh Format (Medit)",
                               path.string(), extension, text, binary));
}

Bytes copy_of(std::string_view content) {
  Bytes bytes{std::make_unique_for_overwrite<char[]>(content.size()), content.size()};
  std::copy(content.begin(), content.end(), bytes.data.get());
  return bytes;
}

const Block* GmfFile::find(Code code) const {
  const auto found = std::find_if(blocks.begin(), blocks.end(), [&](const Block& b) { return b.code == code; });
  return found == blocks.end() ? nullptr : &*found;
}

const Block& GmfFile::require(Code code) const {
  const Block* block = find(code);
  if (block == nullptr) fail(fmt::format("keyword {} expected, not found", name_of(code)));
  return *block;
}

void GmfFile::fail(std::string_view message) const {
  throw InputError(fmt::format("{}: {}", name, message));
}

void GmfFile::fail_at(std::size_t where, std::string_view message) const {
  if (encoding == Encoding::text) fail(fmt::format("line {}: {}", line_of(where), message));
  fail(fmt::format("byte {}: {}", where, message));
}

std::size_t GmfFile::line_of(std::size_t where) const {
  const std::string_view before(bytes.data.get(), where);
  std::size_t line = 1;
  for (std::size_t i = 0; i < before.size(); ++i) {
    // Lines end with "\n", "\r\n" or, from old Macs, "\r".
    line += before[i] == '\n' || (before[i] == '\r' && before.substr(i + 1, 1) != "\n");
  }
  return line;
}

void GmfFile::add(const Block& block) {
  if (role_of(block.code) == Role::once && find(block.code) != nullptr) {
    fail_at(block.begin, fmt::format("keyword {} found a second time", name_of(block.code)));
  }
  blocks.push_back(block);
}

GmfFile parse(std::string name, Bytes bytes) {
  GmfFile file{.name = std::move(name), .bytes = std::move(bytes), .blocks = {}};
  read_signature(file);
  if (file.encoding == Encoding::text) {
    index_text(file);
  } else {
    index_binary(file);
  }
  return file;
}

namespace {

struct Closer {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

Bytes read_whole(const std::filesystem::path& path) {
  const auto fail = [&](const std::string& why) { throw InputError(fmt::format("{}: {}", path.string(), why)); };
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) fail(fmt::format("cannot be read: {}", error.message()));
  const std::unique_ptr<std::FILE, Closer> file(std::fopen(path.string().c_str(), "rb"));
  if (!file) fail(fmt::format("cannot be opened: {}", std::strerror(errno)));
  Bytes bytes{std::make_unique_for_overwrite<char[]>(size), static_cast<std::size_t>(size)};
  const std::size_t got = std::fread(bytes.data.get(), 1, bytes.size, file.get());
  if (got != bytes.size) fail(fmt::format("only {} of {} bytes could be read", got, bytes.size));
  return bytes;
}

}  // namespace

GmfFile open(const std::filesystem::path& path, std::string_view text, std::string_view binary) {
  // A wrong file is named before it is read; in which encoding it is, its content says better than its name.
  (void)encoding_of(path, text, binary);
  return parse(path.string(), read_whole(path));
}

}  // namespace taut::gmf
