// One cursor type for each encoding, version and byte order, so that the loops over entities are free of tests of them.
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>
#include <variant>

#include "base/parallel.hpp"
#include "io/binary_cursor.hpp"
#include "io/text_cursor.hpp"

namespace taut::gmf {

using AnyCursor =
    std::variant<TextCursor, BinaryCursor<float, std::int32_t, false>, BinaryCursor<double, std::int32_t, false>,
                 BinaryCursor<double, std::int64_t, false>, BinaryCursor<float, std::int32_t, true>,
                 BinaryCursor<double, std::int32_t, true>, BinaryCursor<double, std::int64_t, true>>;

template <bool swapped>
AnyCursor binary_cursor(const GmfFile& file, const Block& block) {
  if (file.version == 1) return BinaryCursor<float, std::int32_t, swapped>(file, block);
  if (file.version <= 3) return BinaryCursor<double, std::int32_t, swapped>(file, block);
  return BinaryCursor<double, std::int64_t, swapped>(file, block);
}

inline AnyCursor cursor_at(const GmfFile& file, const Block& block) {
  if (file.encoding == Encoding::text) return TextCursor(file, block);
  return file.swapped ? binary_cursor<true>(file, block) : binary_cursor<false>(file, block);
}

/// Calls read(cursor) for the block and checks that it was read to its end.
template <class Read>
void read_block(const GmfFile& file, const Block& block, Read&& read) {
  AnyCursor any = cursor_at(file, block);
  std::visit(
      [&](auto& in) {
        read(in);
        in.finish();
      },
      any);
}

/// Calls read(cursor, i) for the next `count` rows, which are numbered from `first`: concurrently, where rows can be
/// found without reading those before.
template <class In, class Read>
void for_each_row(In& in, std::size_t first, std::size_t count, Row row, const Read& read) {
  const auto read_rows = [&read, first](In& from, std::size_t begin, std::size_t end) {
    for (std::size_t i = first + begin; i < first + end; ++i) {
      from.row(i);
      read(from, i);
    }
  };
  if constexpr (In::can_skip) {
    const Chunks chunks(count);
    for_each_task(chunks.size(), [&](std::size_t chunk, int) {
      In part = in;
      part.skip(chunks.begin(chunk), row);
      read_rows(part, chunks.begin(chunk), chunks.end(chunk));
    });
    in.skip(count, row);
  } else {
    read_rows(in, 0, count);
  }
}

/// The next real, which must be finite: one that is not would spoil everything computed from it.
template <class In>
double finite(In& in) {
  const double value = in.real();
  if (!std::isfinite(value)) in.fail("finite number expected, found infinity or not-a-number");
  return value;
}

/// Throws InputError unless the file is about three dimensions.
void require_three_dimensions(const GmfFile& file);

}  // namespace taut::gmf
