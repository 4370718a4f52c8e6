// Ids of vertices, tetrahedra or triangles that one worker may use.
#pragma once

#include <cassert>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace taut {

/// Ids that a block holds. The first `size()` ids are those that it has used so far, dead or alive, in a fixed order;
/// the others have never been used. Ids that become free are used again first.
template <class Id>
class IdPool {
public:
  IdPool() = default;
  /// All of `ids`; the first `used` of them are in use.
  IdPool(std::vector<Id> ids, std::size_t used) : ids_(std::move(ids)), used_(used) {}

  [[nodiscard]] std::size_t size() const { return used_; }
  [[nodiscard]] Id operator[](std::size_t i) const { return ids_[i]; }
  [[nodiscard]] std::size_t available() const { return recycled_.size() + (ids_.size() - used_); }

  /// What take() will return.
  [[nodiscard]] Id next() const { return recycled_.empty() ? ids_[used_] : recycled_.back(); }
  Id take() {
    assert(available() > 0);
    const Id id = next();
    if (recycled_.empty())
      ++used_;
    else
      recycled_.pop_back();
    return id;
  }
  void recycle(Id id) { recycled_.push_back(id); }

  /// The ids that were granted and never used.
  [[nodiscard]] std::span<const Id> unused() const { return std::span(ids_).subspan(used_); }

  /// More, not yet used.
  void add(std::span<const Id> more) { ids_.insert(ids_.end(), more.begin(), more.end()); }

  /// Gives away what is not in use.
  [[nodiscard]] std::vector<Id> release() {
    std::vector<Id> released = std::move(recycled_);
    released.insert(released.end(), unused().begin(), unused().end());
    recycled_.clear();
    ids_.resize(used_);
    return released;
  }

private:
  std::vector<Id> ids_, recycled_;
  std::size_t used_ = 0;
};

}  // namespace taut
