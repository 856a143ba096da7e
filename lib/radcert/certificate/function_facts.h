// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "radcert/certificate/polyhedron_certificate.h"
#include "radcert/scalar/ball.h"

namespace radcert::certificate {

/// T 1_B(a), B(a) the points of the surface within a of a corner of a face.
/// Maths     rays from P that end within a of a vertex V, whatever they pass, have directions in the cone of
///           the ball of radius a about V, D = |P-V|, sin alpha = a/D, so that Int cos/pi over the cone
///           before the face of P bounds what they bring. V in the plane of P: half of the cone, which
///           orthogonal projection takes to the part x >= cos alpha of the unit disk: phi(a/D) = (alpha - sin
///           alpha cos alpha)/pi, 1/2 for a = D; where a > D P is in the ball, rays of all directions may end
///           there, and phi = 1. V not in it, at the height H: D >= H, and of all sets of directions of that
///           size the cone about the normal has the largest integral: sin^2 alpha <= (a/H)^2. One vertex at
///           most is nearer to P than half the least distance h of two vertices, so that in a plane with n of
///           them P at the distance d or more from all gets phi(a/d) + (n-1) phi(2a/max(2d,h)) at most, and
///           sum (a/H)^2
/// Requires  surface_fault found nothing
class VertexMass {
public:
  explicit VertexMass(const PolyhedronCertificate& certificate);
  /// sup T 1_B(radius) at points that are `distance` or more from every corner.
  /// Requires  0 <= radius, 0 < distance
  /// Result    an upper bound, at most 1
  [[nodiscard]] Ball operator()(const Rational& radius, const Rational& distance) const;

private:
  struct AtPlane {
    int vertices = 0;          ///< n
    Rational inverse_squares;  ///< sum 1/H^2
  };
  std::vector<AtPlane> planes_;  ///< by face
  Rational least_square_;        ///< h^2
};

/// Whether the stated bounds of |u - w_0| follow from the claims.
/// Maths     shell m: the points at least r_m from every corner, r_m the distances, descending to 0, and less
///           than r_(m-1); Y_m the stated bounds, ascending; R_m the largest claim on elements with a point
///           that is r_m or more from every corner, which the point of an element that is farthest from a
///           corner decides: one of the element's own corners. e = |u - w_0| <= R + K e, K = rho T, and Y >=
///           R + K Y makes Y >= sum_(j<N) K^j R + K^N Y for all N, so that Y >= sum K^j R >= e. With s = max
///           rho, K Y <= s (Y_0 + sum_(k>0) (Y_k - Y_(k-1)) T 1_B(r_(k-1))), on shell m by VertexMass at the
///           distance r_m, 1 for k <= m. On borders of elements w_0 is meant as a limit from either side
/// Source    ordered positive operators: L. Collatz, "Functional Analysis and Numerical Mathematics", 1966
/// Requires  a certificate of a function, surface_fault, reflectivity_fault, tiling_fault found nothing
/// Result    proved in balls; nothing where all of it holds and the width is twice the bound at `outside`
[[nodiscard]] std::optional<Refusal> function_fault(const PolyhedronCertificate& certificate);

/// The least bounds Y at the certificate's distances that function_fault lets pass, or a little more.
/// Maths     Y_m = R_n/(1-s) for all m, then R + s (...) of the one before, each again Y >= R + K Y
/// Requires  as function_fault, whatever bounds are stated
/// Result    finite, short decimals
[[nodiscard]] std::vector<Rational> bounds_by_distance(const PolyhedronCertificate& certificate);

}  // namespace radcert::certificate
