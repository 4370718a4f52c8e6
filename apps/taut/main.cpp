// taut, the command-line program.
#include "command_line.hpp"
#include "errors.hpp"

int main(int argc, char** argv) {
  return taut::program::exit_status_of([&] { taut::program::run(argc, argv); });
}
