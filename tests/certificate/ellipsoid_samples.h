// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <string>
#include <vector>

#include "radcert/certificate/ellipsoid/ellipsoid_check.h"
#include "radcert/expression/parse.h"
#include "radcert/study/guarantee/ellipsoid_certificate.h"
#include "tests/scalar/draw.h"

namespace radcert::test {

using ComplexPoint = std::array<std::complex<double>, 3>;

/// A complex point of the sphere whose imaginary part is turned by an angle.
struct TurnedPoint {
  Vector<double> real;       ///< of unit length
  Vector<double> imaginary;  ///< of unit length, across it
  [[nodiscard]] ComplexPoint at(double s) const {
    const auto part = [&](double x, double y) {
      return std::complex<double>(std::cosh(s) * x, std::sinh(s) * y);
    };
    return {part(real.x, imaginary.x), part(real.y, imaginary.y), part(real.z, imaginary.z)};
  }
};

inline Vector<double> drawn_direction(Draw& draw) {
  for (;;) {
    const Vector<double> v{2 * draw.unit() - 1, 2 * draw.unit() - 1, 2 * draw.unit() - 1};
    const double size = norm(v);
    if (size > 0.1 && size <= 1) return (1 / size) * v;
  }
}

inline TurnedPoint drawn_turned(Draw& draw) {
  const Vector<double> x = drawn_direction(draw);
  const Vector<double> across = cross(x, drawn_direction(draw));
  return {x, (1 / norm(across)) * across};
}

inline std::complex<double> dot_of(const ComplexPoint& a, const ComplexPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
/// s with |p|^2 = cosh 2s, of p.p = 1.
inline double angle_of(const ComplexPoint& p) {
  const double squared = std::norm(p[0]) + std::norm(p[1]) + std::norm(p[2]);
  return 0.5 * std::acosh(std::max(1.0, squared));
}

inline std::complex<double> power_of(const std::complex<double>& x, int n) {
  std::complex<double> out = 1;
  for (int k = 0; k < n; ++k) out *= x;
  return out;
}

/// T_k(z).
inline std::complex<double> chebyshev(int k, const std::complex<double>& z) {
  std::complex<double> before = 1;
  std::complex<double> now = z;
  if (k == 0) return before;
  for (int j = 1; j < k; ++j) {
    const std::complex<double> next = 2.0 * z * now - before;
    before = now;
    now = next;
  }
  return now;
}

/// q of a certificate at a complex point of the sphere.
inline std::complex<double> q_at(const certificate::EllipsoidCertificate& c, const ComplexPoint& p) {
  const std::complex<double> i(0, 1);
  std::complex<double> sum = 0;
  std::size_t place = 0;
  for (int m = 0; m <= c.degree; ++m) {
    const std::complex<double> one = power_of(p[0] + i * p[1], m);
    const std::complex<double> other = power_of(p[0] - i * p[1], m);
    for (int k = 0; m + k <= c.degree; ++k, ++place)
      sum += (c.cosines[place] * 0.5 * (one + other) - c.sines[place] * 0.5 * i * (one - other)) *
             chebyshev(k, p[2]);
  }
  return sum;
}

/// f(A p).
inline std::complex<double> polynomial_at(const std::vector<certificate::Monomial>& f,
                                          const Vector<Rational>& axes, const ComplexPoint& p) {
  std::complex<double> sum = 0;
  for (const certificate::Monomial& x : f)
    sum += x.coefficient.to_double() * power_of(axes.x.to_double() * p[0], x.powers[0]) *
           power_of(axes.y.to_double() * p[1], x.powers[1]) *
           power_of(axes.z.to_double() * p[2], x.powers[2]);
  return sum;
}

inline std::complex<double> w_at(const certificate::EllipsoidCertificate& c, const ComplexPoint& p) {
  return polynomial_at(c.emission, c.half_axes, p) +
         polynomial_at(c.reflectivity, c.half_axes, p) * q_at(c, p);
}

/// An ellipsoid with random polynomials; nothing is claimed.
inline certificate::EllipsoidCertificate drawn_ellipsoid(Draw& draw, int degree) {
  certificate::EllipsoidCertificate c;
  const auto axis = [&] { return Rational(100 + static_cast<long>(draw.below(80)), 100); };
  c.half_axes = {axis(), axis(), axis()};
  const auto number = [&] { return Rational(static_cast<long>(draw.below(200)) - 100, 100); };
  c.reflectivity = {{{0, 0, 0}, Rational(1, 2)}, {{1, 0, 0}, number() / Rational(5)}};
  c.emission = {{{0, 0, 0}, number()}, {{2, 1, 0}, number()}, {{0, 0, 3}, number()}, {{1, 1, 1}, number()}};
  c.degree = degree;
  for (int m = 0; m <= degree; ++m)
    for (int k = 0; m + k <= degree; ++k) {
      const double size = std::ldexp(1.0, -(m + k));
      c.cosines.push_back(size * (2 * draw.unit() - 1));
      c.sines.push_back(size * (2 * draw.unit() - 1));
    }
  return c;
}

/// What the search makes of a problem, as a certificate.
inline certificate::EllipsoidCertificate certified_ellipsoid(
    const Vector<Rational>& axes, const std::string& rho, const std::string& emission, double wanted,
    certificate::OnEllipsoid of, const std::vector<Vector<Rational>>& points = {}) {
  const EllipsoidProblem problem{.half_axes = axes,
                                 .reflectivity = parse_expression(rho).value(),
                                 .emission = parse_expression(emission).value()};
  const EllipsoidEnclosure found = enclose_on_ellipsoid(problem, wanted).value();
  return ellipsoid_certificate(problem, found, "ellipsoid", of, points);
}

/// A furnace whose residual is known: rho and E = 1 - rho are constant, q = 1 - d - e Re zeta^m, on the
/// sphere.
/// Maths     w = 1 - rho d - rho e Re zeta^m. On any ellipsoid, e = 0: t = (1 - rho) d. On the sphere T w is
///           the mean of w, so that t = (1 - rho) d + e Re zeta^m, sup |t| = (1 - rho) d + e. u = 1; the
///           claim is `claimed`
inline certificate::EllipsoidCertificate furnace_ellipsoid(const Vector<Rational>& axes, const Rational& rho,
                                                           double d, double e, int m, double claimed,
                                                           certificate::OnEllipsoid of) {
  certificate::EllipsoidCertificate c;
  c.piece = "ellipsoid";
  c.half_axes = axes;
  c.reflectivity = {{{0, 0, 0}, rho}};
  c.emission = {{{0, 0, 0}, Rational(1) - rho}};
  c.of = of;
  if (of == certificate::OnEllipsoid::values) c.points = {{0, axes.y, 0}, {-axes.x, 0, 0}};
  c.degree = m;
  c.cosines.assign(certificate::EllipsoidCertificate::count(m), 0);
  c.sines = c.cosines;
  c.cosines[0] = 1 - d;
  if (m > 0) c.cosines.back() = -e;
  c.largest_reflectivity = rho;
  c.residual = claimed;
  c.bound = rho * Rational::exactly(claimed) / (Rational(1) - rho);
  for (const Ball& number : certificate::enclosed(c)) {
    const double midpoint = number.to_double();
    const double radius = abs(number - Ball(midpoint)).upper_double() * (1 + 0x1p-20) + 0x1p-50;
    c.enclosures.push_back({Rational::exactly(midpoint), Rational::exactly(radius)});
    c.width = std::max(c.width, Rational(2) * c.enclosures.back().radius);
  }
  if (of == certificate::OnEllipsoid::function) c.width = Rational(2) * c.bound;
  return c;
}

}  // namespace radcert::test
