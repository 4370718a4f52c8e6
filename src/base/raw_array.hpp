// An array without initial values.
#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>

namespace taut {

/// An array of fixed length whose values are not set, so that the threads that fill it also share the cost of first
/// touching its memory.
template <class T>
class RawArray {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

public:
  explicit RawArray(std::size_t size) : size_(size), values_(std::allocator<T>().allocate(size), Free{size}) {}

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] T* data() { return values_.get(); }
  [[nodiscard]] const T* data() const { return values_.get(); }
  T& operator[](std::size_t i) { return values_.get()[i]; }

private:
  struct Free {
    std::size_t size;
    void operator()(T* values) const { std::allocator<T>().deallocate(values, size); }
  };
  std::size_t size_;
  std::unique_ptr<T, Free> values_;
};

}  // namespace taut
