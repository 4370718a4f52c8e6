#include "io/vtu_array.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace taut::vtu {

void RawSink::text(std::string_view text) {
  constexpr std::size_t most = 4096;  // far below what there can be room for
  for (; !text.empty(); text.remove_prefix(std::min(most, text.size()))) {
    const std::string_view part = text.substr(0, most);
    file_.advance(std::copy(part.begin(), part.end(), file_.room(part.size())));
  }
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string opening(std::string_view type) {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"{}\" version=\"1.0\" byte_order=\"{}\" header_type=\"UInt64\">\n", type,
      std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian");
}

std::string head_of(const std::vector<Section>& sections) {
  std::string head;
  std::size_t offset = 0;
  for (const auto& [tag, arrays] : sections) {
    head += fmt::format("      <{}>\n", tag);
    for (const Array& array : arrays) {
      head += fmt::format(
          "        <DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n",
          array.type, escaped(array.name), array.components, offset);
      offset += sizeof(std::uint64_t) + array.bytes;
    }
    head += fmt::format("      </{}>\n", tag);
  }
  return head;
}

void write_appended(RawSink& out, const std::vector<Section>& sections) {
  for (const Section& section : sections) {
    for (const Array& array : section.arrays) {
      out.put(std::uint64_t{array.bytes});
      array.write(out);
    }
  }
}

}  // namespace taut::vtu
