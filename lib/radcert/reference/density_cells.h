// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "radcert/expression/expression.h"
#include "radcert/geometry/vector.h"
#include "radcert/reference/polygon.h"
#include "radcert/surface/surface.h"

namespace radcert::reference {

/// A part of a chart on which a density is nearly a polynomial: no feature of it hides between the points of
/// a rule there.
/// Maths     |u(F(s,t)) - p(F(s,t))| <= deviation for (s,t) in the polygon, p a polynomial of space of degree
///           < 64; |F_i(s,t) - centre_i| <= half_i there; area that of the part on a plane chart, elsewhere
///           that of the polygon times the largest area element at its corners and in its middle
/// Source    see density_cells
/// Result    deviation: infinite where none was proved
struct DensityCell {
  std::size_t chart = 0;
  Polygon polygon{};
  bool is_whole = true;  ///< the domain of its chart
  double deviation = 0;
  double rounding = 0;      ///< what that of coordinates may do to u
  Vector<double> centre{};  ///< of the box
  Vector<double> half{};    ///< of its sides
  double area = 0;
};

/// The charts of a surface cut into cells until a density, given by its formula, is nearly a polynomial on
/// each.
/// Maths     A cell lies in a box c + [-h, h] of space. Where u is analytic and |u| <= M for |X_i - c_i| <= R
///           h_i, R > 1, the Taylor polynomial p of degree < m about c satisfies |u - p| <= M / (R^(m-1) (R -
///           1)) on the box: along each complex line through c Cauchy bounds the coefficients by M / R^k.
///           Where that is worse, or u is not analytic, p is the constant amid the values of u on the box.
///           The cell with the largest deviation times area is halved, by the line for which that is then
///           smallest, until the sum of these is below 2^-44 times that of |u| at the cells' centres
/// Source    ours; Cauchy's estimate
/// Requires  a formula in x, y, z for each chart
/// Result    cells that cover each chart once, in the order of charts, one a chart where u is smooth; the
///           same on every machine. Formulas in ComplexBall show analyticity, in Ball bound values
/// Limits    2000 halvings: what is left are deviations. A chart that is not known in balls, and a formula
///           that is not proved to have values on a cell, have infinite ones
std::vector<DensityCell> density_cells(const Surface& surface, std::span<const Expression> formulas);

/// A bound of the error that the deviation on a cell causes in the integral of G u over it.
/// Maths     (2 deviation + rounding) min(pi, area / d^2), where min(pi, area / d^2) >= Int_cell G(P,Q) dS_Q,
///           d the distance of the cell's box from P: once for the integral, once for what a rule of positive
///           weights gives in its place
/// Source    [ac98, section 2]: Int G dS <= pi over what is seen from P; G <= 1 / |P-Q|^2
/// Result    a bound but for rounding, and for the area of a curved cell
double deviation_at(const DensityCell& cell, const Vector<double>& p);

}  // namespace radcert::reference
