// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

#include "radcert/quadrature/observer.h"
#include "radcert/quadrature/samples.h"

namespace radcert {

/// The part of KernelSums::tilt that one point of a chord contributes.
/// Maths     (|bend_p| |n_P| |bend_q.n_Q| + |bend_p.n_P| |bend_q| |n_Q|) / |P-Q|^4
/// Source    first-order effect of relative changes of the bends on [ac98, (2)]
/// Requires  P != Q
/// Result    >= |G|; much larger where a bend is nearly tangential
/// Limits    -
template <Real R>
R chord_lean(const Chord<R>& chord, const Vector<R>& normal_p, const Vector<R>& normal_q) {
  using std::abs;
  const R squared_distance = dot(chord.difference, chord.difference);
  const R towards_q = norm(chord.bend_p) * norm(normal_p) * abs(dot(chord.bend_q, normal_q));
  const R towards_p = abs(dot(chord.bend_p, normal_p)) * norm(chord.bend_q) * norm(normal_q);
  return (towards_q + towards_p) / (squared_distance * squared_distance);
}

/// What a rule sums up for one observer over one cell.
/// Maths     value_j = sum g_q l_j(x_q),  size_j = sum |g_q| |l_j(x_q)|,  total = sum g_q,  size = sum |g_q|,
///           tilt_j = sum of what a relative change of all coordinates by 1 would do to the two scalar products, to first
///           order: |X| (|(Q-P).n_P| + |(P-Q).n_Q|) |l_j| / |P-Q|^4 (weighted), X the largest coordinate; for chords
///           the products of lengths |bend| |n| stand for |X|.  g_q = G(P,Q_q) times area element and weight
/// Source    [ac98, (40)]
/// Requires  at most 45 functions (degree 8)
/// Result    see `rounding`
/// Limits    -
template <Real R>
struct KernelSums {
  static constexpr std::size_t most_functions = 45;
  std::size_t functions;  ///< the first so many places of the arrays are in use
  std::array<R, most_functions> value;
  std::array<R, most_functions> size;
  std::array<R, most_functions> tilt;
  R total{};
  R total_size{};
  std::size_t points = 0;

  explicit KernelSums(std::size_t count) : functions(count) {
    for (std::size_t j = 0; j < functions; ++j) value[j] = size[j] = tilt[j] = R(0);
  }
  KernelSums& operator+=(const KernelSums& other);
};

/// Sums of G over samples, lane by lane, folded in a fixed order.
/// Maths     see KernelSums
/// Source    [ac98, (2), (40)]
/// Requires  P not among the samples
/// Result    the same bits on every machine; no allocation
/// Limits    loses digits near the diagonal of a smooth chart: there use chord_sums
template <Real R>
KernelSums<R> kernel_sums(const Observer<R>& p, const Samples<R>& samples, const R& extent);

/// The same where P = F(p) lies on the chart of the samples: through divided differences.
/// Maths     see KernelSums and Chord
/// Source    ours
/// Requires  p on `chart`, the chart of the samples, and not among them
/// Result    as kernel_sums, without its loss of digits near the diagonal
/// Limits    one virtual call a point
template <Real R>
KernelSums<R> chord_sums(const Observer<R>& p, const Chart& chart, const Samples<R>& samples);

/// A bound for what rounding did to value_j, to first order in the unit roundoff u.
/// Maths     (points + 60) u size_j + 8 u tilt_j: each term passes at most 60 roundings in chart, kernel, weight and
///           basis, a sum of k terms at most k more; coordinates are off by at most 8 u of the largest
/// Source    standard model of rounding; the counts are those of the formulas in this layer
/// Requires  -
/// Result    a bound if the chart's own formula loses no more than 8 u of the largest coordinate
/// Limits    -
template <Real R>
R rounding(const KernelSums<R>& sums, std::size_t j) {
  const R u = unit_roundoff<R>();
  return R(static_cast<double>(sums.points + 60)) * u * sums.size[j] + R(8) * u * sums.tilt[j];
}

extern template struct KernelSums<double>;
extern template KernelSums<double> kernel_sums<double>(const Observer<double>&, const Samples<double>&,
                                                       const double&);
extern template KernelSums<double> chord_sums<double>(const Observer<double>&, const Chart&,
                                                      const Samples<double>&);

}  // namespace radcert
