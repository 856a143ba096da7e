// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/geometry/vector.h"
#include "radcert/surface/chord.h"

namespace radcert {

/// The geometric kernel of the radiosity equation.
/// Maths     G(P,Q) = [(Q-P).n_P] [(P-Q).n_Q] / |P-Q|^4
/// Source    [ac98, (2)], [m06, (2)]
/// Requires  P != Q; n_P and n_Q inner normals, of unit length for G itself
/// Result    linear in either normal: with n_Q of the length of the area element the value is G J;
///           rounded as R rounds, with an absolute error of about u |P| (|cos theta_P| + |cos theta_Q|) /
///           |P-Q|^3 beside the relative one where P and Q are rounded points (u the unit roundoff)
/// Limits    near the diagonal of one smooth chart use `chord_kernel`, which loses no digits
template <Field R>
R geometric_kernel(const Vector<R>& p, const Vector<R>& normal_p, const Vector<R>& q,
                   const Vector<R>& normal_q) {
  const Vector<R> d = q - p;
  const R squared_distance = dot(d, d);
  return -(dot(d, normal_p) * dot(d, normal_q)) / (squared_distance * squared_distance);
}

/// The geometric kernel between two points of one chart, from their chord.
/// Maths     G(P,Q) = (bend_p.n_P) (bend_q.n_Q) / |difference|^4
/// Source    [ac98, (2), (5), (6)]
/// Requires  P != Q
/// Result    as geometric_kernel, bounded and without cancellation up to the diagonal
/// Limits    both points on one chart
template <Field R>
R chord_kernel(const Chord<R>& chord, const Vector<R>& normal_p, const Vector<R>& normal_q) {
  // Not by the fourth power, which underflows from |P-Q| = 1e-77 on.
  const R inverse = R(1) / dot(chord.difference, chord.difference);
  return (dot(chord.bend_p, normal_p) * inverse) * (dot(chord.bend_q, normal_q) * inverse);
}

}  // namespace radcert
