#include "progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace taut::program {
namespace {

constexpr const char* wiped = "\r\x1b[K";  // to the start of the line, then erased

}  // namespace

ProgressLine::ProgressLine(bool quiet) : shown_(!quiet && isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
  if (shown_) std::fputs(wiped, stderr);
}

void ProgressLine::show(const Progress& progress) {
  if (!shown_) return;
  fmt::print(stderr, "{}round {}: {} did {}, {} vertices, {} tetrahedra", wiped, progress.round + 1, progress.pass,
             progress.accepted, progress.vertices, progress.tetrahedra);
  std::fflush(stderr);
}

void ProgressLine::show_expected(double tetrahedra) {
  if (!shown_) return;
  fmt::print(stderr, "{}about {:.3g} tetrahedra expected", wiped, tetrahedra);
  std::fflush(stderr);
}

void ProgressLine::show_step(std::size_t step, std::size_t steps, const Quality& quality) {
  if (!shown_) return;
  fmt::print(stderr, "{}step {} of {}: {} vertices, worst Q {:.3g}", wiped, step, steps, quality.vertices,
             quality.Q_max);
  std::fflush(stderr);
}

}  // namespace taut::program
