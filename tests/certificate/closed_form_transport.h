// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "radcert/certificate/polyhedron_certificate.h"
#include "radcert/closed_form/point_to_polygon.h"
#include "radcert/geometry/vector.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/rational.h"

namespace radcert::certificate::test {

/// A point of a side's triangle.
inline Vector<Rational> point_of(const PolyhedronCertificate& c, std::size_t face, std::size_t side,
                                 const Rational& s, const Rational& t) {
  const std::vector<Vector<Rational>>& p = c.faces[face].corners;
  Vector<Rational> sum;
  for (const Vector<Rational>& corner : p) sum = sum + corner;
  const Vector<Rational> centre = Rational(1, static_cast<long>(p.size())) * sum;
  const Vector<Rational>& a = p[side];
  const Vector<Rational>& b = p[(side + 1) % p.size()];
  return a + (s * (Rational(1) - t)) * (b - a) + t * (centre - a);
}

/// T w_k by closed forms, w_k constant on elements.
inline Ball sent(const PolyhedronCertificate& c, std::size_t k, std::size_t face,
                 const Vector<Rational>& at) {
  Ball sum;
  for (std::size_t e = 0; e < c.elements.size(); ++e) {
    const Element& x = c.elements[e];
    if (x.face == face) continue;
    const auto corner = [&](double s, double t) {
      return point_of(c, x.face, x.side, Rational::exactly(s), Rational::exactly(t));
    };
    std::vector<Vector<Rational>> corners{corner(x.s0, x.t0), corner(x.s1, x.t0), corner(x.s1, x.t1)};
    if (x.t1 < 1) corners.push_back(corner(x.s0, x.t1));
    const Face& source = c.faces[x.face];
    Rational w = source.reflectivity * Rational::exactly(c.coefficient(k, e, 0, 0));
    if (k == 0) w += source.emission[0][0];
    if (k > 0 && source.piece == k - 1) w += source.reflectivity;
    const Ball factor = point_to_polygon(at, normal_of(c.faces[face]), plane_polygon(corners).value(),
                                         constant_polynomial(Rational(1)));
    sum += Ball(w) * factor / Ball::pi();
  }
  return sum;
}

}  // namespace radcert::certificate::test
