// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

#include "radcert/quadrature/even_shape.h"
#include "radcert/quadrature/kernel_sums.h"
#include "radcert/quadrature/tolerance.h"

namespace radcert {

/// Sums over a part of an element, and how far a coarser rule differed.
/// Limits    where not all of the part was integrated, the sums say nothing of the rest, and `complete` says
///           so
template <Real R>
struct CheckedSums {
  KernelSums<R> sums;
  std::array<R, KernelSums<R>::most_functions> difference;  ///< |finer rule - coarser rule|, by function
  bool complete = true;  ///< false: a limit of work or of the arithmetic left something out

  explicit CheckedSums(const KernelSums<R>& fine) : sums(fine) {
    for (std::size_t j = 0; j < sums.functions; ++j) difference[j] = R(0);
  }
  explicit CheckedSums(std::size_t functions) : CheckedSums(KernelSums<R>(functions)) {}

  CheckedSums& operator+=(const CheckedSums& other) {
    sums += other.sums;
    for (std::size_t j = 0; j < sums.functions; ++j) difference[j] += other.difference[j];
    complete = complete && other.complete;
    return *this;
  }
};

/// Lets no function's difference be small by chance, while those of the others are not.
/// Maths     difference_j = min(max_i difference_i, size_j max_i difference_i / size_i) + intended size_j
/// Requires  `intended`: the truncation at which the error model aims, relative to size_j
/// Result    no difference becomes smaller
template <Real R>
void share_largest_difference(CheckedSums<R>& checked, const R& intended) {
  R largest = R(0);
  R largest_relative = R(0);
  for (std::size_t j = 0; j < checked.sums.functions; ++j) {
    largest = std::max(largest, checked.difference[j]);
    if (checked.sums.size[j] > R(0))
      largest_relative = std::max(largest_relative, checked.difference[j] / checked.sums.size[j]);
  }
  for (std::size_t j = 0; j < checked.sums.functions; ++j)
    checked.difference[j] =
        std::min(largest, checked.sums.size[j] * largest_relative) + checked.sums.size[j] * intended;
}

/// The integral of G l_j over an element that contains the collocation point or lies near, on the collocation
/// point's own curved chart.
/// Maths     the element is split at p into triangles (p, a, b); with w = l ((1-m) (a-p) + m (b-p)) and dt ds
///           = |..| l dl dm the integrand G(F(p), F(p+w)) l_j J is analytic in (l, m): bounded, but not
///           smooth, at p itself, it is smooth along rays. The zeros of |DF(p) w(m)|^2, its nearest poles,
///           are m = f +- i h, f the foot of p on the side and h its distance in lengths of the side, both
///           as the tangents at p have it; with m = f + h sinh x they become x = +- i pi/2, however near the
///           side passes p. Gauss-Legendre in l and x, on charts that do not change evenly over the element
///           in l and m, of orders that follow from the turn of the normal and from the Bernstein ellipse
///           of the interval, which is bisected where that is narrow; two products of rules are compared,
///           and finer ones taken while they differ
/// Source    triangle coordinates: Duffy; sinh: Johnston, Elliott (2005); G is bounded: [ac98, (5)-(6)];
///           (Q-P).n_P by divided differences: see Chord
/// Requires  p on the chart of the element, in it or outside: then the rays from p run between its near and
///           far sides; the chart is not flat (there G = 0); `shape` is that of the element
/// Result    the integral; `difference` compares two orders. Not complete where two orders still differ after
///           40 halvings, or in the first 1000 rectangles
/// Limits    on a chart that is not analytic on a line both variables are graded towards their ends
template <Real R>
CheckedSums<R> integrate_around(const CollocationPoint<R>& p, const Chart& chart,
                                const ElementPart<R>& element, const ElementShape& shape,
                                const TriangleBasis<R>& basis, const Tolerance& tolerance);

extern template CheckedSums<double> integrate_around<double>(const CollocationPoint<double>&, const Chart&,
                                                             const ElementPart<double>&, const ElementShape&,
                                                             const TriangleBasis<double>&, const Tolerance&);

extern template CheckedSums<Mpfr<50>> integrate_around<Mpfr<50>>(const CollocationPoint<Mpfr<50>>&,
                                                                 const Chart&, const ElementPart<Mpfr<50>>&,
                                                                 const ElementShape&,
                                                                 const TriangleBasis<Mpfr<50>>&,
                                                                 const Tolerance&);

}  // namespace radcert
