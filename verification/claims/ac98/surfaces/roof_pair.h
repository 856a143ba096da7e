// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "radcert/scalar/real.h"

namespace radcert::verification::ac98 {

/// Two points of the roof of two_piece, with the factor (xi - x)^2 divided out.
/// Maths     P = (x, y, 2 - x^p), Q = (xi, eta, 2 - xi^p), d = xi - x, e = eta - y:
///           (Q-P).n_P = d^2 bend_p/stretch_p,  (P-Q).n_Q = d^2 bend_q/stretch_q,  |Q-P|^2 = d^2 chord + e^2,
///           bend_p = (xi^p - x^p - p x^(p-1) d)/d^2 = sum_k (p-1-k) x^(p-2-k) xi^k, bend_q with x and xi
///           exchanged, stretch_p = (1 + p^2 x^(2p-2))^(1/2), chord = 1 + [(xi^p - x^p)/d]^2
/// Source    [ac98, (94)]
/// Requires  p >= 2
/// Result    as T rounds; typed in here, and not taken from the chart
template <Field T>
struct RoofPair {
  RoofPair(int p, const T& x, const T& xi)
      : bend_p(bend(p, x, xi)), bend_q(bend(p, xi, x)), stretch_p(stretch(p, x)), stretch_q(stretch(p, xi)) {
    T slope(0);
    for (int k = 0; k < p; ++k) slope = slope + power(x, p - 1 - k) * power(xi, k);
    chord = T(1) + slope * slope;
  }

  static T bend(int p, const T& x, const T& xi) {
    T sum(0);
    for (int k = 0; k + 2 <= p; ++k) sum = sum + T(p - 1 - k) * power(x, p - 2 - k) * power(xi, k);
    return sum;
  }
  static T stretch(int p, const T& x) {
    using std::sqrt;
    const T slope = T(p) * power(x, p - 1);
    return sqrt(T(1) + slope * slope);
  }

  T bend_p;
  T bend_q;
  T stretch_p;
  T stretch_q;
  T chord;
};

}  // namespace radcert::verification::ac98
