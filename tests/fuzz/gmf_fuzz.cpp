// libFuzzer: any bytes, read as a mesh and as a solution. What is read must keep the promises of taut/io.hpp.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "io/fields.hpp"
#include "io/gmf_file.hpp"
#include "io/mesh_blocks.hpp"
#include "io/read_mesh.hpp"

namespace {

using taut::Index;
using taut::gmf::Code;

void promise(bool kept) {
  if (!kept) std::abort();
}

template <class Points, class Refs>
void check(const taut::gmf::PointRows<Points, Refs>& rows) {
  promise(rows.refs.size() == rows.size());
  for (const taut::Point& point : rows.points) {
    promise(std::all_of(point.begin(), point.end(), [](double x) { return std::isfinite(x); }));
  }
}

template <class Elements, class Refs>
void check(const taut::gmf::ElementRows<Elements, Refs>& rows) {
  promise(rows.refs.size() == rows.size());
  for (const auto& element : rows.elements) {
    promise(std::all_of(element.begin(), element.end(), [&](Index i) { return i < rows.limit; }));
  }
}

template <class Indices>
void check(const taut::gmf::IndexRows<Indices>& rows) {
  promise(std::all_of(rows.indices.begin(), rows.indices.end(), [&](Index i) { return i < rows.limit; }));
}

void read_as_mesh(const taut::gmf::GmfFile& file) {
  const taut::Mesh mesh = taut::gmf::read_mesh(file);
  taut::gmf::for_each_block(mesh, [](Code, const auto& rows) { check(rows); });
}

void read_as_solution(const taut::gmf::GmfFile& file) {
  for (const taut::Field& field : taut::gmf::read_fields(file)) {
    promise(field.values.size() % field.size() == 0);
    promise(std::all_of(field.values.begin(), field.values.end(), [](double x) { return std::isfinite(x); }));
  }
}

template <class Call>
void run(Call call) {
  try {
    call();
  } catch (const taut::InputError&) {
    // The only exception that a reader may throw.
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string_view content(reinterpret_cast<const char*>(data), size);
  run([&] {
    const taut::gmf::GmfFile file = taut::gmf::parse("fuzz", taut::gmf::copy_of(content));
    run([&] { read_as_mesh(file); });
    run([&] { read_as_solution(file); });
  });
  return 0;
}
