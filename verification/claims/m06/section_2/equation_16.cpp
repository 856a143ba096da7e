// SPDX-License-Identifier: GPL-3.0-or-later

// Checked      l_k(q_m) = delta_km for every r >= 1 and every alpha, lattice_functions.h: interpolation
//              takes a polynomial of degree <= r to itself, and the rule is the integral of that. For r = 0
//              to 8 as identities in alpha of the library's rule, which integrates every such polynomial
//              over sigma. (28): an affine m_tau takes P_r to P_r and multiplies integrals by 2 Area, so
//              that the rule with the nodes m_tau(q_j) and the weights 2 Area omega_j does the same over
//              tau; on a scalene and a thin triangle once more, against the integral by Green's theorem, as
//              identities in alpha for every monomial of degree <= r in x and y, r = 1 to 4. At alpha = 1/10
//              and r >= 1 the degree is r and no more.
// Not checked  When the degree is more: alpha_0.

#include "radcert/polynomial/nodes/inset_family.h"
#include "verification/claims/ac98/collocation/differing_coefficients.h"
#include "verification/claims/ac98/surfaces/planar_rule.h"
#include "verification/claims/m06/section_2/lattice_functions.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

using ac98::PlanarPoint;
using ac98::PlanarRule;

struct NamedTriangle {
  std::string name;
  std::vector<PlanarPoint> corners;  ///< counterclockwise
};

std::vector<NamedTriangle> triangles() {
  return {{"sigma", {{0, 0}, {1, 0}, {0, 1}}},
          {"scalene", {{Rational(7, 3), -2}, {5, Rational(9, 4)}, {Rational(-1, 5), 8}}},
          {"thin", {{0, 0}, {1000000, 1}, {1000000, 2}}}};
}

PlanarRule rule_on(const std::vector<PlanarPoint>& tau, const InsetFamily& family, const Rational& alpha) {
  const PlanarPoint& a = tau[0];
  const PlanarPoint& b = tau[1];
  const PlanarPoint& c = tau[2];
  const Rational twice_area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  PlanarRule rule;
  for (std::size_t j = 0; j < family.size(); ++j) {
    const auto node = family.node(j);
    const Rational u = node[0](alpha);
    const Rational t = node[1](alpha);
    const Rational s = node[2](alpha);
    rule.points.push_back({u * a.x + t * b.x + s * c.x, u * a.y + t * b.y + s * c.y});
    rule.weights.push_back(twice_area * family.weight(j)(alpha));
  }
  return rule;
}

// (1 - 3 alpha)^r times the rule of (28) less the integral, for x^a y^b; the weights 2 Area omega_j times
// `factor`.
RationalPolynomial defect_on(const std::vector<PlanarPoint>& tau, const InsetFamily& family, int a, int b,
                             const Rational& factor) {
  const auto pole = [](int n) {
    RationalPolynomial result = 1;
    for (int i = 0; i < n; ++i) result *= 1 - 3 * RationalPolynomial::variable();
    return result;
  };
  const Rational twice_area =
      (tau[1].x - tau[0].x) * (tau[2].y - tau[0].y) - (tau[2].x - tau[0].x) * (tau[1].y - tau[0].y);
  RationalPolynomial rest = -ac98::integral(tau, a, b) * pole(family.degree());
  for (std::size_t j = 0; j < family.size(); ++j) {
    const std::array<RationalPolynomial, 3> q = family.node(j);
    const InsetFunction weight = family.weight(j);
    RationalPolynomial term =
        factor * twice_area * weight.numerator * pole(family.degree() - weight.pole_order);
    for (int i = 0; i < a; ++i) term *= q[0] * tau[0].x + q[1] * tau[1].x + q[2] * tau[2].x;
    for (int i = 0; i < b; ++i) term *= q[0] * tau[0].y + q[1] * tau[1].y + q[2] * tau[2].y;
    rest += term;
  }
  return rest;
}

// Its coefficients that are not zero, all monomials of degree <= r.
Rational coefficients_on(const std::vector<PlanarPoint>& tau, const InsetFamily& family,
                         const Rational& factor) {
  long count = 0;
  for (int a = 0; a <= family.degree(); ++a)
    for (int b = 0; a + b <= family.degree(); ++b) {
      const RationalPolynomial rest = defect_on(tau, family, a, b, factor);
      for (int k = 0; k <= rest.degree(); ++k)
        if (rest.coefficient(static_cast<std::size_t>(k)) != 0) ++count;
    }
  return {count};
}

}  // namespace

Finding equation_16(const Bench&) {
  Finding finding;
  require_delta_at_the_nodes(finding);
  constexpr int largest_degree = 8;
  for (int r = 0; r <= largest_degree; ++r) {
    const InsetFamily family(r);
    const std::string of = ", r = " + std::to_string(r);
    for (int degree = 0; degree <= r; ++degree)
      finding.require("coefficients in alpha of the defects of degree " + std::to_string(degree) + of,
                      IsExactly{0},
                      ac98::differing_coefficients({family.condition(Region::triangle, degree), 0}, {}));
    if (r > 0)
      finding.control("coefficients in alpha of the defects of degree r + 1" + of, IsExactly{0},
                      ac98::differing_coefficients({family.condition(Region::triangle, r + 1), 0}, {}));
  }
  const Rational alpha(1, 10);
  constexpr int largest_on_planes = 4;
  for (int r = 1; r <= largest_on_planes; ++r)
    for (const NamedTriangle& each : triangles()) {
      const std::string of = ", r = " + std::to_string(r) + ", " + each.name;
      finding.require("coefficients in alpha of the rule less the integral, degree <= r" + of, IsExactly{0},
                      coefficients_on(each.corners, InsetFamily(r), 1));
      finding.control("the same with the weights Area omega_j" + of, IsExactly{0},
                      coefficients_on(each.corners, InsetFamily(r), Rational(1, 2)));
      const PlanarRule rule = rule_on(each.corners, InsetFamily(r), alpha);
      finding.require("degree of precision, alpha = 1/10, r = " + std::to_string(r) + ", " + each.name,
                      IsExactly{r}, ac98::precision(rule, each.corners));
      PlanarRule moved = rule;
      moved.weights[0] += Rational(1, 1000);
      finding.control("the same with one weight moved", IsExactly{r}, ac98::precision(moved, each.corners));
    }
  return finding;
}

}  // namespace radcert::verification::m06
