// Arrays of a VTK file in XML: a line in the head, and raw numbers appended behind it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "io/atomic_file.hpp"

namespace taut::vtu {

/// Numbers in the byte order of this machine, which the head of the file names.
class RawSink {
public:
  explicit RawSink(gmf::AtomicFile& file) : file_(file) {}

  template <class T>
  void put(T value) {
    char* at = file_.room(sizeof(T));
    std::memcpy(at, &value, sizeof(T));
    file_.advance(at + sizeof(T));
  }
  void text(std::string_view text);

private:
  gmf::AtomicFile& file_;
};

/// What a file says about an array, and how its numbers are written.
struct Array {
  std::string name;
  const char* type;                     ///< VTK's word for the numbers
  std::size_t components;               ///< numbers per row
  std::size_t bytes;                    ///< of all numbers
  std::function<void(RawSink&)> write;  ///< puts as many
};

/// VTK's word for a type of numbers.
template <class T>
constexpr const char* type_name = nullptr;
template <>
inline constexpr const char* type_name<double> = "Float64";
template <>
inline constexpr const char* type_name<std::int32_t> = "Int32";
template <>
inline constexpr const char* type_name<std::int64_t> = "Int64";
template <>
inline constexpr const char* type_name<std::uint8_t> = "UInt8";

template <class T>
Array array_of(std::string name, std::size_t rows, std::size_t components, std::function<void(RawSink&)> write) {
  return {std::move(name), type_name<T>, components, rows * components * sizeof(T), std::move(write)};
}

/// An element of the head that holds arrays, such as PointData.
struct Section {
  std::string_view tag;
  std::vector<Array> arrays;
};

/// The text as the value of an attribute in XML.
[[nodiscard]] std::string escaped(std::string_view text);

/// The line that begins a VTK file in XML of the given type and holds the byte order.
[[nodiscard]] std::string opening(std::string_view type);

/// The lines of the sections. Each array is found at the sum of what those before it take, their counts of bytes
/// included.
[[nodiscard]] std::string head_of(const std::vector<Section>& sections);

/// The arrays in the same order, each behind its number of bytes.
void write_appended(RawSink& out, const std::vector<Section>& sections);

}  // namespace taut::vtu
