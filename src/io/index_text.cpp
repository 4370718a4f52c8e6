// Text files: a keyword is a token that begins with a letter, except for names of numbers. Unknown ones end the block
// before them and are passed over.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "io/index.hpp"
#include "io/text_cursor.hpp"

namespace taut::gmf {
namespace {

constexpr bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

/// Values like these begin no block: then reading it finds them in their places.
bool names_value(std::string_view token) {
  constexpr std::array<std::string_view, 3> values = {"nan", "inf", "infinity"};
  const auto same = [](char a, char b) { return (a | 0x20) == b; };  // in either case
  return std::ranges::any_of(values, [&](std::string_view value) { return std::ranges::equal(token, value, same); });
}

/// Calls visit(keyword or null, begin, end) with the place of each token that begins with a letter and is no value,
/// until it says false.
template <class Visitor>
void for_each_word(const char* begin, const char* end, Visitor visit) {
  for (const char* p = skip_blank(begin, end); p != end;) {
    const char* stop = token_end(p, end);
    if (is_letter(*p) && !names_value({p, stop}) && !visit(find_keyword({p, stop}), p, stop)) return;
    p = skip_blank(stop, end);
  }
}

/// Windows editors put it before UTF-8.
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

void read_version(GmfFile& file) {
  if (file.blocks.empty() || file.blocks.front().code != Code::version) {
    file.fail("not a Gamma Mesh Format file: it does not begin with MeshVersionFormatted");
  }
  TextCursor in(file, file.blocks.front());
  const std::int64_t version = in.integer();
  // bamg writes 0, and that its meshes are plane can be said better.
  if (version < 0 || version > 4) in.fail(fmt::format("{} found, expected 1..4", version));
  in.finish();
  file.version = static_cast<int>(version);
}

}  // namespace

void index_text(GmfFile& file) {
  const char* begin = file.bytes.data.get();
  const char* end = begin + file.bytes.size;
  const auto offset = [&](const char* p) { return static_cast<std::size_t>(p - begin); };
  const bool marked = std::string_view(begin, file.bytes.size).starts_with(byte_order_mark);
  bool open = false;  // the last block lasts until the word now met
  for_each_word(begin + (marked ? byte_order_mark.size() : 0), end,
                [&](const Keyword* keyword, const char* word, const char* stop) {
                  if (open) file.blocks.back().end = offset(word);
                  open = keyword != nullptr && keyword->code != Code::end;
                  if (open) file.add({keyword->code, offset(stop), file.bytes.size});
                  return keyword == nullptr || open;
                });
  read_version(file);
}

}  // namespace taut::gmf
