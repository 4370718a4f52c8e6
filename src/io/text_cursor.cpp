#include "io/text_cursor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace taut::gmf {
namespace {

/// A number in the notation of C. Fortran writes 'D' for the exponent of a double, and before three digits of an
/// exponent no letter at all.
class PlainNumber {
public:
  /// Empty if `token` is longer than any number.
  explicit PlainNumber(std::string_view token) {
    if (token.size() > longest) return;
    for (std::size_t i = 0; i < token.size(); ++i) {
      if (begins_exponent(token.substr(i))) text_[size_++] = 'e';
      const bool letter = token[i] == 'D' || token[i] == 'd' || token[i] == 'E';
      text_[size_++] = letter ? 'e' : token[i];
    }
  }

  [[nodiscard]] std::string_view view() const { return {text_.data(), size_}; }

private:
  /// So few digits cannot make up for an exponent that is too small for a double.
  static constexpr std::size_t longest = 200;

  /// Whether a sign stands here where a letter ought to stand before it.
  [[nodiscard]] bool begins_exponent(std::string_view rest) const {
    // With fewer digits these would be two numbers that a narrow column has joined.
    constexpr std::size_t fewest_digits = 3;
    if ((rest.front() != '+' && rest.front() != '-') || rest.size() <= fewest_digits) return false;
    return size_ != 0 && text_[size_ - 1] != 'e';
  }

  std::array<char, 2 * longest> text_;
  std::size_t size_ = 0;
};

/// Old C libraries of Windows write "1.#INF" and the like, which must not pass for a 1 and a comment.
bool names_no_number(std::string_view rest) {
  constexpr std::array<std::string_view, 4> words = {"#INF", "#IND", "#QNAN", "#SNAN"};
  return std::any_of(words.begin(), words.end(), [rest](std::string_view word) { return rest.starts_with(word); });
}

}  // namespace

void TextCursor::finish() {
  at_ = skip_blank(at_, end_);
  if (at_ == end_) return;
  // gmsh writes the nodes of cubic elements behind those of the linear ones.
  fail(fmt::format("next keyword expected, found {}: more values than announced, or elements that are not linear",
                   quoted_token(at_)));
}

std::int64_t TextCursor::unusual_integer() {
  const char* token = at_ + (at_plus() ? 1 : 0);
  const char* token_stop = token_end(token, end_);
  std::int64_t value = 0;
  const auto [stop, error] = std::from_chars(token, token_stop, value);
  if (error != std::errc{} || stop != token_stop) fail(fmt::format("integer expected, found {}", quoted_token(at_)));
  at_ = stop;
  return value;
}

double TextCursor::unusual_real() {
  const PlainNumber number({at_ + (at_plus() ? 1 : 0), token_end(at_, end_)});
  const std::string_view text = number.view();
  double value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = !text.empty() && stop == text.data() + text.size();
  const bool underflow = error == std::errc::result_out_of_range && text.find("e-") != std::string_view::npos;
  if (!whole || (error != std::errc{} && !underflow)) {
    fail(fmt::format("finite number expected, found {}", quoted_token(at_)));
  }
  at_ = token_end(at_, end_);
  if (names_no_number({at_, end_})) fail("finite number expected, found infinity or not-a-number");
  return underflow ? 0 : value;
}

void TextCursor::fail_short(std::size_t entities) const {
  fail(fmt::format("{} entries announced, but only {} bytes follow before {}", entities, left(), quoted_token(end_)));
}

std::string TextCursor::quoted_token(const char* at) const {
  constexpr std::size_t longest = 40;
  const char* file_end = file_->bytes.data.get() + file_->bytes.size;
  if (at == file_end) return "the end of the file";
  std::string token(at, std::min(token_end(at, file_end), at + std::min<std::ptrdiff_t>(longest, file_end - at)));
  std::replace_if(
      token.begin(), token.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return fmt::format("\"{}\"", token);
}

}  // namespace taut::gmf
