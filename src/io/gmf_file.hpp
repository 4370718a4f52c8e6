// A Gamma Mesh Format file in memory, and where its keywords stand. Nothing of what they hold is read yet.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "io/keywords.hpp"

namespace taut::gmf {

enum class Encoding { text, binary };

/// That of a file to be written, by the extension of `path`. Throws InputError naming the two that are known.
[[nodiscard]] Encoding encoding_of(const std::filesystem::path& path, std::string_view text, std::string_view binary);

/// A buffer that is not cleared before it is filled, as std::vector and std::string would do.
struct Bytes {
  std::unique_ptr<char[]> data;
  std::size_t size = 0;
};

[[nodiscard]] Bytes copy_of(std::string_view content);

/// What belongs to one keyword: the bytes behind it up to the next keyword.
struct Block {
  Code code{};
  std::size_t begin = 0, end = 0;
};

struct GmfFile {
  std::string name;  ///< for messages
  Encoding encoding = Encoding::text;
  Bytes bytes;
  int version = 0;
  bool swapped = false;       ///< the byte order is not that of this machine
  std::vector<Block> blocks;  ///< of known keywords, in the order of the file

  /// The first block of a keyword.
  [[nodiscard]] const Block* find(Code code) const;
  [[nodiscard]] const Block& require(Code code) const;

  [[noreturn]] void fail(std::string_view message) const;
  /// Names the line of a text file, the position in a binary one.
  [[noreturn]] void fail_at(std::size_t where, std::string_view message) const;
  [[nodiscard]] std::size_t line_of(std::size_t where) const;

  /// Refuses a keyword that comes a second time and may not.
  void add(const Block& block);
};

/// Finds the keywords, in text or binary as the first bytes say. `name` is for messages. Throws InputError.
[[nodiscard]] GmfFile parse(std::string name, Bytes bytes);

/// Reads the whole file at once, then as above. Throws InputError if its extension is neither of the two.
[[nodiscard]] GmfFile open(const std::filesystem::path& path, std::string_view text, std::string_view binary);

}  // namespace taut::gmf
