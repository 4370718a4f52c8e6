#include "program/fixture.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace taut::test {
namespace {

namespace fs = std::filesystem;

fs::path new_folder() {
  std::string name = (fs::temp_directory_path() / "taut_program_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  return name;
}

pid_t spawn(const Words& words, const std::string& out, const std::string& err) {
  std::vector<char*> arguments = {const_cast<char*>(TAUT_PROGRAM)};
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);

  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, 1, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_addopen(&files, 2, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOCTTY, 0600);

  // A test run in the background ignores SIGINT, and its children would inherit that.
  posix_spawnattr_t attributes;
  sigset_t interrupt;
  sigemptyset(&interrupt);
  sigaddset(&interrupt, SIGINT);
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setsigdefault(&attributes, &interrupt);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);

  pid_t process = 0;
  const int error = posix_spawn(&process, TAUT_PROGRAM, &files, &attributes, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  posix_spawnattr_destroy(&attributes);
  if (error != 0) throw std::runtime_error("the program cannot be started");
  return process;
}

bool is_one_line(const std::string& text) {
  return !text.empty() && text.find('\n') == text.size() - 1;
}

}  // namespace

ProgramTest::ProgramTest() : log_(new_folder()), before_(fs::current_path()) {
  fs::create_directory(log_ / "work");
  fs::current_path(log_ / "work");
}

ProgramTest::~ProgramTest() {
  fs::current_path(before_);
  fs::remove_all(log_);
}

Outcome ProgramTest::run(const Words& words) {
  return finish(spawn(words, log_ / "out", log_ / "err"));
}

pid_t ProgramTest::start(const Words& words, const std::string& terminal) {
  return spawn(words, log_ / "out", terminal);
}

Outcome ProgramTest::finish(pid_t process) {
  int state = 0;
  waitpid(process, &state, 0);
  return {WIFEXITED(state) ? WEXITSTATUS(state) : -WTERMSIG(state), read(log_ / "out"), read(log_ / "err")};
}

void ProgramTest::expect_error(const Words& words, int status, const std::vector<std::string>& parts) {
  const auto files = snapshot();
  const Outcome outcome = run(words);
  EXPECT_EQ(outcome.status, status) << outcome.err;
  EXPECT_TRUE(outcome.err.starts_with("taut: error: ")) << outcome.err;
  EXPECT_TRUE(is_one_line(outcome.err)) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  for (const std::string& part : parts)
    EXPECT_NE(outcome.err.find(part), std::string::npos) << part << "\n" << outcome.err;
  EXPECT_EQ(snapshot(), files);
}

Outcome ProgramTest::expect_done(const Words& words) {
  Outcome outcome = run(words);
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "");
  return outcome;
}

void ProgramTest::write(const std::string& file, std::string_view text) {
  std::ofstream(file, std::ios::binary) << text;
}

std::string ProgramTest::read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::map<std::string, std::string> ProgramTest::snapshot() {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(fs::current_path()))
    files[entry.path().string()] = entry.is_regular_file() ? read(entry.path()) : "";
  return files;
}

}  // namespace taut::test
