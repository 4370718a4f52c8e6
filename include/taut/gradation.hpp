// How fast the wanted sizes may grow from place to place.
#pragma once

namespace taut {

/// A limit on the growth of sizes along every edge pq ("H-correction", Borouchaki, Hecht and Frey 1998; the mix is from
/// Alauzet 2010). The size that p allows at q in its i-th principal direction is h_i times
/// (1 + l ln beta)^(1 - mix) (1 + |pq| ln beta / h_i)^mix, with l the length of pq in the metric of p.
struct Gradation {
  double beta = 1.5;  ///< largest factor (> 1) by which sizes may grow per unit length
  /// In [0, 1]. 0: growth per unit length in the metric, which keeps the anisotropy and spreads it far; 1: growth per
  /// physical size, which makes the metric isotropic far away; between them, the geometric mean weighted by `mix`.
  double mix = 0.5;
};

}  // namespace taut
