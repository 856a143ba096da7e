// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "radcert/certificate/polyhedron_certificate.h"
#include "radcert/scalar/rational.h"

namespace radcert::certificate {

/// The value at (x, y) of a polynomial of a face, f[i][j] the coefficient of x^i y^j.
template <class R>
[[nodiscard]] R polynomial_value(const std::vector<std::vector<R>>& f, const R& x, const R& y) {
  R sum(0);
  for (std::size_t i = f.size(); i-- > 0;) {
    R inner(0);
    for (std::size_t j = f[i].size(); j-- > 0;) inner = inner * y + f[i][j];
    sum = sum * x + inner;
  }
  return sum;
}

/// The degree of rho on a face, and rho at a point of its plane.
[[nodiscard]] int reflectivity_degree(const Face& face);
[[nodiscard]] Rational reflectivity_at(const Face& face, const Vector<Rational>& point);

/// Whether a polynomial of a face lies from 0 to a bound on the face.
/// Maths     on the triangle of each side, in its parameters s and t (Element), f is a polynomial of its
///           degree d in either, f = sum b_ij B_i(s) B_j(t), B Bernstein's polynomials, which are not
///           negative and have the sum 1, so that f lies between the least and the largest b_ij; at corners
///           of the square it is one of them. Squares are halved, in the one parameter and the other, until
///           that decides
/// Source    G. Farin, "Curves and Surfaces for CAGD", chapter 16, of tensor products. The search takes
///           triangles
/// Result    exact: true is a proof; false where it does not hold, or was not shown within the limit of work
[[nodiscard]] bool lies_within(const Face& face, const std::vector<std::vector<Rational>>& f,
                               const Rational& bound);

}  // namespace radcert::certificate
