// How fast the wanted sizes may grow from place to place.
#pragma once

#include "taut/export.hpp"
#include "taut/mesh.hpp"
#include "taut/metric.hpp"

namespace taut {

/// A limit on the growth of sizes along every edge pq ("H-correction", Borouchaki, Hecht and Frey 1998; Dobrzynski and
/// Frey 2008, 4.1; the mix is from Alauzet 2010). The size that p allows at q in its i-th principal direction is h_i
/// times (1 + l ln beta)^(1 - mix) (1 + |pq| ln beta / h_i)^mix, with l the length of pq in the metric of p.
struct Gradation {
  double beta = 1.5;  ///< largest factor (> 1) by which sizes may grow per unit length
  /// In [0, 1]. 0: growth per unit length in the metric, which keeps the anisotropy and spreads it far; 1: growth per
  /// physical size, which makes the metric isotropic far away; between them, the geometric mean weighted by `mix`.
  double mix = 0.5;
};

/// The metric with its growth limited along the edges of the tetrahedra, to a thousandth of an eigenvalue. Where
/// necessary, sizes become smaller, never larger; elsewhere, the tensors keep their bits. The order of the vertices and
/// the number of threads do not change the result. Throws InputError if `gradation`, an array of `mesh` or the number
/// of tensors cannot be used, and, naming the vertex, if a tensor is not positive definite.
[[nodiscard]] TAUT_EXPORT Tensors gradate(const Mesh& mesh, Tensors metric, const Gradation& gradation = {});

}  // namespace taut
