// SPDX-License-Identifier: GPL-3.0-or-later

// Theorems 7 and 9 assume that the integrals over the node's own element have an error O(h^(r+3)),
// O(h^(r+2)). They have O(h^(r+3)) in any case, for every r and alpha: G <= c_1 (lemma_1_a), |u - P_n u| <=
// (1 + norm of P_n) |d|_1^(r+1)/(r+1)! max |D^(r+1) u| by Taylor's formula about the middle of the
// hypotenuse, and the element has the area O(h^2). On the roof of two_piece(2), with legs l, area element <=
// 5^(1/2) and u = exp(2x + y):
//   |Int G (u - P_n u)| <= c_1 5^(1/2) (l^2/2) (1 + norm of P_n) l^(r+1)/(r+1)! 2^(r+1) e^3.
//
// Checked      this bound, with c_1 and the norm enclosed, against the integral itself, enclosed in polar
//              coordinates about the node, where G is smooth: one node of an element at (1/3, 1/5), r = 1 at
//              alpha_0 and r = 2 at alpha = 1/10, l = 2^-2 and 2^-10; the integral against a rule that shares
//              nothing with it, l = 2^-2. Rejected: nodes of degree r - 1, at l = 2^-20; another node.
// Not checked  other surfaces, nodes and u.

#include <cmath>

#include "radcert/enclosure/polygon_integral.h"
#include "radcert/polynomial/inset_basis.h"
#include "radcert/polynomial/lebesgue_constant.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "verification/claims/ac98/surfaces/smooth_bounds.h"
#include "verification/claims/m06/kernel_error.h"
#include "verification/claims/mean_value_bounds.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

using Parameters = ParameterPoint<Rational>;

// The element with the corner (1/3, 1/5) and legs of this length, and nodes on it.
struct Element {
  int r;
  Rational alpha;
  Rational leg;

  [[nodiscard]] Parameters at(const Barycentric<Rational>& x) const {
    return {Rational(1, 3) + leg * x.x[2], Rational(1, 5) + leg * x.x[1]};
  }
  [[nodiscard]] ParameterPolygon corners() const {
    return {at({{1, 0, 0}}), at({{0, 0, 1}}), at({{0, 1, 0}})};
  }
  [[nodiscard]] std::vector<Barycentric<Rational>> nodes() const { return inset_nodes<Rational>(r, alpha); }
};

template <class R>
R solution(const ParameterPoint<R>& at) {
  return exp(R(2) * at.s + at.t);
}

// G J (u - P_n u) at P + x (direction), P the node, over one triangle of the fan about it.
struct Integrand {
  Element element;
  Parameters node;
  SquareMap map;

  template <class R>
  R operator()(const R& x, const R& y) const {
    const SquareMapIn<R> square(map);
    const ParameterPoint<R> direction = square.direction(y);
    const ParameterPoint<R> q = square.point(x, y);
    // (xi - x)^4/[(xi - x)^2 (1 + (x + xi)^2) + (eta - y)^2]^2 over (1 + 4x^2)^(1/2), the step divided out.
    const R c_2 = direction.s * direction.s;
    const R sum = from_rational<R>(2 * node.s) + x * direction.s;
    const R ratio = c_2 / (c_2 * (R(1) + sum * sum) + direction.t * direction.t);
    const R kernel = ratio * ratio / sqrt(from_rational<R>(1 + 4 * node.s * node.s));
    const R leg = from_rational<R>(element.leg);
    const R s = (q.s - from_rational<R>(Rational(1, 3))) / leg;
    const R t = (q.t - from_rational<R>(Rational(1, 5))) / leg;
    const InsetBasis<R> basis(element.r, from_rational<R>(element.alpha));
    std::vector<R> values(basis.size());
    basis.values(Barycentric<R>{{R(1) - s - t, t, s}}, std::span<R>(values));
    R rest = solution(q);
    const std::vector<Barycentric<Rational>> nodes = element.nodes();
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      const Parameters at = element.at(nodes[j]);
      rest -= R(solution(ParameterPoint<Ball>{Ball(at.s), Ball(at.t)})) * values[j];
    }
    return square.jacobian(x) * kernel * rest;
  }
};

