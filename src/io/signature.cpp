#include "io/signature.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

namespace taut::gmf {
namespace {

using namespace std::string_view_literals;

struct Signature {
  std::string_view bytes, format;
};

constexpr auto others = std::to_array<Signature>({
    {"\x1f\x8b"sv, "a file compressed by gzip"},
    {"BZh"sv, "a file compressed by bzip2"},
    {"\xfd"
     "7zXZ"sv,
     "a file compressed by xz"},
    {"\x28\xb5\x2f\xfd"sv, "a file compressed by zstd"},
    {"PK\x03\x04"sv, "a zip archive"},
    {"\xff\xfe"sv, "text in UTF-16"},
    {"\xfe\xff"sv, "text in UTF-16"},
    {"$MeshFormat"sv, "a mesh in gmsh's own format"},
    {"# vtk DataFile"sv, "a VTK file"},
    {"<?xml"sv, "an XML file"},
    {"<VTKFile"sv, "a VTK file"},
    {"\x89HDF"sv, "an HDF5 file"},
    {"MFEM "sv, "a mesh in MFEM's own format"},
});

}  // namespace

void read_signature(GmfFile& file) {
  const std::string_view content(file.bytes.data.get(), file.bytes.size);
  if (content.empty()) file.fail("the file is empty");
  for (const Signature& other : others) {
    if (!content.starts_with(other.bytes)) continue;
    file.fail(fmt::format("{} found, expected a mesh or solution in Gamma Mesh Format (Medit)", other.format));
  }
  // Binary files begin with a 1 in either byte order, text files with a printable character or a blank.
  file.encoding = content.front() == 0 || content.front() == 1 ? Encoding::binary : Encoding::text;
}

}  // namespace taut::gmf
