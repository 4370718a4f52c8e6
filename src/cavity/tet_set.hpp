// The tetrahedra of a cavity, in the order in which they were collected.
#pragma once

#include <array>
#include <span>

#include "cavity/small_map.hpp"
#include "mesh/tet_mesh.hpp"

namespace taut {

class TetSet {
public:
  static constexpr int capacity = 120;

  void clear() {
    size_ = 0;
    index_.clear();
  }
  /// False if there is no room: no valid cavity is that large.
  [[nodiscard]] bool add(TetId t) {
    if (size_ == capacity) return false;
    index_.find_or_insert(t, size_);
    tets_[size_++] = t;
    return true;
  }
  /// What there is room for of `tets`: always all of a shell.
  void assign(std::span<const TetId> tets) {
    clear();
    for (TetId t : tets) (void)add(t);
  }
  [[nodiscard]] bool contains(TetId t) const { return index_.contains(t); }
  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] TetId operator[](int i) const { return tets_[i]; }
  [[nodiscard]] std::span<const TetId> span() const { return {tets_.data(), static_cast<std::size_t>(size_)}; }

  /// Keeps the first `size` tetrahedra and those of the rest for which `keep` holds.
  template <class Keep>
  void shrink(int size, Keep keep) {
    index_.clear();
    const int old_size = size_;
    size_ = 0;
    for (int i = 0; i < old_size; ++i)
      if (i < size || keep(i)) (void)add(tets_[i]);
  }

private:
  int size_ = 0;
  std::array<TetId, capacity> tets_{};
  SmallMap<256> index_;
};

}  // namespace taut
