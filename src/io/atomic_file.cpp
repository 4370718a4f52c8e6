#include "io/atomic_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <random>
#include <system_error>

#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut::gmf {

namespace {

constexpr std::size_t buffer_bytes = std::size_t{1} << 20;

std::filesystem::path temporary_beside(const std::filesystem::path& path) {
  std::filesystem::path name(".");
  name += path.filename();
  name += fmt::format(".{:08x}.tmp", std::random_device{}());
  return path.parent_path() / name;
}

}  // namespace

AtomicFile::AtomicFile(const std::filesystem::path& path) : path_(path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) fail("it is a directory");
  if (!path.has_filename()) fail("no file name given");
  buffer_.resize(buffer_bytes);
  temporary_ = temporary_beside(path);
  // 'x': another writer's temporary file is never taken over.
  file_ = std::fopen(temporary_.string().c_str(), "wbx");
  if (file_ == nullptr) fail(std::strerror(errno));
  // This buffer takes the place of the stream's.
  std::setvbuf(file_, nullptr, _IONBF, 0);
}

AtomicFile::~AtomicFile() {
  if (file_ != nullptr) std::fclose(file_);
  std::error_code ignored;
  if (!temporary_.empty()) std::filesystem::remove(temporary_, ignored);
}

void AtomicFile::commit() {
  flush();
  const bool closed = std::fclose(file_) == 0;
  file_ = nullptr;
  // Some file systems tell only now that there is no space.
  if (!closed) fail(std::strerror(errno));
  std::error_code error;
  std::filesystem::rename(temporary_, path_, error);
  if (error) fail(error.message().c_str());
  temporary_.clear();
}

void AtomicFile::flush() {
  if (std::fwrite(buffer_.data(), 1, used_, file_) != used_) fail(std::strerror(errno));
  used_ = 0;
}

void AtomicFile::fail(const char* why) const {
  throw Failure(fmt::format("{}: cannot be written: {}", path_.string(), why));
}

}  // namespace taut::gmf

namespace taut {

void require_writable(const std::filesystem::path& path) {
  const gmf::AtomicFile probe(path);
}

}  // namespace taut
