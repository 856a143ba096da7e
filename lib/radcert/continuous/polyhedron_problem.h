// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "radcert/continuous/elements/graded_elements.h"
#include "radcert/continuous/elements/panel.h"
#include "radcert/continuous/elements/panel_reflectivity.h"
#include "radcert/continuous/elements/sector.h"
#include "radcert/continuous/elements/tensor_legendre.h"
#include "radcert/polynomial/plane_polynomial.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// The radiosity equation u = E + rho T u on a polyhedron.
/// Maths     T u(P) = (1/pi) Int G V u(Q) dS_Q;  rho and E polynomials on each panel, of the parameters of
///           plane_coordinates
/// Source    [ac98, (1)-(2)]
/// Requires  panels of a closed surface; every piece has a panel; 0 <= rho < 1, as reflectivity_of proves it
///           of polynomials; their degree is most_polynomial_degree at most. Either the panels lie in the
///           boundary of a convex body, as convex_panels gives them, and there are no blockers; or they are
///           cut_panels of the blockers, which are convex_panels; with_edges_matched or not
struct PolyhedronProblem {
  std::vector<Panel> panels;
  std::vector<PanelReflectivity> reflectivity;      ///< by panel
  std::vector<PlanePolynomial<Rational>> emission;  ///< by panel
  /// Further emissions, each by panel: what is asked of u is asked of their solutions too.
  std::vector<std::vector<PlanePolynomial<Rational>>> further_emissions = {};
  std::vector<Panel> blockers = {};  ///< the surface again, where parts of it hide each other
};

/// Of E and of rho.
inline constexpr int most_polynomial_degree = 8;

/// A point of a panel.
struct SolutionPoint {
  std::size_t panel = 0;
  Vector<Rational> at;
};

/// The parameters of a point of a panel's plane.
/// Maths     corners[0] + s (corners[1] - corners[0]) + t (corners[2] - corners[0]) = p
/// Result    exact
[[nodiscard]] ParameterPoint<Rational> plane_coordinates(const Panel& panel, const Vector<Rational>& p);

/// The panel inside which a point lies.
/// Result    exact; panels.size() where there is none: the point is off the surface or on an edge
[[nodiscard]] std::size_t panel_inside(const std::vector<Panel>& panels, const Vector<Rational>& p);

/// A panel on which a point lies that has a neighbourhood in the panels of one plane, piece and side, and is
/// on no other panel: where one touches them at the point alone T 1 < 1 there.
/// Maths     from the point a panel fills an angle of their plane; the angles are no more than 2 pi in all,
///           and fill it where each ends at the ray at which another begins
/// Requires  panels that do not overlap
/// Result    exact, the first; panels.size() where there is none: the point is off the surface, on an edge
///           or where another panel touches
[[nodiscard]] std::size_t panel_about(const std::vector<Panel>& panels, const Vector<Rational>& p);

/// Polynomials of the panels' planes, on elements.
/// Maths     a polynomial of degree d on the panel has at most the degree d in each parameter of a sector
/// Requires  a polynomial of plane_coordinates for each panel of the scene; a degree of at least that of each
/// Result    function 0 of `count`, times 2^-exponent; coefficients are those of the exact polynomial to the
///           nearest
[[nodiscard]] SectorFunctions plane_functions(std::span<const PlanePolynomial<Rational>> polynomials,
                                              const SectorScene& scene,
                                              std::span<const SectorElement> elements, std::size_t count,
                                              int degree, int exponent);

/// The emission on elements: its plane_functions.
/// Requires  the scene of the problem's panels
[[nodiscard]] SectorFunctions emission_functions(const PolyhedronProblem& problem, const SectorScene& scene,
                                                 std::span<const SectorElement> elements, std::size_t count,
                                                 int degree, int exponent);

}  // namespace radcert
