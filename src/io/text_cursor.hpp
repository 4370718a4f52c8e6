// Reading one block of a text file: numbers between blanks, comments from '#' to the end of the line.
//
//   integer  = [sign] digits
//   real     = [sign] (digits ["." [digits]] | "." digits) [exponent]
//   exponent = ("e" | "E" | "d" | "D") [sign] digits | sign digits, of three digits or more
//   sign     = "+" | "-"
//
// The second exponent and the D are Fortran's. A real too small for a double is 0; one too large is refused, as are the
// words for infinity and not-a-number, and an integer with a fraction or an exponent.
#pragma once

#include <charconv>
#include <cstdint>

#include "io/cursor.hpp"

namespace taut::gmf {

/// Control characters count as blanks, carriage returns among them.
constexpr bool is_blank(char c) {
  return static_cast<unsigned char>(c) <= ' ';
}
constexpr bool ends_token(char c) {
  return is_blank(c) || c == '#';
}

/// The start of the next token, or `end`.
constexpr const char* skip_blank(const char* at, const char* end) {
  while (at != end && ends_token(*at)) {
    if (*at == '#') {
      while (at != end && *at != '\n' && *at != '\r') ++at;
    } else {
      ++at;
    }
  }
  return at;
}

constexpr const char* token_end(const char* at, const char* end) {
  while (at != end && !ends_token(*at)) ++at;
  return at;
}

class TextCursor : public Cursor {
public:
  using Cursor::Cursor;
  static constexpr bool can_skip = false;

  [[nodiscard]] std::size_t count(std::size_t before) { return checked_count(integer(), before); }
  [[nodiscard]] std::int64_t word() { return integer(); }

  void expect(std::size_t entities, Row row) const {
    // The shortest number is a digit and a blank, and the last one needs no blank.
    if (entities > (left() + 1) / (2 * row.values())) fail_short(entities);
  }

  [[nodiscard]] std::int64_t integer() {
    at_ = skip_blank(at_, end_);
    std::int64_t value = 0;
    return taken(value) ? value : unusual_integer();
  }

  [[nodiscard]] double real() {
    at_ = skip_blank(at_, end_);
    double value = 0;
    return taken(value) ? value : unusual_real();
  }

  void finish();

private:
  /// Takes what C writes, with a blank behind it. All else is left to the slower functions below.
  template <class T>
  bool taken(T& value) {
    const auto [stop, error] = std::from_chars(at_, end_, value);
    if (error != std::errc{} || (stop != end_ && !is_blank(*stop))) return false;
    at_ = stop;
    return true;
  }

  [[nodiscard]] bool at_plus() const { return end_ - at_ > 1 && at_[0] == '+' && at_[1] != '-'; }
  std::int64_t unusual_integer();
  double unusual_real();
  [[noreturn]] void fail_short(std::size_t entities) const;
  /// For messages; `at` may be the end of the block, where the next keyword begins.
  [[nodiscard]] std::string quoted_token(const char* at) const;
};

}  // namespace taut::gmf
