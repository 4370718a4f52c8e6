// Ctrl-C as a wish to stop in good order.
#pragma once

namespace taut::program {

/// While one exists the first SIGINT is only noted; a second one ends the program as it does without.
class Interrupt {
public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  [[nodiscard]] bool requested() const;

private:
  void (*previous_)(int);
};

}  // namespace taut::program
