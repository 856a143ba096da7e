// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "radcert/core/outcome.h"
#include "radcert/core/ranks/vector_parts.h"
#include "radcert/core/work_limit.h"
#include "radcert/solve/system_matrix.h"

namespace radcert {

/// A norm in which a matrix K, and every matrix near it, shrinks all vectors: what turns a residual into an
/// error bound.
/// Maths     ||x||_w = max_i |x_i| / w_i with |K| w <= theta w, w > 0, theta < 1. Then (I - |K|)^-1 >= 0
///           exists, and (I - K) x = d gives ||x||_w <= ||d||_w / (1 - theta). Since max w = 1, max_i |x_i|
///           <= ||x||_w
/// Source    Collatz (1942) and Wielandt (1950) for w, Perron and Frobenius; w = 1 is residual/(1 - ||K||)
/// Requires  made by find_contraction; or by contraction_by_estimate, and then an estimate in all it says
/// Result    theta, norm and inverse_bound are rounded up: the bounds hold for the numbers as stored. The
///           largest weight is 1
/// Limits    says nothing of matrices whose |K| has a spectral radius >= 1, though I - K may be regular
class Contraction {
public:
  /// Those of the entries that are here.
  std::span<const double> weights() const { return weights_; }
  double least_weight() const;
  double theta() const { return theta_; }

  /// ||x||_w, rounded up; infinite where an entry of x is not finite. Requires as many entries as weights,
  /// and that all ranks ask.
  double norm(std::span<const double> x) const;

  /// A bound of max_i |((I - K)^-1 d)_i| over all d with ||d||_w <= `norm_of_d`, rounded up.
  double inverse_bound(double norm_of_d) const;

private:
  friend struct ContractionSearch;
  VectorParts parts_;
  std::vector<double> weights_;
  double theta_ = 0;
};

/// No weights were found.
struct NoContraction {
  double theta = 0;  ///< the least that was
  /// A lower bound of the spectral radius of |K|, 0 for an operator: min_i (|K| w)_i / w_i for the best
  /// positive w that was seen (Collatz, 1942; Wielandt, 1950), rounded down.
  double radius_from_below = 0;
};

extern const WorkLimit most_power_steps;

/// Looks for weights in which K contracts.
/// Maths     w <- (|K| + theta/2 I) w from w = 1: theta never grows, and tends to the spectral radius where
///           |K| is irreducible; the shift keeps w positive and lets w converge where |K| is periodic, as for
///           two surfaces that see each other but not themselves. Of the weights seen those are taken for
///           which 1/((1 - theta) min w) is least
/// Source    Wielandt (1950); Varga: Matrix Iterative Analysis (1962), section 2.1
/// Requires  K square, not empty, at most 2^26 rows; as many radii as rows or none
/// Result    a contraction of every matrix whose entries in row i differ from those of K by radius_i in all;
///           theta is infinite where K is not finite. The same bits for any number of threads; Interrupted
///           when asked to stop
/// Limits    at most `most_steps` products: a spectral radius just below 1 may be missed
Outcome<Contraction, NoContraction> find_contraction(const SystemMatrix& k,
                                                     std::span<const double> row_radius = {},
                                                     long most_steps = most_power_steps.value());

}  // namespace radcert
