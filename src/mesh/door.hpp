// Checks of the public mesh, and the messages with which it is refused.
#pragma once

#include <array>
#include <cstddef>

#include "taut/mesh.hpp"

namespace taut {

/// Lengths of the arrays, indices in range, finite coordinates, no repeated vertex. Throws InputError.
void require_sound_entities(const Mesh& m);

/// The same, and at least one tetrahedron.
void require_sound_arrays(const Mesh& m);

/// Throws InputError if there are more regions than 16-bit ids can number.
void require_region_count(std::size_t regions);

[[noreturn]] void throw_flat(std::size_t tet, const std::array<Index, 4>& v);
[[noreturn]] void throw_overlap(std::size_t tet, const std::array<Index, 4>& v, std::size_t neighbour,
                                const std::array<Index, 4>& w);
[[noreturn]] void throw_no_face(std::size_t triangle, const std::array<Index, 3>& v);
[[noreturn]] void throw_duplicate(std::size_t triangle, std::size_t other);
[[noreturn]] void throw_crowded_face(const std::array<Index, 3>& v);

}  // namespace taut
