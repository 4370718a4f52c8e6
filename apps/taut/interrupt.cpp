#include "interrupt.hpp"

#include <csignal>

namespace taut::program {
namespace {

// A signal handler may change nothing else of the program.
volatile std::sig_atomic_t interrupted = 0;

extern "C" void note_interrupt(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

Interrupt::Interrupt() : previous_(std::signal(SIGINT, note_interrupt)) {
  if (previous_ == SIG_IGN) std::signal(SIGINT, SIG_IGN);  // a background job keeps running
}

Interrupt::~Interrupt() {
  std::signal(SIGINT, previous_);
}

bool Interrupt::requested() const {
  return interrupted != 0;
}

}  // namespace taut::program
