// Runs that are interrupted and go on from a folder.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/with_threads.hpp"
#include "solution/moving_front.hpp"

namespace taut {
namespace {

using test::advance_front;
using test::state_at_zero;

struct Interruption {};

/// A solver that fails once.
class FailingSolver {
public:
  FailingSolver(std::size_t iteration, std::size_t index) : iteration_(iteration), index_(index) {}

  void operator()(Interval& interval) {
    advance_front(interval);
    if (interval.iteration == iteration_ && interval.index == index_) throw Interruption();
  }

private:
  std::size_t iteration_, index_;
};

class UnsteadyCheckpoint : public testing::Test {
protected:
  UnsteadyCheckpoint() {
    std::filesystem::remove_all(folder);
    options.checkpoint = folder;
  }
  ~UnsteadyCheckpoint() override { std::filesystem::remove_all(folder); }

  [[nodiscard]] UnsteadyResult run(const Mesh& mesh) const {
    return unsteady_fixed_point(mesh, state_at_zero, advance_front, options);
  }

  [[nodiscard]] UnsteadyResult run_without_checkpoint(const Mesh& mesh) const {
    UnsteadyOptions without = options;
    without.checkpoint.clear();
    return unsteady_fixed_point(mesh, state_at_zero, advance_front, without);
  }

  void interrupt(const Mesh& mesh, std::size_t iteration, std::size_t index) const {
    EXPECT_THROW((void)unsteady_fixed_point(mesh, state_at_zero, FailingSolver(iteration, index), options),
                 Interruption);
  }

  void expect_refused(const Mesh& mesh, const std::string& file, const std::string& message) const {
    const std::string found = test::refusal(1, [&] { return run(mesh); });
    EXPECT_TRUE(found.starts_with((folder / file).string() + ": ")) << found;
    EXPECT_NE(found.find(message), std::string::npos) << found;
  }

  void write_summary(const std::string& text) const { std::ofstream(folder / "progress.txt") << text; }

  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) /
      (std::string("taut_checkpoint_") + testing::UnitTest::GetInstance()->current_test_info()->name());
  UnsteadyOptions options = test::front_options();
};

TEST_F(UnsteadyCheckpoint, GoesOnWithTheSameBitsFromAnywhere) {
  const Mesh mesh = test::cube(8);
  const UnsteadyResult expected = run_without_checkpoint(mesh);
  test::expect_same_result(run(mesh), expected);
  for (std::size_t iteration = 0; iteration < 2; ++iteration)
    for (std::size_t index = 0; index < 3; ++index) {
      std::filesystem::remove_all(folder);
      interrupt(mesh, iteration, index);
      test::expect_same_result(run(mesh), expected);
    }
}

TEST_F(UnsteadyCheckpoint, GoesOnFromOneInterruptionToTheNext) {
  const Mesh mesh = test::grid(8);  // without triangles and references
  for (std::size_t iteration = 0; iteration < 2; ++iteration)
    for (std::size_t index = 0; index < 3; ++index) interrupt(mesh, iteration, index);
  test::expect_same_result(run(mesh), run_without_checkpoint(mesh));
}

TEST_F(UnsteadyCheckpoint, AFinishedRunGoesOnWithMoreIterations) {
  const Mesh mesh = test::cube(6);
  options.iterations = 1;
  const UnsteadyResult one = run(mesh);
  test::expect_same_result(run(mesh), one);
  options.iterations = 2;
  test::expect_same_result(run(mesh), run_without_checkpoint(mesh));
  options.iterations = 1;
  const std::string message = test::refusal(1, [&] { return run(mesh); });
  EXPECT_EQ(message, folder.string() + ": iteration 2 found, expected at most the 1 that are asked for");
}

TEST_F(UnsteadyCheckpoint, RefusesWhatIsDamaged) {
  const Mesh mesh = test::cube(4);
  interrupt(mesh, 1, 1);
  const auto size = std::filesystem::file_size(folder / "state-1-0.solb");
  std::filesystem::resize_file(folder / "state-1-0.solb", size - 9);
  expect_refused(mesh, "state-1-0.solb", "");
  std::filesystem::rename(folder / "state-1-0.solb", folder / "hessian-1-0.solb");
  expect_refused(mesh, "hessian-1-0.solb", "");
  std::filesystem::remove(folder / "mesh-1-2.meshb");
  expect_refused(mesh, "mesh-1-2.meshb", "");
  for (const char* text : {"", "a poem", "taut-unsteady-1\n0\n4\n0 0.3 0.6 1\n2\n4 0.3\n",
                           "taut-unsteady-1\n0\n4\n0 0.3", "taut-unsteady-1\n0\n4\n0 0.3 0.6 1\n9999999999\n4 0.3\n"}) {
    write_summary(text);
    expect_refused(mesh, "progress.txt", "damaged, or not a checkpoint of taut");
  }
}

TEST_F(UnsteadyCheckpoint, RefusesThatOfAnotherRun) {
  const Mesh mesh = test::cube(4);
  interrupt(mesh, 0, 1);
  expect_refused(test::cube(5), "hessian-0-0.solb",
                 "values for 125 vertices found, expected 216: the run had another mesh");
  options.times.back() = 2;
  expect_refused(mesh, "progress.txt", "a run over other times found, expected the same");
  options.times.pop_back();
  expect_refused(mesh, "progress.txt", "a run over other times found, expected the same");
}

TEST_F(UnsteadyCheckpoint, FailsBeforeTheWorkIfTheFolderCannotBeMade) {
  std::ofstream(folder) << "a file";
  const auto never = [](Interval&) { FAIL() << "the work began"; };
  EXPECT_THROW((void)unsteady_fixed_point(test::cube(2), state_at_zero, never, options), Failure);
}

}  // namespace
}  // namespace taut
