// A file that appears under its name only when it is complete.
#pragma once

#include <cstdio>
#include <filesystem>
#include <string_view>
#include <vector>

namespace taut::gmf {

/// Writes to a temporary file in the directory of `path`; commit() renames it. Without commit() nothing is left, and a
/// file that was there stays as it was. Every failure throws Failure.
class AtomicFile {
public:
  explicit AtomicFile(const std::filesystem::path& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Room for `bytes` (few) more; what is written there counts once advance() was called with its end.
  [[nodiscard]] char* room(std::size_t bytes) {
    if (buffer_.size() - used_ < bytes) flush();
    return buffer_.data() + used_;
  }
  void advance(const char* end) { used_ = static_cast<std::size_t>(end - buffer_.data()); }

  void commit();

private:
  void flush();
  [[noreturn]] void fail(const char* why) const;

  std::filesystem::path path_, temporary_;
  std::FILE* file_ = nullptr;
  std::vector<char> buffer_;
  std::size_t used_ = 0;
};

}  // namespace taut::gmf
