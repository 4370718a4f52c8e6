// On a terminal: the line that shows progress, and Ctrl-C.
#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>

#include "program/fixture.hpp"
#include "program/meshes.hpp"
#include "taut/io.hpp"

namespace taut::test {
namespace {

/// Both ends of a pseudo-terminal.
class Terminal {
public:
  Terminal() : master_(posix_openpt(O_RDWR | O_NOCTTY)) {
    grantpt(master_);
    unlockpt(master_);
    slave_ = open(name().c_str(), O_RDWR | O_NOCTTY);
  }
  ~Terminal() {
    close(master_);
    hang_up();
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  [[nodiscard]] std::string name() const { return ptsname(master_); }

  /// The text since the last call; empty when the program has ended and hang_up() was called.
  std::string wait_for_text() {
    std::array<char, 4096> text{};
    const ssize_t size = ::read(master_, text.data(), text.size());
    return size > 0 ? std::string(text.data(), static_cast<std::size_t>(size)) : std::string();
  }
  /// Otherwise reading would wait forever after the end of the program.
  void hang_up() {
    if (slave_ >= 0) close(slave_);
    slave_ = -1;
  }

private:
  int master_, slave_;
};

class OnTerminal : public ProgramTest {
protected:
  OnTerminal() { write("cube.mesh", mesh_text(cube(2))); }

  std::string rest(Terminal& terminal) {
    std::string all;
    terminal.hang_up();
    for (std::string text; !(text = terminal.wait_for_text()).empty();) all += text;
    return all;
  }

  Terminal terminal_;
};

TEST_F(OnTerminal, ProgressIsOneLine) {
  const pid_t process = start({"adapt", "cube.mesh", "--size", "0.3", "-o", "out.mesh"}, terminal_.name());
  const std::string first = terminal_.wait_for_text();
  const std::string all = first + rest(terminal_);
  EXPECT_EQ(finish(process).status, 0);
  EXPECT_NE(all.find("round 1: insert"), std::string::npos) << all;
  EXPECT_EQ(all.find('\n'), std::string::npos) << all;
}

TEST_F(OnTerminal, CtrlCWritesTheLastValidMesh) {
  const pid_t process = start({"adapt", "cube.mesh", "--size", "0.01", "-o", "out.mesh"}, terminal_.name());
  std::string all = terminal_.wait_for_text();  // the work has begun
  kill(process, SIGINT);
  all += rest(terminal_);
  EXPECT_EQ(finish(process).status, 1);
  EXPECT_NE(all.find("taut: error: interrupted in round"), std::string::npos) << all;
  expect_done({"quality", "out.mesh", "--check"});
}

TEST_F(OnTerminal, CtrlCEndsAMotionAfterItsStep) {
  write_mesh("room.meshb", room(6));
  write("m.json", R"({"bodies": [{"references": [7], "rotation":
                      {"centre": [0.5, 0.5, 0.5], "axis": [0, 0, 1], "degrees": 5}}]})");
  const pid_t process =
      start({"move", "room.meshb", "--motion", "m.json", "--steps", "9999", "-o", "o-%04d.meshb", "--every", "9999"},
            terminal_.name());
  std::string all = terminal_.wait_for_text();
  kill(process, SIGINT);
  all += rest(terminal_);
  EXPECT_EQ(finish(process).status, 1);
  EXPECT_NE(all.find(" of 9999: "), std::string::npos) << all;
  const std::string message = "taut: error: interrupted in step ", file = " holds the mesh";
  ASSERT_NE(all.find(message), std::string::npos) << all;
  const std::string name = all.substr(all.find(file) - 12, 12);
  expect_done({"quality", name, "--check"});
}

}  // namespace
}  // namespace taut::test
