// Finding the keywords of a file: they fill version, byte order and blocks of `file`, or throw InputError.
#pragma once

#include "io/gmf_file.hpp"

namespace taut::gmf {

void index_text(GmfFile& file);
void index_binary(GmfFile& file);

}  // namespace taut::gmf
