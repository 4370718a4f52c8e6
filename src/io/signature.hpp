// What the first bytes of a file say about it.
#pragma once

#include "io/gmf_file.hpp"

namespace taut::gmf {

/// Sets the encoding of `file`. Throws InputError if it is empty, or naming the format if it is one of others that come
/// under the same names.
void read_signature(GmfFile& file);

}  // namespace taut::gmf
