// The triangles that can fill a ring of n vertices around an edge, n = 3 to 7.
#pragma once

#include <array>
#include <cstdint>

namespace taut {

/// The fan from ring vertex p consists of the n - 2 triangles (p, p+i, p+i+1), modulo n. The fans of a ring share
/// triangles, so each triangle is listed once.
struct RingTable {
  static constexpr int smallest = 3, largest = 7;

  int triangle_count = 0;
  std::array<std::array<std::uint8_t, 3>, 28> triangles{};            ///< ascending ring numbers
  std::array<std::array<std::uint8_t, largest - 2>, largest> fans{};  ///< by first vertex: indices into `triangles`
};

constexpr RingTable make_ring_table(int n) {
  RingTable table;
  const auto index_of = [&](int a, int b, int c) {
    std::array<int, 3> t = {a, b, c};
    for (int pass = 0; pass < 2; ++pass)
      for (int i = 0; i < 2; ++i)
        if (t[i] > t[i + 1]) {
          const int larger = t[i];
          t[i] = t[i + 1];
          t[i + 1] = larger;
        }
    for (int k = 0; k < table.triangle_count; ++k)
      if (table.triangles[k][0] == t[0] && table.triangles[k][1] == t[1] && table.triangles[k][2] == t[2]) return k;
    for (int i = 0; i < 3; ++i) table.triangles[table.triangle_count][i] = static_cast<std::uint8_t>(t[i]);
    return table.triangle_count++;
  };
  for (int p = 0; p < n; ++p)
    for (int i = 1; i + 1 < n; ++i)
      table.fans[p][i - 1] = static_cast<std::uint8_t>(index_of(p, (p + i) % n, (p + i + 1) % n));
  return table;
}

inline constexpr std::array<RingTable, 5> ring_tables = {make_ring_table(3), make_ring_table(4), make_ring_table(5),
                                                         make_ring_table(6), make_ring_table(7)};

}  // namespace taut
