// What the readers of both encodings share: where they stand, and how they name the place of an error.
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>

#include "io/gmf_file.hpp"

namespace taut::gmf {

/// Walks through one block. A derived cursor offers
///   count(before)   the announced number of entities, not negative, that with those before fits taut's 32-bit indices
///   word()          a number of the block's header
///   expect(n, row)  throws if n such rows cannot be in the block; to be called before memory is taken for them
///   integer(), real()
///   can_skip, and if true skip(n, row)
///   finish()        throws if the block holds more
class Cursor {
public:
  Cursor(const GmfFile& file, const Block& block)
      : file_(&file),
        code_(block.code),
        at_(file.bytes.data.get() + block.begin),
        end_(file.bytes.data.get() + block.end) {}

  /// The entity that is read now, from 0; for messages.
  void row(std::size_t number) { row_ = number; }

  /// Throws InputError "file: line: keyword entity: message".
  [[noreturn]] void fail(std::string_view message) const;

protected:
  [[nodiscard]] std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }
  /// Throws InputError: so many entries cannot be in what is left of the block.
  [[noreturn]] void fail_short(std::size_t entries) const;
  [[nodiscard]] std::size_t checked_count(std::int64_t found, std::size_t before) const;

  const GmfFile* file_;
  Code code_;
  const char* at_;
  const char* end_;

private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::size_t row_ = none;
};

}  // namespace taut::gmf
