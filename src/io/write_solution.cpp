#include <fmt/format.h>

#include "io/fields.hpp"
#include "io/sinks.hpp"

namespace taut::gmf {
namespace {

/// Throws InputError unless all fields have the same number of vertices, which is returned.
std::size_t vertices_of(const std::vector<Field>& fields) {
  if (fields.empty()) throw InputError("solution: at least one field expected, none found");
  const std::size_t count = fields.front().values.size() / fields.front().size();
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (fields[i].values.size() != count * fields[i].size()) {
      throw InputError(fmt::format("solution: field {}: {} values found, expected {} for each of {} vertices", i,
                                   fields[i].values.size(), fields[i].size(), count));
    }
  }
  return count;
}

/// The numbers between the count and the values: how many fields, and the kind of each.
std::vector<int> header_of(const std::vector<Field>& fields) {
  std::vector<int> header{static_cast<int>(fields.size())};
  for (const Field& field : fields) header.push_back(static_cast<int>(field.kind));
  return header;
}

template <class Sink>
void write_values(Sink& out, std::size_t count, const std::vector<Field>& fields) {
  for (std::size_t i = 0; i < count; ++i) {
    for (const Field& field : fields) {
      const double* values = &field.values[i * field.size()];
      for (const std::size_t place : places(field)) out.real(values[place]);
    }
    out.end_row();
  }
}

template <class Sink>
void write_block(Sink&& out, std::size_t count, Row row, const std::vector<Field>& fields) {
  out.begin(Code::solution, count, row, header_of(fields));
  write_values(out, count, fields);
  out.finish();
}

}  // namespace
}  // namespace taut::gmf

namespace taut {

void write_solution(const std::filesystem::path& path, const std::vector<Field>& fields) {
  const gmf::Encoding encoding = gmf::encoding_of(path, ".sol", ".solb");
  const std::size_t count = gmf::vertices_of(fields);
  const gmf::Row row{.reals = gmf::values_of_a_vertex(fields), .integers = 0};
  gmf::AtomicFile file(path);
  if (encoding == gmf::Encoding::text) {
    gmf::write_block(gmf::TextSink(file), count, row, fields);
  } else {
    const int version = gmf::version_for(gmf::BinarySink::block_bytes(2, count, row, 1 + fields.size()));
    gmf::write_block(gmf::BinarySink(file, version), count, row, fields);
  }
  file.commit();
}

}  // namespace taut
