#include "io/sinks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "taut/error.hpp"

namespace taut::gmf {
namespace {

/// A head holds the number of the keyword and the position of the next one.
constexpr std::size_t head_bytes(int version) {
  return sizeof(std::int32_t) + position_bytes(version);
}

}  // namespace

TextSink::TextSink(AtomicFile& file) : file_(file) {
  word(name_of(Code::version));
  integer(2);
  end_row();
  word(name_of(Code::dimension));
  integer(3);
  end_row();
}

void TextSink::begin(Code code, std::size_t count, Row, std::span<const int> header) {
  file_.advance(std::fill_n(file_.room(1), 1, '\n'));
  word(name_of(code));
  end_row();
  integer(static_cast<std::int64_t>(count));
  end_row();
  for (const int value : header) integer(value);
  if (!header.empty()) end_row();
}

void TextSink::finish() {
  file_.advance(std::fill_n(file_.room(1), 1, '\n'));
  word(name_of(Code::end));
  end_row();
}

void TextSink::word(std::string_view text) {
  char* at = file_.room(text.size() + 1);
  at = std::copy(text.begin(), text.end(), at);
  *at++ = ' ';
  file_.advance(at);
}

BinarySink::BinarySink(AtomicFile& file, int version) : file_(file), version_(version) {
  put(std::int32_t{1});
  put(std::int32_t{version});
  position_ = static_cast<std::int64_t>(2 * sizeof(std::int32_t) + head_bytes(version) + sizeof(std::int32_t));
  put_head(Code::dimension, position_);
  put(std::int32_t{3});
}

std::size_t BinarySink::block_bytes(int version, std::size_t count, Row row, std::size_t header) {
  const std::size_t row_bytes = row.reals * sizeof(double) + row.integers * sizeof(std::int32_t);
  return head_bytes(version) + sizeof(std::int32_t) * (1 + header) + count * row_bytes;
}

void BinarySink::begin(Code code, std::size_t count, Row row, std::span<const int> header) {
  if (count > std::numeric_limits<std::int32_t>::max()) {
    throw Failure(fmt::format("{}: {} entries are too many for a binary file of version 3", name_of(code), count));
  }
  position_ += static_cast<std::int64_t>(block_bytes(version_, count, row, header.size()));
  put_head(code, position_);
  integer(static_cast<std::int64_t>(count));
  for (const int value : header) integer(value);
}

void BinarySink::finish() {
  put_head(Code::end, 0);
}

void BinarySink::put_head(Code code, std::int64_t next) {
  put(static_cast<std::int32_t>(code));
  if (version_ >= 3) {
    put(next);
  } else {
    put(static_cast<std::int32_t>(next));
  }
}

}  // namespace taut::gmf
