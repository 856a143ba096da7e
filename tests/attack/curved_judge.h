// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "radcert/scalar/ball.h"
#include "radcert/scalar/complex_ball.h"
#include "radcert/surface/surface.h"
#include "radcert/surface/surface_point.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert::attack {

/// A polynomial in the first two barycentric coordinates of an element.
/// Maths     sum_k coefficient_k x_1^first_k x_2^second_k
struct ElementPolynomial {
  struct Term {
    Rational coefficient;
    int first = 0;
    int second = 0;
  };
  std::vector<Term> terms;
};

/// The polynomials of a degree that are 1 at one of the points (x_1, x_2) and 0 at the others.
std::vector<ElementPolynomial> judged_lagrange(const std::vector<std::array<Rational, 2>>& points,
                                               int degree);

/// A piece of a surface by a formula of this file's own, in balls.
/// Maths     F(s,t); quadrics q(F(s,t)) = 0 with D_s F x D_t F = +- m grad q
/// Source    the catalogue's headers say which maps the charts are; the implicit forms are written down here.
///           A polynomial piece is interpolated from the chart's values on a lattice
struct JudgedPatch {
  enum class Kind { octant, paraboloid, cap, mantle, disk, polynomial };
  Kind kind = Kind::polynomial;
  /// Half axes with signs; radius, growth, height; the cap's fraction; radius, height
  std::array<Ball, 3> size{};
  /// Of an octant: the half axes' inverse squares; of a mantle: growth / height
  std::array<Ball, 3> inverse{};
  std::array<int, 2> sign{1, 1};  ///< of x and y
  int facing = 1;                 ///< of a disk: the sign of the inner normal's third coordinate
  int degree = 0;                 ///< of a polynomial
  bool against = false;           ///< whether a polynomial's inner normal is that against the cross product
  std::vector<std::array<Ball, 3>> coefficients;  ///< of s^i t^j, i ascending, then j
};

/// The patches of a surface of the catalogue, chart by chart; of interpolants of a degree, where that is not
/// 0. None for surfaces that this file has no formula of.
std::vector<JudgedPatch> judged_patches(const Surface& surface, int interpolated);

/// Integrals of the kernel times polynomials over an element, proved with many digits.
/// Maths     Int_Delta G(P,Q) f_j(Q) dS_Q
/// Source    on one quadric grad q(P).(Q-P) = -A(Q-P) and grad q(Q).(Q-P) = A(Q-P), A the quadratic part of
///           q, so that
///             G dS = m (A(d)/|d|^2)^2 / |grad q(P)| ds dt,   d = Q - P,
///           where d may be divided by any number: on the element of P by the step along a ray from P. On a
///           polynomial piece the same is done with Taylor's coefficients at P. Elsewhere the kernel's
///           definition. Product Gauss rules on halved squares; the error is Trefethen's 64/15 M rho^(-2n) /
///           (1 - rho^-2) for |f| <= M on Bernstein's ellipse, M from the formula over a rectangle of complex
///           numbers (L. N. Trefethen, Is Gauss quadrature better than Clenshaw-Curtis?, 2008, theorem 4.5)
/// Requires  parameters that are exact; P on no border of an element of another patch
/// Result    the integrals within balls. None where too many values would have been needed
std::optional<std::vector<Ball>> judged_integrals(const std::vector<JudgedPatch>& patches,
                                                  const SurfacePoint<Rational>& p,
                                                  const ParameterTriangle& element,
                                                  const std::vector<ElementPolynomial>& functions);

}  // namespace radcert::attack
