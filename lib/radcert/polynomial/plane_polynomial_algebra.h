// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "radcert/polynomial/plane_polynomial.h"

namespace radcert {

/// c_0 + c_s s + c_t t.
template <Field R>
[[nodiscard]] PlanePolynomial<R> affine_polynomial(const R& c_0, const R& c_s, const R& c_t) {
  PlanePolynomial<R> out(1);
  out(0, 0) = c_0;
  out(1, 0) = c_s;
  out(0, 1) = c_t;
  return out;
}

/// a + factor b.
/// Result    of the larger of both degrees, whatever cancels; exact for exact R, as all that follow
template <Field R>
[[nodiscard]] PlanePolynomial<R> sum(const PlanePolynomial<R>& a, const R& factor,
                                     const PlanePolynomial<R>& b) {
  PlanePolynomial<R> out(std::max(a.degree(), b.degree()));
  for (int i = 0; i <= out.degree(); ++i)
    for (int j = 0; i + j <= out.degree(); ++j) {
      if (i + j <= a.degree()) out(i, j) += a(i, j);
      if (i + j <= b.degree()) out(i, j) += factor * b(i, j);
    }
  return out;
}

/// a b.
template <Field R>
[[nodiscard]] PlanePolynomial<R> product(const PlanePolynomial<R>& a, const PlanePolynomial<R>& b) {
  PlanePolynomial<R> out(a.degree() + b.degree());
  for (int i = 0; i <= a.degree(); ++i)
    for (int j = 0; i + j <= a.degree(); ++j)
      for (int k = 0; k <= b.degree(); ++k)
        for (int l = 0; k + l <= b.degree(); ++l) out(i + k, j + l) += a(i, j) * b(k, l);
  return out;
}

/// p(x, y), x and y polynomials themselves.
/// Maths     by Horner's rule in either variable
template <Field R>
[[nodiscard]] PlanePolynomial<R> composed(const PlanePolynomial<R>& p, const PlanePolynomial<R>& x,
                                          const PlanePolynomial<R>& y) {
  PlanePolynomial<R> out(0);
  for (int i = p.degree(); i >= 0; --i) {
    PlanePolynomial<R> inner(0);
    for (int j = p.degree() - i; j >= 0; --j)
      inner = sum(product(inner, y), R(1), constant_polynomial<R>(p(i, j)));
    out = sum(product(out, x), R(1), inner);
  }
  return out;
}

}  // namespace radcert
