#include "solution/checkpoint.hpp"

#include <fmt/format.h>

#include <fstream>
#include <limits>
#include <locale>
#include <system_error>

#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut {
namespace {

constexpr const char* summary_name = "progress.txt";
constexpr const char* title = "taut-unsteady-1";

/// The small file that says which of the others count.
struct Summary {
  std::size_t iteration = 0;
  std::vector<double> times;
  std::vector<std::array<double, 2>> done;  ///< steps and duration of each sub-interval that has been computed
};

/// As many rows of numbers as the file says, or fewer if it ends early.
template <class Row, class Read>
std::vector<Row> rows_in(std::istream& in, Read read) {
  std::size_t count = 0;
  in >> count;
  std::vector<Row> rows;
  for (Row row{}; rows.size() < count && read(row);) rows.push_back(row);
  return rows;
}

Summary read_summary(const std::filesystem::path& path) {
  std::ifstream in(path);
  in.imbue(std::locale::classic());
  std::string found;
  Summary summary;
  in >> found >> summary.iteration;
  summary.times = rows_in<double>(in, [&](double& time) -> bool { return !!(in >> time); });
  summary.done = rows_in<std::array<double, 2>>(in, [&](auto& row) -> bool { return !!(in >> row[0] >> row[1]); });
  if (!in || found != title || summary.done.size() >= summary.times.size())
    throw InputError(fmt::format("{}: damaged, or not a checkpoint of taut", path.string()));
  return summary;
}

std::vector<Field> fields_in(const std::filesystem::path& path, std::size_t points) {
  std::vector<Field> fields = read_solution(path);
  for (const Field& field : fields)
    if (field.values.size() != points * field.size())
      throw InputError(fmt::format("{}: values for {} vertices found, expected {}: the run had another mesh",
                                   path.string(), field.values.size() / field.size(), points));
  return fields;
}

Tensors tensors_in(const std::filesystem::path& path, std::size_t points) {
  const std::vector<Field> fields = fields_in(path, points);
  if (fields.size() != 1 || fields[0].kind != Field::Kind::tensor)
    throw InputError(fmt::format("{}: expected one tensor field", path.string()));
  return tensors_of(fields[0]);
}

}  // namespace

std::filesystem::path Checkpoint::file(const char* what, std::size_t iteration, std::size_t interval,
                                       const char* extension) const {
  return folder_ / fmt::format("{}-{}-{}{}", what, iteration, interval, extension);
}

bool Checkpoint::exists() const {
  return !folder_.empty() && std::filesystem::exists(folder_ / summary_name);
}

UnsteadyProgress Checkpoint::read(const std::shared_ptr<const Mesh>& mesh) const {
  const auto path = folder_ / summary_name;
  const Summary summary = read_summary(path);
  if (summary.times != times_)
    throw InputError(fmt::format("{}: a run over other times found, expected the same", path.string()));
  UnsteadyProgress progress{.iteration = summary.iteration, .meshes = {}, .done = {}, .state = {}};
  // Only the first iteration has one mesh for all: it must stay one, because the state is not transferred to itself.
  for (std::size_t i = 0; i + 1 < times_.size(); ++i)
    progress.meshes.push_back(
        summary.iteration == 0 ? mesh
                               : std::make_shared<const Mesh>(read_mesh(file("mesh", summary.iteration, i, ".meshb"))));
  for (const auto& [steps, duration] : summary.done) {
    const std::size_t i = progress.done.size();
    const Mesh& its_mesh = *progress.meshes[i];
    progress.done.push_back(
        {.mesh = &its_mesh,
         .hessian = tensors_in(file("hessian", summary.iteration, i, ".solb"), its_mesh.points.size()),
         .steps = steps,
         .duration = duration});
  }
  if (progress.done.empty()) return progress;
  const std::size_t last = progress.done.size() - 1;
  progress.state = fields_in(file("state", summary.iteration, last, ".solb"), progress.meshes[last]->points.size());
  return progress;
}

void Checkpoint::write_meshes(const UnsteadyProgress& progress) const {
  if (folder_.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) throw Failure(fmt::format("{}: cannot be created: {}", folder_.string(), error.message()));
  for (std::size_t i = 0; i < progress.meshes.size() && progress.iteration > 0; ++i)
    write_mesh(file("mesh", progress.iteration, i, ".meshb"), *progress.meshes[i]);
  write_summary(progress);
}

void Checkpoint::write_last(const UnsteadyProgress& progress) const {
  if (folder_.empty()) return;
  const std::size_t last = progress.done.size() - 1;
  write_solution(file("hessian", progress.iteration, last, ".solb"), {field_of(progress.done[last].hessian)});
  write_solution(file("state", progress.iteration, last, ".solb"), progress.state);
  write_summary(progress);
}

void Checkpoint::write_summary(const UnsteadyProgress& progress) const {
  const auto path = folder_ / summary_name, temporary = folder_ / "progress.tmp";
  std::ofstream out(temporary);
  out.imbue(std::locale::classic());
  out.precision(std::numeric_limits<double>::max_digits10);
  out << title << '\n' << progress.iteration << '\n' << times_.size() << '\n';
  for (const double time : times_) out << time << '\n';
  out << progress.done.size() << '\n';
  for (const SubInterval& interval : progress.done) out << interval.steps << ' ' << interval.duration << '\n';
  out.close();
  std::error_code error;
  if (out) std::filesystem::rename(temporary, path, error);
  if (!out || error) throw Failure(fmt::format("{}: cannot be written", path.string()));
}

}  // namespace taut
