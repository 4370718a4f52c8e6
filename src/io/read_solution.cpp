#include <fmt/format.h>

#include "io/fields.hpp"
#include "io/open_block.hpp"

namespace taut::gmf {
namespace {

/// The header of the block: how many fields, and the kind of each.
template <class In>
std::vector<Field> read_kinds(In& in) {
  const std::int64_t fields = in.word();
  if (fields < 1) in.fail(fmt::format("{} fields found, expected at least one", fields));
  std::vector<Field> result;
  for (std::int64_t i = 0; i < fields; ++i) {
    const std::int64_t kind = in.word();
    if (kind < 1 || kind > 3) {
      in.fail(fmt::format("kind {} of field {} found, expected 1 (scalar), 2 (vector) or 3 (tensor)", kind, i + 1));
    }
    result.push_back({.kind = static_cast<Field::Kind>(kind), .values = {}});
  }
  return result;
}

template <class In>
void read_values(In& in, std::size_t count, Row row, std::vector<Field>& fields) {
  for (Field& field : fields) field.values.resize(count * field.size());
  for_each_row(in, 0, count, row, [&](In& from, std::size_t i) {
    for (Field& field : fields) {
      double* values = &field.values[i * field.size()];
      for (const std::size_t place : places(field)) values[place] = finite(from);
    }
  });
}

Metric metric_of(Field&& field, const GmfFile& file) {
  if (field.kind == Field::Kind::scalar) return Sizes(std::move(field.values));
  if (field.kind == Field::Kind::vector) {
    file.fail("a vector field found, a metric is one scalar or one tensor field");
  }
  return tensors_of(field);
}

}  // namespace

std::vector<Field> read_fields(const GmfFile& file) {
  require_three_dimensions(file);
  std::vector<Field> fields;
  read_block(file, file.require(Code::solution), [&](auto& in) {
    const std::size_t count = in.count(0);
    fields = read_kinds(in);
    const Row row{.reals = values_of_a_vertex(fields), .integers = 0};
    in.expect(count, row);
    read_values(in, count, row, fields);
  });
  return fields;
}

Metric read_metric(const GmfFile& file) {
  std::vector<Field> fields = read_fields(file);
  if (fields.size() != 1) {
    file.fail(fmt::format("{} fields found, a metric is one scalar or one tensor field", fields.size()));
  }
  return metric_of(std::move(fields.front()), file);
}

}  // namespace taut::gmf

namespace taut {
namespace {

gmf::GmfFile open_solution(const std::filesystem::path& path) {
  return gmf::open(path, ".sol", ".solb");
}

}  // namespace

std::vector<Field> read_solution(const std::filesystem::path& path) {
  return gmf::read_fields(open_solution(path));
}

Metric read_metric(const std::filesystem::path& path) {
  return gmf::read_metric(open_solution(path));
}

}  // namespace taut
