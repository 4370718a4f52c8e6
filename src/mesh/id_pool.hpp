// Ids of vertices, tetrahedra or triangles that one worker may use.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace taut {

/// Ids that a block holds. The first `size()` are those it has used so far, dead or alive, in a fixed order; the rest
/// wait for their first use. Ids that fall free are used again first.
class IdPool {
public:
  IdPool() = default;
  /// All of `ids`, the first `used` of which are in use.
  IdPool(std::vector<std::uint32_t> ids, std::size_t used) : ids_(std::move(ids)), used_(used) {}

  [[nodiscard]] std::size_t size() const { return used_; }
  [[nodiscard]] std::uint32_t operator[](std::size_t i) const { return ids_[i]; }
  [[nodiscard]] std::size_t available() const { return recycled_.size() + (ids_.size() - used_); }

  /// What take() will return.
  [[nodiscard]] std::uint32_t next() const { return recycled_.empty() ? ids_[used_] : recycled_.back(); }
  std::uint32_t take() {
    assert(available() > 0);
    const std::uint32_t id = next();
    if (recycled_.empty())
      ++used_;
    else
      recycled_.pop_back();
    return id;
  }
  void recycle(std::uint32_t id) { recycled_.push_back(id); }

  /// Those granted and never used.
  [[nodiscard]] std::span<const std::uint32_t> unused() const { return std::span(ids_).subspan(used_); }

  /// One more, not yet used.
  void add(std::uint32_t id) { ids_.push_back(id); }

  /// Moves what is not in use to `free`.
  void return_to(std::vector<std::uint32_t>& free) {
    free.insert(free.end(), recycled_.begin(), recycled_.end());
    free.insert(free.end(), ids_.begin() + static_cast<std::ptrdiff_t>(used_), ids_.end());
    recycled_.clear();
    ids_.resize(used_);
  }

private:
  std::vector<std::uint32_t> ids_, recycled_;
  std::size_t used_ = 0;
};

}  // namespace taut
