// Runs the program in its own empty folder and checks everything that it does.
#pragma once

#include <gtest/gtest.h>
#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace taut::test {

using Words = std::vector<std::string>;

struct Outcome {
  int status = -1;  ///< minus the signal's number if one ended the program
  std::string out, err;
};

class ProgramTest : public testing::Test {
protected:
  ProgramTest();
  ~ProgramTest() override;

  /// Runs the program to its end, with its output in files, which are not terminals.
  Outcome run(const Words& words);

  /// Starts the program with `terminal` as its standard error.
  pid_t start(const Words& words, const std::string& terminal);
  Outcome finish(pid_t process);

  /// The program ends with `status`, says why on one line that contains all of `parts`, and changes no file.
  void expect_error(const Words& words, int status, const std::vector<std::string>& parts);

  /// The program succeeds, with nothing on standard error.
  Outcome expect_done(const Words& words);

  static void write(const std::string& file, std::string_view text);
  static std::string read(const std::filesystem::path& file);

  /// Every file of the folder with its content.
  static std::map<std::string, std::string> snapshot();

private:
  std::filesystem::path log_, before_;
};

}  // namespace taut::test
