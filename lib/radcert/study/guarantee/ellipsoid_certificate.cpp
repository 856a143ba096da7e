// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/guarantee/ellipsoid_certificate.h"

#include <algorithm>
#include <cmath>

#include "radcert/certificate/ellipsoid/ellipsoid_check.h"
#include "radcert/core/errors.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert {
namespace {

std::vector<certificate::Monomial> monomials(const Expression& f) {
  std::vector<certificate::Monomial> out;
  for (const auto& [powers, coefficient] : space_polynomial(f).value()) out.push_back({powers, coefficient});
  return out;
}

/// A bound as a short decimal, rounded up.
Rational short_bound(double x) {
  constexpr int digits = 4;
  return x == 0 ? Rational(0) : Rational::parse(upper_text(x, DecimalForm::general(digits))).value();
}

/// As a decimal that reads back as a double, rounded up.
Rational upper(const Rational& x) { return Rational::parse(upper_text(x, DecimalForm::general(12))).value(); }

}  // namespace

certificate::EllipsoidCertificate ellipsoid_certificate(const EllipsoidProblem& problem,
                                                        const EllipsoidEnclosure& found,
                                                        const std::string& piece, certificate::OnEllipsoid of,
                                                        const std::vector<Vector<Rational>>& points) {
  certificate::EllipsoidCertificate out;
  out.piece = piece;
  out.half_axes = problem.half_axes;
  out.reflectivity = monomials(problem.reflectivity);
  out.emission = monomials(problem.emission);
  out.of = of;
  out.points = points;
  const SpherePolynomial& q = found.v.reflected;
  out.degree = q.degree();
  for (int m = 0; m <= q.degree(); ++m)
    for (int k = 0; m + k <= q.degree(); ++k) {
      const auto [cosine, sine] = q.coefficients(m, k);
      out.cosines.push_back(cosine);
      out.sines.push_back(sine);
    }
  const ReflectivityBound rho = reflectivity_bound(problem).value();
  const std::optional<Rational> constant = problem.reflectivity.is_constant();
  // A polynomial's a little wider: a check sees it at other points.
  const double more = std::min(5e-4 * rho.largest, 0.01 * rho.gap);
  out.largest_reflectivity = constant ? abs(*constant) : upper(Rational::exactly(rho.largest + more));
  if (rho.largest > 0) {
    const double residual = found.bound * rho.gap / rho.largest;
    // T (rho q) - q moves by less than twice what q does.
    out.residual = 1.1 * residual + 2 * q.rounding();
    out.residual += certificate::room_for_check(out);
    out.residual = short_bound(out.residual).to_double();
  }
  const Rational& s = out.largest_reflectivity;
  out.bound = s.sign() == 0 ? Rational(0) : upper(s * Rational::exactly(out.residual) / (Rational(1) - s));
  Rational radius = out.bound;
  for (const Ball& number : certificate::enclosed(out)) {
    // Wider, so that both may be rounded to the decimals that read back as the same doubles.
    if (!std::isfinite(number.radius()))
      throw AccuracyNotReached("a certificate", "too many nodes would integrate over the ellipsoid");
    const double midpoint = number.to_double();
    const double own =
        abs(number - Ball(midpoint)).upper_double() * (1 + 0x1p-24) + std::abs(midpoint) * 0x1p-50;
    out.enclosures.push_back({Rational::exactly(midpoint), Rational::exactly(own)});
    radius = out.enclosures.size() == 1 ? out.enclosures.back().radius
                                        : std::max(radius, out.enclosures.back().radius);
  }
  out.width = upper(Rational(2) * radius * Rational::exactly(1 + 0x1p-40));
  return out;
}

}  // namespace radcert
