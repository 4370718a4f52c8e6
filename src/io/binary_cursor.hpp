// Reading one block of a binary file.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "io/cursor.hpp"

namespace taut::gmf {

/// Positions take 32 bits up to version 2.
constexpr std::size_t position_bytes(int version) {
  return version >= 3 ? sizeof(std::int64_t) : sizeof(std::int32_t);
}

template <class T, bool swapped>
T load(const char* from) {
  std::array<char, sizeof(T)> bytes;
  std::memcpy(bytes.data(), from, sizeof(T));
  if constexpr (swapped) std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<T>(bytes);
}

/// `Real` is float in version 1, `Int` is 64 bits wide in version 4. integer() and real() rely on a call of expect().
template <class Real, class Int, bool swapped>
class BinaryCursor : public Cursor {
public:
  using Cursor::Cursor;

  [[nodiscard]] std::size_t count(std::size_t before) { return checked_count(header<Int>(), before); }

  /// Always 32 bits wide: the dimension, and the number and the kinds of fields.
  [[nodiscard]] std::int64_t word() { return header<std::int32_t>(); }

  void expect(std::size_t entities, Row row) const {
    if (entities > left() / bytes_of(row)) fail_short(entities);
  }

  /// Where a row begins is known without reading those before it.
  static constexpr bool can_skip = true;
  void skip(std::size_t rows, Row row) { at_ += rows * bytes_of(row); }

  [[nodiscard]] std::int64_t integer() { return take<Int>(); }
  [[nodiscard]] double real() { return take<Real>(); }

  /// Whatever lies between the entities and the next keyword is padding.
  void finish() const {}

private:
  static constexpr std::size_t bytes_of(Row row) { return row.reals * sizeof(Real) + row.integers * sizeof(Int); }

  template <class T>
  T take() {
    const T value = load<T, swapped>(at_);
    at_ += sizeof(T);
    return value;
  }

  template <class T>
  T header() {
    if (left() < sizeof(T)) fail("truncated before its first entry");
    return take<T>();
  }
};

}  // namespace taut::gmf
