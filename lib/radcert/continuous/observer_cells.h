// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "radcert/continuous/gauss_tables.h"
#include "radcert/continuous/graded_elements.h"
#include "radcert/continuous/sector.h"
#include "radcert/continuous/tensor_legendre.h"

namespace radcert {

/// Bounds of what rules on a cell of observers miss, for each number of nodes in one variable.
/// Maths     [n-1], n = 1, ..., most_gauss_nodes. interpolation: |f - p| <= e for some p of degree n - 1 of
///           the variable, f = T w and q together; quadrature: of the mean of w T w
struct RuleErrors {
  std::array<double, most_gauss_nodes> interpolation{};
  std::array<double, most_gauss_nodes> quadrature{};
};

/// How smooth T w is around points of the surface.
/// Maths     T w = sum over the panels Q_j of T_j w, each holomorphic around a line of observers c + z e, z
///           in the ellipse with the half axes a and b:
///           tube     |T_j w| <= (1 + a |e.n_j|/d) T_j(|w| (r/(r-a))^4)(c), r = |c-Q|, d the distance of c
///                    from the plane of Q_j: |P-Q|^2 has two factors of modulus >= r - a, n_P.(Q-P) does not
///                    change, n_j.(P-Q) by a |e.n_j| at most. With D the distance of c from Q_j that is at
///                    most (D/(D-a))^4 T_j|w|, and at most sup|w| Int_D^oo (r/(r-a))^4 m d/r^2 dr = m d (1/g
///                    + a/g^2 + a^2/(3 g^3)) sup|w|, g = D - a: the kernel is at most d/r^3, on rings, m = 2,
///                    or on half rings, m = 1, where the foot of c in the plane does not lie before the
///                    observer: n_P.n_j >= 0
///           slide    where e is parallel to Q_j: P = p + i tau e with p real, and Q moves to Q + i tau phi
///                    e, phi = max(0, 1 - |Q-p|/r), r at most the distance of p from all sides of elements of
///                    Q_j not parallel to e: Cauchy's theorem on each line along e. Im(P-Q) = tau (1-phi) e
///                    is no longer than theta |p-Q|, theta = |tau|/r, so that |T_j w| <= sqrt(1+theta^2)
///                    (1-theta^2)^-2 sup |w| on the points that are reached. r is Lipschitz: theta =
///                    b/sqrt(r^2 - a^2) holds on the ellipse, r taken at its middle
///           turn     where Q_j touches the side of the sector: P = x + t g, x on the side and t complex, |t|
///                    |g| <= R with |arg t| <= pi/2, and Q turns about x to x + e^(i alpha) (Q-x), alpha =
///                    arg t for |Q-x| <= k R, falling to 0 with log|Q-x| at the distance r, up to which Q_j
///                    has no side of an element but the one along the edge (Stokes: the border moves in the
///                    complex line of the edge, on which the form vanishes). Both scalar products keep their
///                    moduli; up to k R so does P-Q, and beyond |(P-Q)^2| is at least ((k-1)/(k+1))^2 of its
///                    value at |t|, where the mass of what is further than (k-1) R is at most 2/(k-1): |T_j
///                    w| <= (1 + 2/(k-1) ((k+1)/(k-1))^4 (1 + (pi/2 / log(r/(k R)))^2)^(1/2)) sup |w| on the
///                    points that are reached
///           closure  at an edge, Q_j on its other side: T 1 = 1 on a closed surface, so that T w(P) = F(P) +
///                    T_j(w - xi)(P), F = sum over i != j of T_i w + xi (1 - sum over i != j of T_i 1), xi(s)
///                    = w on Q_j at the point x of the edge that belongs to P = P(s,t). F is smooth up to the
///                    edge. For |P-x| <= R, P at most H above the plane of Q_j, what is further than r from P
///                    has the mass m H/r at most, and |w - xi| <= l |Q-x| up to the distance d of the other
///                    sides of the element: |T_j(w - xi)| <= 3 l R + sum_k m H/(2^k R) l (2^(k+1) + 1) R + 2
///                    sup|w| m H/(d - R)
///           With |f| <= M there, a polynomial of degree n - 1 is off by 2 M rho^(1-n)/(rho-1) (Trefethen,
///           theorem 8.2), and a rule of n nodes by (2 + 2/(4n^2-1)) M rho^(-2n)/(1-rho^-2) of the mean
/// Source    N. Trefethen, "Approximation Theory and Approximation Practice"; the moved paths and the
///           closure: ours
/// Requires  the scene, the elements and the functions outlive it; w and q have the same degree and count
/// Result    rounded up; infinite where an edge is touched
class Smoothness {
public:
  Smoothness(const SectorScene& scene, std::span<const SectorElement> elements, const SectorFunctions& w,
             const SectorFunctions& q);

