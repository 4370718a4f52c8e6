// Ctrl-C as a request to stop cleanly.
#pragma once

namespace taut::program {

/// While an Interrupt exists, the first SIGINT is only recorded; a second one ends the program as usual.
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
