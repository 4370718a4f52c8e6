// Writing keywords and numbers, in text and in binary. Both sinks offer the same functions:
//   begin(code, count, row, header)   opens a block; header: further numbers behind the count
//   integer(), real(), end_row()
//   finish()                          the keyword End
#pragma once

#include <charconv>
#include <cstdint>
#include <cstring>
#include <span>

#include "io/atomic_file.hpp"
#include "io/binary_cursor.hpp"
#include "io/keywords.hpp"

namespace taut::gmf {

/// Version 2: doubles in the fewest digits that read back as the same bits.
class TextSink {
public:
  explicit TextSink(AtomicFile& file);

  void begin(Code code, std::size_t count, Row row, std::span<const int> header = {});
  void integer(std::int64_t value) { number(value); }
  void real(double value) { number(value); }
  /// Turns the blank behind the last number into the end of the line.
  void end_row() { *(file_.room(0) - 1) = '\n'; }
  void finish();

private:
  void word(std::string_view text);

  template <class T>
  void number(T value) {
    constexpr std::size_t longest = 32;
    char* at = file_.room(longest);
    at = std::to_chars(at, at + longest - 1, value).ptr;
    *at++ = ' ';
    file_.advance(at);
  }

  AtomicFile& file_;
};

/// Version 2, or 3 where positions need 64 bits. In the byte order of this machine, as the format has it.
class BinarySink {
public:
  BinarySink(AtomicFile& file, int version);

  /// How many bytes a block takes, its head included.
  [[nodiscard]] static std::size_t block_bytes(int version, std::size_t count, Row row, std::size_t header);

  void begin(Code code, std::size_t count, Row row, std::span<const int> header = {});
  void integer(std::int64_t value) { put(static_cast<std::int32_t>(value)); }
  void real(double value) { put(value); }
  void end_row() const {}
  void finish();

private:
  template <class T>
  void put(T value) {
    char* at = file_.room(sizeof(T));
    std::memcpy(at, &value, sizeof(T));
    file_.advance(at + sizeof(T));
  }

  void put_head(Code code, std::int64_t next);

  AtomicFile& file_;
  int version_;
  std::int64_t position_ = 0;  ///< of the next keyword
};

/// The version for a file whose blocks take `bytes` in version 2.
constexpr int version_for(std::size_t bytes) {
  // Below the largest 32-bit position by what stands before and behind the blocks, rounded up.
  constexpr std::size_t most = 2147483647 - 64;
  return bytes > most ? 3 : 2;
}

}  // namespace taut::gmf
