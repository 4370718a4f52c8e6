// What became of an operation: it was done, or why it was not.
#pragma once

#include <array>
#include <cstdint>

namespace taut {

enum class Outcome : std::uint8_t {
  accepted,      ///< it was done
  too_large,     ///< more tetrahedra than a valid cavity has
  frozen,        ///< a required entity, or a patch that may not change, is in the way
  geometry,      ///< a corner, ridge or patch would change
  surface,       ///< a new triangle would not fit its curved patch
  inverted,      ///< a new tetrahedron would not be positive
  quality,       ///< a new tetrahedron would be too bad
  short_edge,    ///< a new edge would be too short
  long_edge,     ///< a new edge would be too long
  topology,      ///< the cavity's hull is not a surface, or a vertex would lose its last tetrahedron
  no_candidate,  ///< nothing better was found
  put_off        ///< it reaches beyond the block, or the block has no ids left: a later round will try it
};

inline constexpr std::array<const char*, 12> outcome_names = {"accepted",  "too large", "frozen",         "geometry",
                                                              "surface",   "inverted",  "quality",        "short edge",
                                                              "long edge", "topology",  "nothing better", "put off"};

}  // namespace taut
