#include "io/cursor.hpp"

#include <fmt/format.h>

#include "taut/mesh.hpp"

namespace taut::gmf {

void Cursor::fail(std::string_view message) const {
  const std::string place = row_ == none ? std::string(name_of(code_)) : fmt::format("{} {}", name_of(code_), row_ + 1);
  const std::string text = fmt::format("{}: {}", place, message);
  if (file_->encoding == Encoding::binary) file_->fail(text);
  file_->fail_at(static_cast<std::size_t>(at_ - file_->bytes.data.get()), text);
}

void Cursor::fail_short(std::size_t entries) const {
  fail(fmt::format("{} entries announced, but only {} bytes follow", entries, left()));
}

std::size_t Cursor::checked_count(std::int64_t found, std::size_t before) const {
  const std::int64_t most = std::int64_t{std::numeric_limits<Index>::max()} - 1 - static_cast<std::int64_t>(before);
  if (found < 0 || found > most) fail(fmt::format("{} entries announced, expected 0..{}", found, most));
  return static_cast<std::size_t>(found);
}

}  // namespace taut::gmf
