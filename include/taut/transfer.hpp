// Fields from one mesh to another.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "taut/error.hpp"
#include "taut/export.hpp"
#include "taut/field.hpp"
#include "taut/host.hpp"
#include "taut/mesh.hpp"

namespace taut {

/// How fields get from one mesh to another. Both methods reproduce linear fields and create no new extremum.
enum class Transfer {
  /// The value of the piecewise linear field at each point. Cheap, but it loses mass and flattens peaks when repeated.
  linear,
  /// The projection in L2 on the intersection of the two meshes, limited. It keeps the integral of every component, and
  /// may be repeated many times.
  conservative,
};

/// How fields are transferred. The defaults suit most fields.
struct TransferOptions {
  Transfer method = Transfer::conservative;  ///< see there
  /// Only for `conservative`: flux-corrected transport (Zalesak 1979) keeps each value between the least and the
  /// greatest value at the vertices of those old tetrahedra that the tetrahedra around the new point meet. false: the
  /// projection itself, which is smoother at peaks, and overshoots at jumps.
  bool limited = true;
  /// Largest number of threads; 0: as many as the caller's oneTBB task arena has, by default one per core. The result
  /// does not depend on it.
  int threads = 0;
};

/// One component of a field, before and after.
struct ComponentReport {
  double mass_before = 0;      ///< integral over the old mesh
  double mass_after = 0;       ///< integral over the new mesh
  double least_before = 0;     ///< least value at the points of the old mesh's tetrahedra
  double greatest_before = 0;  ///< greatest value at them
  double least_after = 0;      ///< least value at the points of the new mesh's tetrahedra
  double greatest_after = 0;   ///< greatest value at them
};

/// What a transfer did.
struct TransferReport {
  std::size_t outside = 0;   ///< points of the new mesh outside the domain of the old one, by more than rounding
  double distance_max = 0;   ///< largest distance of such a point from the old mesh
  double volume_before = 0;  ///< of the old mesh
  double volume_after = 0;   ///< of the new mesh
  /// Only of `conservative`: the volume of the intersection. It equals both volumes if the domains are the same.
  std::optional<double> covered_volume{};
  std::size_t overlaps = 0;  ///< pairs of an old and a new tetrahedron that overlap; 0 unless `conservative`
  std::vector<std::vector<ComponentReport>> fields;     ///< by field and component
  std::vector<std::pair<std::string, double>> seconds;  ///< elapsed time by phase
};

/// Fields on the new mesh, and a report.
struct Transferred {
  std::vector<Field> fields;  ///< at the points of the new mesh, in the order and of the kinds of the old ones
  TransferReport report;      ///< what the transfer did
};

/// Transfers `fields`, given at the points of `from`, to the points of `to`. Vectors and tensors are transferred
/// component by component. Regions make no difference: a field is continuous across interfaces.
///
/// A point outside the domain of `from` takes the value at the nearest point of its boundary. Conservative: the
/// projection is taken on the part of `to` that `from` covers, so where domains differ, as curved walls do, values stay
/// right and the integrals change as the volume does. A point none of whose tetrahedra is covered takes the
/// interpolated value (Alauzet and Mehrenberger 2010; Farrell et al. 2009).
///
/// Throws InputError if a mesh cannot be used, a field does not fit `from`, a value is not finite, or an option is out
/// of range. The message starts with "fields: " or "target: " unless it is about `from`.
[[nodiscard]] TAUT_EXPORT Transferred transfer(const Mesh& from, const std::vector<Field>& fields, const Mesh& to,
                                               const TransferOptions& options = {});

/// The fields, given at the points of `from`, at the places `hosts`, such as AdaptResult::hosts: linear interpolation
/// without a search. Throws InputError if a field does not fit `from`, a value is not finite, or an index is out of
/// range.
[[nodiscard]] TAUT_EXPORT std::vector<Field> interpolate(const Mesh& from, const std::vector<Field>& fields,
                                                         const std::vector<Host>& hosts);

}  // namespace taut
