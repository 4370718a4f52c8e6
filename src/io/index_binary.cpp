// Binary files: int32 1, int32 version, then a chain of keywords, each with the position of the next.
#include <fmt/format.h>

#include <cstring>

#include "io/binary_cursor.hpp"
#include "io/index.hpp"

namespace taut::gmf {
namespace {

constexpr std::size_t header_bytes = 8;

class Indexer {
public:
  explicit Indexer(GmfFile& file) : file_(file) {}

  void run() {
    read_header();
    for (std::size_t position = header_bytes; position != 0;) position = read_keyword(position);
  }

private:
  template <class T>
  [[nodiscard]] T value_at(std::size_t position) const {
    const char* from = file_.bytes.data.get() + position;
    return file_.swapped ? load<T, true>(from) : load<T, false>(from);
  }

  void read_header() {
    if (file_.bytes.size < header_bytes) file_.fail("too short for a binary Gamma Mesh Format file");
    file_.swapped = value_at<std::int32_t>(0) != 1;
    if (value_at<std::int32_t>(0) != 1) file_.fail("not a binary Gamma Mesh Format file: it does not begin with 1");
    file_.version = value_at<std::int32_t>(4);
    if (file_.version < 1 || file_.version > 4) {
      file_.fail(fmt::format("version {} found, expected 1..4", file_.version));
    }
  }

  /// Returns the position of the next keyword, 0 if there is none.
  std::size_t read_keyword(std::size_t position) {
    // Some writers leave out the keyword End.
    if (position == file_.bytes.size) return 0;
    const std::size_t behind_code = position + sizeof(std::int32_t);
    if (behind_code > file_.bytes.size) fail_truncated(position);
    const auto code = value_at<std::int32_t>(position);
    // Old versions of mmg write no position behind it.
    if (code == static_cast<std::int32_t>(Code::end)) return 0;
    const std::size_t begin = behind_code + position_bytes(file_.version);
    if (begin > file_.bytes.size) fail_truncated(position);
    const std::size_t next = next_position(position, begin);
    if (const Keyword* keyword = find_keyword(code)) {
      file_.add({keyword->code, begin, next == 0 ? file_.bytes.size : next});
    }
    return next;
  }

  [[nodiscard]] std::size_t next_position(std::size_t position, std::size_t begin) const {
    const std::size_t at = position + sizeof(std::int32_t);
    const std::int64_t next = file_.version >= 3 ? value_at<std::int64_t>(at) : value_at<std::int32_t>(at);
    const auto size = static_cast<std::int64_t>(file_.bytes.size);
    // Positions must grow, or a damaged file would lead round in circles.
    if (next != 0 && (next < static_cast<std::int64_t>(begin) || next > size)) {
      file_.fail_at(position, fmt::format("next keyword at {} found, expected 0 or {}..{}", next, begin, size));
    }
    return static_cast<std::size_t>(next);
  }

  [[noreturn]] void fail_truncated(std::size_t position) const {
    file_.fail_at(position, "keyword expected, the file is truncated");
  }

  GmfFile& file_;
};

}  // namespace

void index_binary(GmfFile& file) {
  Indexer(file).run();
}

}  // namespace taut::gmf
