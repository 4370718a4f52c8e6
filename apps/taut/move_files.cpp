#include "move_files.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <map>
#include <string_view>

#include "files.hpp"

namespace taut::program {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 1> pvd_files = {".pvd"};

std::optional<StepNames> names_if_any(const std::string& pattern) {
  return pattern.empty() ? std::nullopt : std::optional<StepNames>(pattern);
}

bool is_vtu(const std::string& file) {
  return fs::path(file).extension() == ".vtu";
}

/// `run/out.pvd` for `run/out-%04d.vtu`.
std::string pvd_for(const std::string& pattern) {
  const fs::path path = pattern;
  std::string name = path.filename().string();
  name = name.substr(0, name.find('%'));
  name = name.substr(0, name.find_last_not_of("-_.") + 1);
  return (path.parent_path() / ((name.empty() ? "out" : name) + ".pvd")).string();
}

std::string pvd_of(const MoveJob& job) {
  if (is_vtu(job.output)) return job.pvd.empty() ? pvd_for(job.output) : job.pvd;
  if (!job.pvd.empty()) throw InputError(fmt::format("--pvd: {} found, expected .vtu files as the output", job.output));
  return "";
}

/// Names of files and what each is for; none may come twice, except among those that are read.
class NamesInUse {
public:
  void add_input(const std::string& file, std::string_view what) {
    if (file.empty()) return;
    used_.try_emplace(place(file), what);
    used_.try_emplace(fs::weakly_canonical(file), what);  // where links lead
  }
  void add_output(const std::string& file, std::string_view what) {
    if (file.empty()) return;
    const auto [other, is_new] = used_.try_emplace(place(file), what);
    if (!is_new)
      throw InputError(
          fmt::format("{}: found as a file for the {} and for the {}, expected two files", file, other->second, what));
  }

private:
  // A link would be replaced, not what it leads to.
  fs::path place(const std::string& file) {
    const fs::path path = fs::absolute(file);
    const auto [folder, is_new] = folders_.try_emplace(path.parent_path());
    if (is_new) folder->second = fs::weakly_canonical(path.parent_path());
    return folder->second / path.filename();
  }

  std::map<fs::path, std::string_view> used_;
  std::map<fs::path, fs::path> folders_;
};

NamesInUse inputs_of(const MoveJob& job, std::span<const std::string> displacements) {
  NamesInUse names;
  names.add_input(job.input, "input mesh");
  names.add_input(job.motion, "motion");
  names.add_input(job.metric, "input metric");
  names.add_input(job.geometry, "geometry");
  for (const std::string& file : job.fields) names.add_input(file, "input fields");
  for (const std::string& file : displacements) names.add_input(file, "displacements");
  return names;
}

}  // namespace

MoveFiles::MoveFiles(const MoveJob& job, std::span<const std::string> displacements)
    : meshes_(job.output),
      fields_(names_if_any(job.fields_out)),
      metrics_(names_if_any(job.metric_out)),
      pvd_(pvd_of(job)),
      steps_(static_cast<std::size_t>(job.steps)),
      every_(static_cast<std::size_t>(job.every)) {
  require_output(meshes_(0), mesh_outputs);
  if (fields_) require_output((*fields_)(0), solution_files);
  if (metrics_) require_output((*metrics_)(0), solution_files);
  require_output(pvd_, pvd_files);
  require_output(job.report, report_files);

  NamesInUse names = inputs_of(job, displacements);
  names.add_output(job.report, "report");
  for (std::size_t step = 0; step <= steps_; ++step) {  // a body may be stopped in each
    names.add_output(meshes_(step), "meshes");
    if (fields_) names.add_output((*fields_)(step), "fields");
    if (metrics_) names.add_output((*metrics_)(step), "metric");
  }
}

bool MoveFiles::wants(std::size_t step) const {
  return step % every_ == 0 || step == steps_;
}

void MoveFiles::write(const MovingMesh& mesh, std::size_t step) {
  if (fields_) write_solution((*fields_)(step), mesh.fields());
  if (metrics_) write_solution((*metrics_)(step), {field_of(mesh.metric())});
  write_output(meshes_(step), mesh.mesh(), mesh.fields(), mesh.metric());
  if (pvd_.empty()) return;
  const fs::path folder = fs::absolute(pvd_).parent_path();
  written_.push_back({static_cast<double>(step), fs::relative(meshes_(step), folder).generic_string()});
  write_pvd(pvd_, written_);
}

}  // namespace taut::program
