// The two kinds of error that taut throws. A refused operation inside the library is a value, never an exception.
#pragma once

#include <stdexcept>

#include "taut/export.hpp"

namespace taut {

/// The input cannot be used. The message names the file or the entity, what was found and what was expected.
class TAUT_EXPORT InputError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// The input is sound, but the work cannot be done: a file cannot be written, or the mesh needs more than 32-bit ids.
class TAUT_EXPORT Failure : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

}  // namespace taut
