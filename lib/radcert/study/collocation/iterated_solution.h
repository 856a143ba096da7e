// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "radcert/polynomial/triangle_basis.h"
#include "radcert/study/collocation/level_geometry.h"
#include "radcert/study/study.h"

namespace radcert {

/// E at points, with a radius each; infinite where that is not known.
struct EmissionAtPoints {
  std::vector<double> values;
  std::vector<double> radii;
};

/// The iterated solution at one point of S.
struct IteratedValue {
  Approximation value = Approximation::without_radius(0);
  std::optional<Approximation> error = std::nullopt;  ///< its distance from u, where u is given
  /// The terms of the radius of the value, each an estimate; the radius of the error has the same but for
  /// what rounding may have done to u
  struct Terms {
    double quadrature = 0;  ///< of the integrals in K u_n
    double nodes = 0;       ///< u_n at the nodes within its radius moves K u_n by so much
    double data = 0;        ///< of E, with Ku where u is given, and of rho
    double rounding = 0;    ///< of sums and products
  } terms;
};

/// The iterated solution of a level of collocation, also named after Sloan.
/// Maths     uhat = E + K u_n. From u_n = P_n uhat it has the values of u_n at the nodes, and uhat - u =
///           (I - K P_n)^{-1} K (P_n - I) u: its error is of the order of that at the nodes everywhere
/// Source    I. H. Sloan, Improvement by iteration for compact operator equations, Math. Comp. 30 (1976);
///           [ac98, (41)]; [m06, section 3]
/// Requires  a problem that collocates on an exact geometry; all values of u_n with a radius, or none; what
///           is passed in outlives this
/// Result    K u_n by the integrals of the collocation matrix, taken from P. The radius is the sum of its
///           terms: with g_j = Int G V l_j from P, known within d_j, and |u_j - exact| <= r at all nodes,
///             quadrature  rho/pi sum d_j |u_j|
///             nodes       rho/pi r sum (|g_j| + d_j)
///             data        the radius of E at P, and of rho times |Int G V u_n|/pi
///             rounding    (n + 8) u (|E| + rho/pi sum |g_j u_j|) for n terms, u the unit roundoff
///           The error is |K u_n - K u|, without the difference of numbers near to u
/// Limits    estimates, since d_j and the radius of Ku are. Without a radius of u_n or of the data there is
///           none. P not on an edge at which pieces meet at an angle: there E + K u_n has no one value
class IteratedSolution {
public:
  IteratedSolution(const Problem& problem, const NodedSurface& level, const TriangleBasis<double>& basis,
                   std::span<const Approximation> u_n, const OperatorRoute& route);

  [[nodiscard]] std::vector<IteratedValue> at(std::span<const CollocationPoint<double>> points) const;
  /// The same where E is known at the points already.
  [[nodiscard]] std::vector<IteratedValue> at(std::span<const CollocationPoint<double>> points,
                                              const EmissionAtPoints& emission) const;
  /// E at points, where u is given by the second route to Ku.
  [[nodiscard]] EmissionAtPoints emission(std::span<const CollocationPoint<double>> points) const;

private:
  const Problem& problem_;
  const NodedSurface& level_;
  const TriangleBasis<double>& basis_;
  std::vector<double> u_n_;
  double node_radius_ = 0;  ///< the largest; infinite where it is not known
  const OperatorRoute& route_;
};

/// u_n at a point of an element, by its values at the nodes.
/// Maths     sum u_j l_j(x)
/// Result    the radius is sum |l_j| times that of the nodes, and a few roundings a term and of coordinates
[[nodiscard]] Approximation value_in_element(const TriangleBasis<double>& basis,
                                             std::span<const Approximation> of_element, double largest,
                                             const Barycentric<double>& x);

/// Where the iterated solution is looked at on every element: six points, inside, and no node of the families
/// that radcert has.
/// Maths     x = (9/11, 1/11, 1/11) and (1/13, 6/13, 6/13) with their permutations; a rule of degree 2
/// Source    ours
[[nodiscard]] std::vector<Barycentric<Rational>> check_points();

/// The points of S that belong to the check points, element by element.
[[nodiscard]] std::vector<CollocationPoint<double>> check_points_of(const NodedSurface& level);

/// Whether a point is on the border of a chart where the charts of the surface may meet at an angle, up to
/// rounding: there E + K u_n has no one value.
[[nodiscard]] bool lies_on_edge(const Surface& surface, const SurfacePoint<double>& p);

/// The iterated solution of a finished level: its report, and its values at the corners of the elements, for
/// pictures.
/// Maths     maxima over the check points of |u - uhat|, |u - u_n| and |uhat - u_n|, and over the nodes of
///           |u - uhat|; at the corners uhat, and on an edge, where it has no one value, the polynomial of
///           degree 2 through its values at the check points of the element
/// Requires  as IteratedSolution; `outcome` is of this level, its nodes and elements are described;
///           `emission` is E at the nodes
/// Result    fills these fields of the outcome and no others
/// Limits    maxima over a sample are lower bounds of the supremum. Values at corners have no radius
void describe_iterated(const Problem& problem, const NodedSurface& level, const TriangleBasis<double>& basis,
                       const EmissionAtPoints& emission, const OperatorRoute& route, LevelOutcome& outcome);

}  // namespace radcert
