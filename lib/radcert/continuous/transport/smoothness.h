// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "radcert/continuous/elements/element_side.h"
#include "radcert/continuous/elements/gauss_tables.h"
#include "radcert/continuous/elements/graded_elements.h"
#include "radcert/continuous/elements/sector.h"
#include "radcert/continuous/elements/tensor_legendre.h"
#include "radcert/continuous/transport/edge_closure.h"
#include "radcert/continuous/transport/edge_continuation.h"
#include "radcert/continuous/transport/transport_bounds.h"

namespace radcert {

/// Bounds of what rules on a cell of observers miss, for each number of nodes in one variable.
/// Maths     [n-1], n = 1, ..., most_gauss_nodes. interpolation: |f - p| <= e for some p of degree n - 1 of
///           the variable, f = T w and q together; quadrature: of the mean of w T w
struct RuleErrors {
  std::array<double, most_gauss_nodes> interpolation{};
  std::array<double, most_gauss_nodes> quadrature{};
};

/// How smooth T w is around points of the surface.
/// Maths     T w = sum over the panels Q_j of T_j w, each holomorphic around the lines of a cell, in ellipses
///           in which ObserverLines' bounds hold; closed at an edge, F of EdgeClosure in its place. Of a
///           panel that is seen in part, F of Penumbra: its parts and their shares do not depend on P, so
///           that the tube's bound holds, in which no Q moves. What holds in an ellipse bounds polynomials
///           and rules by polynomial_error_factor and gauss_mean_error_factor. Along an edge T_j w~ of
///           EdgeContinuation may stand for T_j w of the panel beyond, and T_j |w - w~| is added
/// Requires  the scene, the elements and the closure outlive it; w and q have the same degree and count
/// Result    rounded up; infinite where an edge is touched
class Smoothness {
public:
  Smoothness(const SectorScene& scene, std::span<const SectorElement> elements, const SectorFunctions& w,
             const SectorFunctions& q, const EdgeClosure& closure);

  /// Of T w, or of F where `closed`: the element has a mirror then.
  [[nodiscard]] RuleErrors along_s(std::size_t element, const SectorBox& box, bool closed) const;
  [[nodiscard]] RuleErrors along_t(std::size_t element, const SectorBox& box, bool closed) const;
  /// A bound of |w| and of |T w - q| on an element.
  [[nodiscard]] double density_size(std::size_t element) const { return w_size_[element]; }
  [[nodiscard]] double residual_size(std::size_t element) const { return size_ + q_size_[element]; }
  [[nodiscard]] double size() const { return size_; }
  /// Of |T w - q| on all elements; it bounds |E| + rho |q| within a factor of 2 as well.
  [[nodiscard]] double largest_residual() const { return 2 * size_ + 2 * largest_q_; }

private:
  struct Cell;
  [[nodiscard]] Cell across_s(std::size_t element, const SectorBox& box) const;
  [[nodiscard]] Cell across_t(std::size_t element, const SectorBox& box) const;
  [[nodiscard]] ObserverLines lines(const Cell& cell, std::size_t panel) const;
  [[nodiscard]] double reach_of_slide(const Cell& cell, std::span<const ElementSide> sides) const;
  [[nodiscard]] double reach_of_turn(const Cell& cell) const;
  [[nodiscard]] std::vector<PanelView> seen_from(const Cell& cell) const;
  [[nodiscard]] RuleErrors along(const Cell& cell, bool closed) const;

  const SectorScene& scene_;
  std::span<const SectorElement> elements_;
  const EdgeClosure& closure_;
  EdgeContinuation continuation_;
  std::vector<PolynomialSizes> w_sizes_;
  std::vector<PolynomialSizes> q_sizes_;
  std::vector<double> w_size_;  ///< of each element
  std::vector<double> q_size_;
  std::vector<double> panel_size_;               ///< sup |w|
  std::vector<SlidSizes> slid_size_;             ///< the same where Q has slid
  std::vector<double> turned_size_;              ///< by sector: sup |w| where Q has turned about its side
  std::vector<std::vector<ElementSide>> sides_;  ///< by sector, panel: those of sides_across
  double size_ = 0;
  double largest_q_ = 0;
};

}  // namespace radcert