  [[nodiscard]] RuleErrors along_s(std::size_t element, const SectorBox& box) const;
  [[nodiscard]] RuleErrors along_t(std::size_t element, const SectorBox& box) const;
  /// The element on the other side of the edge along an element, where that is known to be of its width.
  [[nodiscard]] std::optional<std::size_t> mirror(std::size_t element) const { return mirror_[element]; }
  /// The same for F of the closure; the element has a mirror.
  [[nodiscard]] RuleErrors along_s_closed(std::size_t element, const SectorBox& box) const;
  [[nodiscard]] RuleErrors along_t_closed(std::size_t element, const SectorBox& box) const;
  /// A bound of |T_j(w - xi)| on a part of an element with a mirror that touches the edge, and d.
  struct Nearby {
    double bound = 0;
    double distance = 0;
  };
  [[nodiscard]] Nearby nearby(std::size_t element, const SectorBox& box) const;
  /// A bound of |w| and of |T w - q| on an element.
  [[nodiscard]] double density_size(std::size_t element) const { return w_size_[element]; }
  [[nodiscard]] double residual_size(std::size_t element) const { return size_ + q_size_[element]; }
  [[nodiscard]] double size() const { return size_; }
  /// Of |T w - q| on all elements; it bounds |E| + rho |q| within a factor of 2 as well.
  [[nodiscard]] double largest_residual() const { return 2 * size_ + 2 * largest_q_; }

private:
  struct Side {
    Vector<double> from;
    Vector<double> to;
  };
  struct Line;
  [[nodiscard]] double reach_of_turn(std::size_t sector, const Vector<double>& from,
                                     const Vector<double>& to) const;
  void prepare_edges(const SectorFunctions& w);
  [[nodiscard]] Line line_s(std::size_t element, const SectorBox& box) const;
  [[nodiscard]] Line line_t(std::size_t element, const SectorBox& box) const;
  [[nodiscard]] RuleErrors along(std::size_t element, const Line& line, bool closed) const;

  const SectorScene& scene_;
  std::span<const SectorElement> elements_;
  std::vector<PolynomialSizes> w_sizes_;
  std::vector<PolynomialSizes> q_sizes_;
  std::vector<double> w_size_;  ///< of each element
  std::vector<double> q_size_;
  std::vector<double> panel_size_;         ///< sup |w|
  std::vector<double> slid_size_;          ///< the same where Q has moved
  std::vector<std::vector<Side>> sides_;   ///< by sector, panel: those not parallel to the sector's side
  std::vector<std::vector<Side>> around_;  ///< by sector, its opposite's panel: those not on the common edge
  std::vector<double> turned_size_;        ///< by sector: sup |w| where Q has turned about its side
  std::vector<std::optional<std::size_t>> mirror_;  ///< of each element
  std::vector<std::vector<double>> edge_sizes_;  ///< of each element at an edge: of w there, by powers of s
  std::vector<double> lipschitz_;                ///< of w on each element at an edge
  double size_ = 0;
  double largest_q_ = 0;
  double lowest_layer_ = 1;  ///< the least depth of elements at edges
};

/// A part of an element, and the rule of its observers.
struct ObserverCell {
  std::size_t element = 0;
  SectorBox box;
  int nodes_s = 0;  ///< 0: so small that it is not looked into
  int nodes_t = 0;
  bool closed = false;       ///< at an edge: T w = F + what is in the bounds below
  double interpolation = 0;  ///< the sum of both variables' RuleErrors
  double quadrature = 0;
  [[nodiscard]] bool is_strip() const { return nodes_s == 0; }
};

/// What a cell X may contribute.
/// Maths     interpolation: e sqrt|X|; quadrature: |X| times the bound for the mean. A cell that is not
///           looked into contributes sup|T w - q| sqrt|X| and |X| sup|w| sup|T w - q|
struct CellDemand {
  double interpolation = 0;
  double quadrature = 0;
};

/// Cells with rules that meet a demand.
/// Maths     an element is cut until rules of most_gauss_nodes or fewer do, or none is needed; a part that
///           touches its edge of the polyhedron is cut at a quarter of its depth
/// Result    by element; deterministic
[[nodiscard]] std::vector<ObserverCell> observer_cells(const SectorScene& scene,
                                                       std::span<const SectorElement> elements,
                                                       const Smoothness& smoothness,
                                                       const CellDemand& demand);

}  // namespace radcert
