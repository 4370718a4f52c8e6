// The file of `taut adapt --local`: sizes at parts of the mesh, by reference.
//
//   {"triangles": {"3": {"size": 0.02}, "4": {"deviation": 1e-3, "min": 0.01}},
//    "edges": {"7": {"size": 0.01}},
//    "points": {"1": {"size": 0.005}},
//    "tetrahedra": {"2": {"min": 0.01, "max": 0.1}}}
//
// What the keys mean, see taut::LocalSize.
#pragma once

#include <string>

#include "taut/local_sizes.hpp"

namespace taut::program {

/// Throws InputError, which names the file and the place in it, for what is not as above: unknown keys, wrong types,
/// references given twice. The library checks the values.
[[nodiscard]] LocalSizes read_local_sizes(const std::string& file);

}  // namespace taut::program
