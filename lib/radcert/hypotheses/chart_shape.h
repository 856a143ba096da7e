// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "radcert/hypotheses/chart_patch.h"
#include "radcert/surface/exact_chart.h"

namespace radcert {

/// Which of a chart's stated facts about the shape of its image are proved.
/// Maths     inner: l(F) = 0, and grad l has the direction of the inner normals. quadric: q(F) = 0, nappe(F)
///           > 0, the inner normals have the direction of -grad q, and the inside is convex.
///           profile_is_convex: F is ruled, and (F(w) - F(p)) . N(p) >= 0 for all p and w of its domain
/// Source    the facts of the chart
/// Result    proof: how the shape was proved; refusal: why what is stated was not. Both empty where nothing
///           is stated
/// Limits    at most one of the three is set
struct ProvedShape {
  std::optional<AffineForm> inner = std::nullopt;
  std::optional<Quadric> quadric = std::nullopt;
  bool profile_is_convex = false;
  std::string proof;
  std::string refusal;
};

/// Proves what a chart states of its shape.
/// Maths     identities by exact expressions: l(F), q(F) and F(s,t) - F(s,0) - t ruling are the zero
///           function. Signs of N . grad by balls over boxes that cover the domain, bisected: they show that
///           neither vanishes, and q(F) = 0 that both are parallel. A ruled chart: with F(s,0) = c + a s +
///           sum_k v_k s^(e_k), all e_k > 1 and all det(v_j, v_k, ruling) = 0,
///             (F(w) - F(p)) . (D_s F(p) x ruling) = sum_k det(a, v_k, ruling) (e_k p^(e_k - 1) (w - p) -
///             (w^e_k - p^e_k)),
///           where each bracket is <= 0, the power being convex
/// Source    the expressions are those of the chart's own formula: see ExactImage
/// Requires  image: the chart's exact image, or null
/// Result    boxes: increased by those looked at
/// Limits    without an exact image nothing stated is proved
[[nodiscard]] ProvedShape prove_shape(const Chart& chart, const Vector<ExactFunction>* image,
                                      std::size_t& boxes);

/// Whether a condition holds over boxes that cover the domain of a chart.
/// Maths     the boxes of a bisection for which `holds` is true cover the domain
/// Result    the number of boxes left where it was not shown: 0 is a proof; boxes is increased by those
///           looked at
/// Limits    at most `limit` boxes
[[nodiscard]] std::size_t boxes_left(const Chart& chart, std::size_t limit, std::size_t& boxes,
                                     const std::function<bool(const Frame<Ball>&)>& holds);

/// Whether two quadrics have the same coefficients.
[[nodiscard]] bool is_same(const Quadric& a, const Quadric& b);
[[nodiscard]] bool is_same(const AffineForm& a, const AffineForm& b);

}  // namespace radcert
