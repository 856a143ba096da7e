// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <type_traits>

#include "radcert/geometry/vector.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/scalar/pack.h"
#include "radcert/scalar/real.h"
#include "radcert/surface/chord.h"

namespace radcert {

/// Coordinates are off by at most so many u of the largest.
inline constexpr int coordinate_roundings = 8;

/// G between two points with rounded coordinates.
/// Maths     e lean bounds, e = 8 u, what a change of all coordinates by e X does to the product of the two
///           scalar products over |P-Q|^4, X the largest coordinate; for chords a change of the bends'
///           components by e of themselves
template <Field R>
struct RoundedKernel {
  R value;
  R lean;
};

/// The kernel between two points, by their difference and normals.
/// Maths     lean = X (|n_Q| |(Q-P).n_P| + |(P-Q).n_Q| + e X |n_Q|) / |P-Q|^4, |n_Q| = |n_1| + |n_2| + |n_3|
/// Requires  P != Q, n_P of unit length; as kernel_terms P - Q, -n_P and n_Q; `extent` is X and `blur` is e X
template <Field R>
[[nodiscard]] inline RoundedKernel<R> rounded_kernel(const Vector<R>& difference,
                                                     const Vector<R>& minus_normal_p,
                                                     const Vector<R>& normal_q, const R& extent,
                                                     const R& blur) {
  using std::abs;
  const KernelTerms<R> g = kernel_terms<R>(difference, minus_normal_p, normal_q);
  const R weight = abs(normal_q.x) + abs(normal_q.y) + abs(normal_q.z);
  const R inverse = reciprocal(R(g.squared_distance * g.squared_distance));
  return {g.from_p * g.from_q * inverse,
          extent * (((abs(g.from_p) + blur) * weight + abs(g.from_q)) * inverse)};
}

/// The kernel between two points of one chart, by their chord.
/// Maths     lean = (|bend_p|.|n_P| |bend_q.n_Q| + |bend_p.n_P| |bend_q|.|n_Q| + e |bend_p|.|n_P|
///           |bend_q|.|n_Q|) / |P-Q|^4, |v| by components
/// Requires  P != Q
/// Result    lean >= 2 |value|; much larger where a bend is nearly tangential
template <Field R>
[[nodiscard]] inline RoundedKernel<R> rounded_kernel(const Chord<R>& chord, const Vector<R>& normal_p,
                                                     const Vector<R>& normal_q) {
  using std::abs;
  const auto absolute_dot = [](const Vector<R>& a, const Vector<R>& b) {
    return R(abs(a.x * b.x) + abs(a.y * b.y) + abs(a.z * b.z));
  };
  constexpr auto roundoff = [] {
    if constexpr (std::is_same_v<R, Pack>)
      return unit_roundoff<double>();
    else
      return unit_roundoff<R>();
  };
  const KernelTerms<R> g = chord_terms(chord, normal_p, normal_q);
  const R inverse = reciprocal(g.squared_distance);
  const R towards_q = g.from_p * inverse;
  const R towards_p = g.from_q * inverse;
  const R bend_p = absolute_dot(chord.bend_p, normal_p);
  const R bend_q = absolute_dot(chord.bend_q, normal_q);
  const R second = R(coordinate_roundings * roundoff()) * bend_q * inverse;
  return {towards_q * towards_p, (bend_p * (abs(towards_p) + second) + abs(towards_q) * bend_q) * inverse};
}

}  // namespace radcert
