// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/geometry/vector.h"
#include "radcert/scalar/real.h"
#include "radcert/surface/chord.h"

namespace radcert {

/// The geometric kernel of the radiosity equation between two points P and Q, and what it is made of.
/// Maths     from_p = (Q-P).n_P,  from_q = (P-Q).n_Q,  squared_distance = |P-Q|^2,  G(P,Q) = from_p from_q /
///           |P-Q|^4
/// Source    [ac98, (2)], [m06, (2)]
/// Requires  P != Q; n_P and n_Q inner normals, of unit length for G itself
/// Result    rounded as R rounds; value() takes one division, scaled_value() one more product and no fourth
///           power, which underflows in double from |P-Q| = 1e-77 on
template <Field R>
struct KernelTerms {
  R from_p;
  R from_q;
  R squared_distance;

  [[nodiscard, gnu::always_inline]] R value() const {
    return from_p * from_q / (squared_distance * squared_distance);
  }
  [[nodiscard, gnu::always_inline]] R scaled_value() const {
    const R inverse = reciprocal(squared_distance);
    return (from_p * inverse) * (from_q * inverse);
  }
};

/// a . b with two of its three sums fused, where R has a fused operation.
template <Field R>
[[gnu::always_inline]] inline R fused_dot(const Vector<R>& a, const Vector<R>& b) {
  return multiply_add(a.x, b.x, multiply_add(a.y, b.y, a.z * b.z));
}

/// The terms from difference = P - Q, the normal -n_P and the normal n_Q: of one sign, since (Q-P).n_P =
/// (P-Q).(-n_P), so that a loop over Q negates nothing. Every quadrature of radcert that runs over points
/// takes these, with R double, Pack, Mpfr or Ball. The layer `reference` has its own on purpose: it is what
/// they are held against. Rules over a plane polygon (closed_form/kernel_pieces) sum (Q-P).n_P / |P-Q|^4,
/// whose other scalar product is a constant that stands before the sum.
template <Field R>
[[nodiscard, gnu::always_inline]] inline KernelTerms<R> kernel_terms(const Vector<R>& difference,
                                                                     const Vector<R>& minus_normal_p,
                                                                     const Vector<R>& normal_q) {
  return {fused_dot(difference, minus_normal_p), fused_dot(difference, normal_q),
          fused_dot(difference, difference)};
}

/// The geometric kernel alone.
/// Maths     G(P,Q) = [(Q-P).n_P] [(P-Q).n_Q] / |P-Q|^4
/// Source    [ac98, (2)], [m06, (2)]
/// Requires  P != Q; n_P and n_Q inner normals, of unit length for G itself
/// Result    linear in either normal: with n_Q of the length of the area element the value is G J; rounded as
///           R rounds, with an absolute error of about u |P| (|cos theta_P| + |cos theta_Q|) / |P-Q|^3 beside
///           the relative one where P and Q are rounded points (u the unit roundoff)
/// Limits    near the diagonal of one smooth chart use `chord_kernel`, which loses no digits
template <Field R>
R geometric_kernel(const Vector<R>& p, const Vector<R>& normal_p, const Vector<R>& q,
                   const Vector<R>& normal_q) {
  return kernel_terms<R>(p - q, -normal_p, normal_q).value();
}

/// The kernel between two points of one chart, from their chord.
/// Maths     G(P,Q) = (bend_p.n_P) (bend_q.n_Q) / |difference|^4
/// Source    [ac98, (2), (5), (6)]
/// Requires  P != Q
/// Result    as geometric_kernel, bounded and without cancellation up to the diagonal
/// Limits    both points on one chart
template <Field R>
[[nodiscard, gnu::always_inline]] inline KernelTerms<R> chord_terms(const Chord<R>& chord,
                                                                    const Vector<R>& normal_p,
                                                                    const Vector<R>& normal_q) {
  return {dot(chord.bend_p, normal_p), dot(chord.bend_q, normal_q), dot(chord.difference, chord.difference)};
}
template <Field R>
R chord_kernel(const Chord<R>& chord, const Vector<R>& normal_p, const Vector<R>& normal_q) {
  return chord_terms(chord, normal_p, normal_q).scaled_value();
}

}  // namespace radcert
