#include "io/open_block.hpp"

#include <fmt/format.h>

namespace taut::gmf {

void require_three_dimensions(const GmfFile& file) {
  read_block(file, file.require(Code::dimension), [](auto& in) {
    const std::int64_t found = in.word();
    if (found != 3) in.fail(fmt::format("{} found, expected 3: taut takes tetrahedra in three dimensions", found));
  });
}

}  // namespace taut::gmf
