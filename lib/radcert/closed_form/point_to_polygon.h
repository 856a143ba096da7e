// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "radcert/core/outcome.h"
#include "radcert/core/work_limit.h"
#include "radcert/geometry/plane_polygon.h"
#include "radcert/geometry/vector.h"
#include "radcert/polynomial/plane_polynomial.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/mpfr_real.h"
#include "radcert/scalar/rational.h"
#include "radcert/scalar/real.h"

namespace radcert {

/// Of point_to_polygon_within, unless a caller says otherwise.
extern const WorkLimit most_bits_of_a_point;

/// How the part of a polygon behind the tangent plane of P is counted.
enum class BehindTangentPlane {
  left_out,  ///< as in the radiosity equation: P does not see it
  counted,   ///< with the negative sign that the kernel has there
};

/// The radiosity kernel times a polynomial, integrated over a plane polygon, in closed form.
/// Maths     Int G(P,Q) q(Q) dS_Q,  G = [(Q-P).n_P] [(P-Q).n_Q] / |P-Q|^4, n_Q the polygon's inner normal of
///           unit length, n_P = normal / |normal|, q a polynomial in the polygon's parameters (s,t); without
///           1/pi. Negative where P lies behind the polygon
/// Source    KernelMoments; the clipping is Sutherland and Hodgman's, Reentrant polygon clipping, 1974, on
///           every loop: the edges that then run along the cut twice cancel in a line integral
/// Requires  normal != 0; q of degree at most 8; P not on the closed polygon, unless its normal has the
///           direction of the polygon's: else ContractViolation
/// Result    an enclosure at the current precision. Exactly 0 where P lies in the polygon's plane or sees
///           none of it. Which case holds (foot on an edge's line, on a corner, outside; cut or not) is
///           decided exactly
/// Limits    nothing stands between P and the polygon. About (degree + 2) log2(D / size) bits are lost where
///           the polygon is small against its distance D from P, and as many as its height over the plane has
///           zeros
[[nodiscard]] Ball point_to_polygon(const Vector<Rational>& p, const Vector<Rational>& normal,
                                    const PlanePolygon& polygon, const PlanePolynomial<Rational>& q,
                                    BehindTangentPlane behind = BehindTangentPlane::left_out);

/// The same with a demanded radius.
/// Maths     |integral - midpoint| <= radius
/// Source    at_raised_precision
/// Requires  radius > 0, and as point_to_polygon
/// Result    a ball of at most that radius; refused if most_bits do not suffice
/// Limits    as point_to_polygon
[[nodiscard]] Outcome<Ball> point_to_polygon_within(const Rational& radius, const Vector<Rational>& p,
                                                    const Vector<Rational>& normal,
                                                    const PlanePolygon& polygon,
                                                    const PlanePolynomial<Rational>& q,
                                                    BehindTangentPlane behind = BehindTangentPlane::left_out,
                                                    long most_bits = most_bits_of_a_point.value());

/// The same for all monomials at once.
/// Maths     Int G s^i t^j dS, i + j <= degree, in the order of PlanePolynomial's coefficients
/// Source    KernelMoments
/// Requires  0 <= degree <= 8, and as point_to_polygon
/// Result    R = Ball: enclosed; double, Mpfr<50>: the same formula rounded at every step, the geometry
///           decided exactly
/// Limits    as point_to_polygon; compiled for double, Mpfr<50> and Ball. PlaneElement has doubles with a
///           bounded error
template <Real R>
[[nodiscard]] std::vector<R> point_to_polygon_moments(
    const Vector<Rational>& p, const Vector<Rational>& normal, const PlanePolygon& polygon, int degree,
    BehindTangentPlane behind = BehindTangentPlane::left_out);

extern template std::vector<double> point_to_polygon_moments<double>(const Vector<Rational>&,
                                                                     const Vector<Rational>&,
                                                                     const PlanePolygon&, int,
                                                                     BehindTangentPlane);
extern template std::vector<Mpfr<50>> point_to_polygon_moments<Mpfr<50>>(const Vector<Rational>&,
                                                                         const Vector<Rational>&,
                                                                         const PlanePolygon&, int,
                                                                         BehindTangentPlane);
extern template std::vector<Ball> point_to_polygon_moments<Ball>(const Vector<Rational>&,
                                                                 const Vector<Rational>&, const PlanePolygon&,
                                                                 int, BehindTangentPlane);

}  // namespace radcert
