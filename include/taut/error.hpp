// The two ways in which taut gives up. A refused operation inside the library is a value, never an exception.
#pragma once

#include <stdexcept>

namespace taut {

/// The input cannot be used: the message names the file or the entity, what was found and what was expected.
class InputError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// The input is sound but the work could not be done (a file that cannot be written, memory, a full 32-bit id space).
class Failure : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

}  // namespace taut
