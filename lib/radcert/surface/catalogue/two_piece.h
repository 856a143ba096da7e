// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/scalar/exponent.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// The curved roof of the two-piece surface.
/// Maths     F(s,t) = (s, t, 2 - s^p), 0 <= s, t <= 1
/// Source    [ac98, (94)]
/// Requires  p >= 1
/// Result    see ChartOf; for p that is not whole F is not analytic on s = 0, for 1 < p < 2 not C^2 there
template <Field R>
class PowerRoof {
public:
  explicit PowerRoof(const Rational& p) : p_(p) {}

  template <Field T>
  Vector<T> operator()(const T& s, const T& t) const {
    return {s, t, R(2) - power(s, p_)};
  }

private:
  Exponent<R> p_;
};

/// The two-piece surface S(p): a unit square below the graph of a power.
/// Maths     S_1 = {(x,y,0)},  S_2 = {(x,y,2-x^p)},  0 <= x, y <= 1
/// Source    [ac98, (94)]
/// Requires  p >= 1, else ContractViolation
/// Result    pieces `lower` and `upper`, inner normals up and down; S lies in the boundary of a convex body
/// Limits    not closed; the pieces do not meet
Surface two_piece(const Rational& p);

}  // namespace radcert
