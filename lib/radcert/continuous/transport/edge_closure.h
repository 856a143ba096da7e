// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "radcert/continuous/elements/element_side.h"
#include "radcert/continuous/elements/graded_elements.h"
#include "radcert/continuous/elements/sector.h"
#include "radcert/continuous/elements/tensor_legendre.h"

namespace radcert {

/// What the panel beyond an edge sends to observers near the edge, without its singularity.
/// Maths     T 1 = 1 on a closed surface, so that near an edge of Q_j  T w(P) = F(P) + T_j(w - xi)(P),  F =
///           sum over i != j of T_i w + xi (1 - sum over i != j of T_i 1),  xi(s) = w on Q_j at the point x
///           of the edge that belongs to P = P(s,t). F is smooth up to the edge. For |P-x| <= R, P at most H
///           above the plane of Q_j, what is further than q from P has the mass M(q) = min(1, m H/q) at most,
///           m = 2, or 1 where n_P.n_j >= 0, and |w - xi| <= J(Q) + l |Q-x| <= J(Q) + l (R + |Q-P|) up to the
///           distance d from x: |T_j(w - xi)| <= J + l R + l Int_0^(d-R) M dq + 2 sup|w| M(d-R)
///             = J + l (R + m H (1 + log((d-R)/(m H)))) + 2 sup|w| m H/(d-R)
///           Either d is the distance of the other sides of the element beyond, and J = 0; or that of the
///           elements which do not touch it: the way from x to Q crosses each border between those which do
///           once at most, and then |Q-P| >= e - R, e the distance of the border from x. J(Q) is at most the
///           sum of the jumps of w on those that are crossed, and J = sum over all of jump M(e-R)
/// Requires  the scene and the elements outlive it
/// Result    bounds rounded up, infinite where there are none
class EdgeClosure {
public:
  EdgeClosure(const SectorScene& scene, std::span<const SectorElement> elements, const SectorFunctions& w);

  /// The element on the other side of the edge along an element, where that is known to be of its width.
  [[nodiscard]] std::optional<std::size_t> mirror(std::size_t element) const { return mirror_[element]; }
  /// Bounds of xi on the edge of an element that has one, by powers of s: see PolynomialSizes.
  [[nodiscard]] std::span<const double> edge_sizes(std::size_t element) const { return edge_sizes_[element]; }
  /// Of a part of an edge, at most its distance from all sides of elements on the panel beyond, except those
  /// on the edge.
  [[nodiscard]] double clearance(std::size_t sector, const Vector<double>& from,
                                 const Vector<double>& to) const;

  struct Nearby {
    double bound = 0;     ///< of |T_j(w - xi)|
    double jumps = 0;     ///< of J, on borders that the part touches: cutting it takes little of them away
    double distance = 0;  ///< of the middle of the part of the edge from what bounds d
  };
  /// On a part of an element with a mirror that touches the edge, within the element beyond alone, or with
  /// those which touch it.
  [[nodiscard]] Nearby nearby(std::size_t element, const SectorBox& box) const;
  [[nodiscard]] Nearby nearby_across_borders(std::size_t element, const SectorBox& box) const;

private:
  struct Jump {
    ElementSide border;
    double size = 0;
  };
  /// Elements that touch one, itself among them.
  struct Neighbourhood {
    std::vector<std::size_t> elements;
    double lipschitz = 0;  ///< the largest
    std::vector<Jump> jumps = {};
  };
  [[nodiscard]] double distance_around(std::size_t sector, const Vector<double>& point) const;
  [[nodiscard]] Neighbourhood neighbourhood(std::size_t element, const SectorFunctions& w) const;
  [[nodiscard]] Nearby nearby(std::size_t element, const SectorBox& box, double to_others, double slope,
                              std::span<const Jump> jumps) const;

  const SectorScene& scene_;
  std::span<const SectorElement> elements_;
  std::vector<std::vector<ElementSide>> around_;    ///< by sector, on its opposite's panel
  std::vector<double> beyond_;                      ///< by sector: sup |w| on its opposite's panel
  std::vector<std::optional<std::size_t>> mirror_;  ///< of each element
  std::vector<std::vector<double>> edge_sizes_;
  std::vector<double> lipschitz_;              ///< of w on each element
  std::vector<Neighbourhood> neighbourhoods_;  ///< of each element that is a mirror, else empty
};

}  // namespace radcert
