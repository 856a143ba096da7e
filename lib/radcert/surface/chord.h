// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/geometry/vector.h"

namespace radcert {

/// Two points P and Q of one chart F, Q = F(p + w), P = F(p), through divided differences along the segment p
/// + l w.
/// Maths     difference = Q - P = F[0,1],  bend_p = F[0,0,1],  bend_q = F[0,1,1];  since n_P is orthogonal to
///           DF(p) w and n_Q to DF(p + w) w:  (Q-P).n_P = bend_p.n_P  and  (P-Q).n_Q = bend_q.n_Q
/// Source    ours; [ac98, (5)] says that both are O(|P-Q|^2)
/// Requires  p and p + w in the (convex) domain of the chart
/// Result    both products to full relative accuracy of the bends, however close P and Q are
template <Field R>
struct Chord {
  Vector<R> difference;
  Vector<R> bend_p;
  Vector<R> bend_q;
};

}  // namespace radcert