// Int G (u - P_n u) over the element from a point in it.
Ball integral(const Element& element, const Parameters& node, double accuracy = 1e-2) {
  std::vector<SquareFunction> functions;
  for (const SquareMap& map : fan(element.corners(), node)) {
    const Integrand f{element, node, map};
    functions.push_back({.in_balls = [f](const Ball& x, const Ball& y) { return f(x, y); },
                         .in_models = [f](const TaylorModel& x, const TaylorModel& y) { return f(x, y); }});
  }
  const double small = accuracy * power(element.leg.to_double(), element.r + 3);
  return known(integral_over_squares(functions, {.radius = small}));
}

// The same by a conical rule that is collapsed at the node and knows the library's charts alone.
Approximation by_a_rule(const Element& element, const Parameters& node) {
  const auto rounded = [](const Parameters& at) {
    return ParameterPoint<double>{at.s.to_double(), at.t.to_double()};
  };
  const ParameterPolygon corners = element.corners();
  // Counterclockwise; the nodes are the same, whichever way their triangle runs.
  const std::vector<ParameterTriangle> own{
      {.chart = 1, .vertices = {rounded(corners[0]), rounded(corners[1]), rounded(corners[2])}}};
  const TriangleBasis<double> basis(InsetBasis<double>(element.r, element.alpha.to_double()));
  return kernel_error(two_piece(2), own, basis,
                      [](const Vector<double>& q) { return std::exp(2 * q.x + q.y); },
                      {.chart = 1, .at = rounded(node)});
}

// c_1 5^(1/2)/2 (1 + norm) 2^(r+1)/(r+1)! e^3, times leg^(r+3).
Ball bound(const Element& element) {
  const int r = element.r;
  const LagrangeFunctions functions = lagrange_functions(element.nodes()).value();
  const Ball norm(lebesgue_constant(functions, Rational(1, 1000)).upper);
  const Ball taylor(taylor_factor(r) * power(Rational(2), r + 1) * power(element.leg, r + 3));
  return ac98::roof_bounds(2, 1e-6).kernel * sqrt(Ball(5)) / Ball(2) * (Ball(1) + norm) * taylor *
         exp(Ball(3));
}

}  // namespace

Finding theorem_7_own_element(const Bench&) {
  const BallPrecision precision(192);
  const AtMost not_above{};
  Finding finding;
  for (const auto& [r, alpha] : {std::pair{1, Rational(1, 6)}, {2, Rational(1, 10)}}) {
    const std::string of = ", r = " + std::to_string(r);
    const auto quotient = [](const Ball& error, const Ball& most) { return abs(error) / most - Ball(1); };
    const Element large{r, alpha, Rational(1, 4)};
    const Parameters node = large.at(large.nodes().front());
    const Parameters other = large.at(large.nodes().back());
    const Approximation by_rule = by_a_rule(large, node);
    finding.remark("own element's error, l = 1/4, by a conical rule" + of, by_rule);
    // As far as the rule's own radius, an estimate, goes.
    const AgreesWith rule{.value = Ball(by_rule.value), .within = by_rule.radius};
    const Ball error = integral(large, node, 1e-7);
    finding.require("own element's error, l = 1/4, against a conical rule" + of, rule, error);
    finding.control("that from another node against the same" + of, rule, integral(large, other, 1e-7));
    finding.require("own element's error over its bound, less 1, l = 1/4" + of, not_above,
                    proved(quotient(error, bound(large))));
    const Element medium{r, alpha, 1 / power(Rational(2), 10)};
    finding.require("own element's error over its bound, less 1, l = 2^-10" + of, not_above,
                    proved(quotient(integral(medium, medium.at(medium.nodes().front())), bound(medium))));
    const Element small{r, alpha, 1 / power(Rational(2), 20)};
    const Element fewer{r - 1, alpha, small.leg};
    finding.control("the same for nodes of degree r - 1, l = 2^-20" + of, not_above,
                    proved(quotient(integral(fewer, small.at(small.nodes().front())), bound(small))));
  }
  return finding;
}

}  // namespace radcert::verification::m06
