#include "solution/checkpoint.hpp"

#include <fmt/format.h>

#include <fstream>
#include <limits>

#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut {
namespace {

constexpr const char* summary_name = "progress.txt";
constexpr const char* title = "taut-unsteady-1";

Field tensor_field(const Tensors& tensors) {
  Field field{.kind = Field::Kind::tensor, .values = {}};
  for (const Tensor& t : tensors) field.values.insert(field.values.end(), t.begin(), t.end());
  return field;
}

Tensors tensors_in(const std::filesystem::path& path) {
  const std::vector<Field> fields = read_solution(path);
  if (fields.size() != 1 || fields[0].kind != Field::Kind::tensor)
    throw InputError(fmt::format("{}: expected one tensor field", path.string()));
  Tensors tensors(fields[0].values.size() / 6);
  for (std::size_t v = 0; v < tensors.size(); ++v)
    std::copy_n(fields[0].values.begin() + static_cast<std::ptrdiff_t>(6 * v), 6, tensors[v].begin());
  return tensors;
}

}  // namespace

std::filesystem::path Checkpoint::file(const char* what, std::size_t iteration, std::size_t interval,
                                       const char* extension) const {
  return folder_ / fmt::format("{}-{}-{}{}", what, iteration, interval, extension);
}

bool Checkpoint::exists() const {
  return !folder_.empty() && std::filesystem::exists(folder_ / summary_name);
}

UnsteadyProgress Checkpoint::read(std::size_t intervals) const {
  const auto path = folder_ / summary_name;
  std::ifstream in(path);
  std::string found;
  UnsteadyProgress progress;
  std::size_t count = 0, done = 0;
  in >> found >> progress.iteration >> count >> done;
  if (!in || found != title || done > count)
    throw InputError(fmt::format("{}: not a checkpoint of taut", path.string()));
  if (count != intervals)
    throw InputError(fmt::format("{}: {} sub-intervals found, expected {}", path.string(), count, intervals));
  for (std::size_t i = 0; i < count; ++i)
    progress.meshes.push_back(std::make_shared<const Mesh>(read_mesh(file("mesh", progress.iteration, i, ".meshb"))));
  for (std::size_t i = 0; i < done; ++i) {
    SubInterval interval{.mesh = progress.meshes[i].get(),
                         .hessian = tensors_in(file("hessian", progress.iteration, i, ".solb"))};
    in >> interval.steps >> interval.duration;
    progress.done.push_back(std::move(interval));
  }
  if (!in) throw InputError(fmt::format("{}: ends too early", path.string()));
  if (done > 0) progress.state = read_solution(file("state", progress.iteration, done - 1, ".solb"));
  return progress;
}

void Checkpoint::write_meshes(const UnsteadyProgress& progress) const {
  if (folder_.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) throw Failure(fmt::format("{}: cannot be created: {}", folder_.string(), error.message()));
  for (std::size_t i = 0; i < progress.meshes.size(); ++i)
    write_mesh(file("mesh", progress.iteration, i, ".meshb"), *progress.meshes[i]);
  write_summary(progress);
}

void Checkpoint::write_last(const UnsteadyProgress& progress) const {
  if (folder_.empty()) return;
  const std::size_t last = progress.done.size() - 1;
  write_solution(file("hessian", progress.iteration, last, ".solb"), {tensor_field(progress.done[last].hessian)});
  write_solution(file("state", progress.iteration, last, ".solb"), progress.state);
  write_summary(progress);
}

void Checkpoint::write_summary(const UnsteadyProgress& progress) const {
  const auto path = folder_ / summary_name, temporary = folder_ / "progress.tmp";
  std::ofstream out(temporary);
  out.precision(std::numeric_limits<double>::max_digits10);
  out << title << '\n' << progress.iteration << ' ' << progress.meshes.size() << ' ' << progress.done.size() << '\n';
  for (const SubInterval& interval : progress.done) out << interval.steps << ' ' << interval.duration << '\n';
  out.close();
  std::error_code error;
  if (out) std::filesystem::rename(temporary, path, error);
  if (!out || error) throw Failure(fmt::format("{}: cannot be written", path.string()));
}

}  // namespace taut
