#include "io/text_cursor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace taut::gmf {

void TextCursor::finish() {
  at_ = skip_blank(at_, end_);
  if (at_ != end_) fail(fmt::format("next keyword expected, found {}: more values than announced", quoted_token(at_)));
}

std::int64_t TextCursor::unusual_integer() {
  std::int64_t value = 0;
  if (at_ != end_ && *at_ == '+') {
    ++at_;
    if (taken(value)) return value;
    --at_;
  }
  fail(fmt::format("integer expected, found {}", quoted_token(at_)));
}

double TextCursor::unusual_real() {
  // Fortran writes a leading '+', and 'D' for the exponent of a double.
  std::string token(at_, token_end(at_, end_));
  if (token.starts_with('+')) token.erase(0, 1);
  std::replace_if(
      token.begin(), token.end(), [](char c) { return c == 'D' || c == 'd' || c == 'E'; }, 'e');
  double value = 0;
  const auto [stop, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  const bool whole = !token.empty() && stop == token.data() + token.size();
  const bool underflow = error == std::errc::result_out_of_range && token.find("e-") != std::string::npos;
  if (!whole || (error != std::errc{} && !underflow)) {
    fail(fmt::format("finite number expected, found {}", quoted_token(at_)));
  }
  at_ = token_end(at_, end_);
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
