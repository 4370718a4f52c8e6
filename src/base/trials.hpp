// What has been tried on a tetrahedron, packed: a bit for each kind of operation and edge or face.
#pragma once

#include <cstdint>

namespace taut {

/// Insertion counts as tried for edges that are not too long, collapse for those that are not too short; `not_unit`
/// marks the edges that are either. Repair is tried on the whole tetrahedron. The value is the first bit of the kind.
enum class Trial : std::uint32_t {
  insertion = 0,
  collapse = 6,
  edge_swap = 12,
  face_swap = 18,
  not_unit = 22,
  repair = 28
};

class Trials {
public:
  [[nodiscard]] bool all(Trial kind) const { return (bits_ & all_of(kind)) == all_of(kind); }
  [[nodiscard]] bool has(Trial kind, int entity) const { return (bits_ & bit(kind, entity)) != 0; }
  void set(Trial kind, int entity) { bits_ |= bit(kind, entity); }

  /// Swaps and repairs that failed may succeed now.
  void forget_shapes() { bits_ &= ~(all_of(Trial::edge_swap) | all_of(Trial::face_swap) | all_of(Trial::repair)); }

  /// Nothing is known of the lengths of edges any more.
  void measure_lengths() { bits_ &= ~(all_of(Trial::insertion) | all_of(Trial::collapse) | all_of(Trial::not_unit)); }

  /// Insertions and collapses that failed may succeed now.
  void forget_lengths() {
    const std::uint32_t edges = (bits_ >> first(Trial::not_unit)) & six;
    bits_ &= ~((edges << first(Trial::insertion)) | (edges << first(Trial::collapse)));
  }

  /// Records whether an edge is too long, too short or (both false) unit: only what can succeed is left to try.
  void set_length(int edge, bool is_long, bool is_short) {
    bits_ &= ~(bit(Trial::insertion, edge) | bit(Trial::collapse, edge) | bit(Trial::not_unit, edge));
    if (!is_long) set(Trial::insertion, edge);
    if (!is_short) set(Trial::collapse, edge);
    if (is_long || is_short) set(Trial::not_unit, edge);
  }

  constexpr bool operator==(const Trials&) const = default;

private:
  static constexpr std::uint32_t six = 0x3fU, four = 0xfU;
  static constexpr std::uint32_t first(Trial kind) { return static_cast<std::uint32_t>(kind); }
  static constexpr std::uint32_t bit(Trial kind, int entity) {
    return 1U << (first(kind) + static_cast<std::uint32_t>(entity));
  }
  static constexpr std::uint32_t all_of(Trial kind) {
    return (kind == Trial::repair ? 1U : kind == Trial::face_swap ? four : six) << first(kind);
  }

  std::uint32_t bits_ = 0;
};

}  // namespace taut
