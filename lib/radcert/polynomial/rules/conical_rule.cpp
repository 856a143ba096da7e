// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/rules/conical_rule.h"

#include <algorithm>

#include "radcert/core/contract.h"
#include "radcert/polynomial/rules/gauss.h"

namespace radcert {
namespace {

constexpr int grading_power = 8;  // 1 - m^8 = (1 - m) (1 + m) (1 + m^2) (1 + m^4) below

/// Distances from the apex and from the base, and the weight of l dl, all free of cancellation.
template <Real R>
struct RadialRule {
  std::vector<R> from_apex;
  std::vector<R> from_base;
  std::vector<R> weights;
};

template <Real R>
RadialRule<R> radial_rule(int order, Grading grading) {
  RadialRule<R> radial;
  if (grading == Grading::none) {
    const IntervalRule<R> gauss = gauss_rule<R>(order, IntervalWeight::variable);
    for (int k = 0; k < order; ++k) {
      const auto i = static_cast<std::size_t>(k);
      radial.from_apex.push_back(gauss.nodes[i]);
      radial.from_base.push_back(R(1) - gauss.nodes[i]);
      radial.weights.push_back(gauss.weights[i]);
    }
    return radial;
  }
  const IntervalRule<R> gauss = gauss_rule<R>(std::max(2 * order, grading_power), IntervalWeight::one);
  for (std::size_t i = 0; i < gauss.nodes.size(); ++i) {
    const R& m = gauss.nodes[i];
    const R& rest = gauss.nodes[gauss.nodes.size() - 1 - i];  // 1 - m: the rule is symmetric
    const R near = power(m, grading_power);
    const R far = R(1) - near;
    const R length = grading == Grading::apex ? near
                                              : rest * (R(1) + m) * (R(1) + m * m) *
                                                    (R(1) + power(m, 4));  // far, to the last place
    radial.from_apex.push_back(grading == Grading::apex ? near : far);
    radial.from_base.push_back(grading == Grading::apex ? far : near);
    radial.weights.push_back(gauss.weights[i] * R(grading_power) * power(m, grading_power - 1) * length);
  }
  return radial;
}

}  // namespace

template <Real R>
TriangleRule<R> conical_rule(int order, Grading grading) {
  expects(1 <= order && order <= 96, "1 <= order <= 96", named("order", order));
  const RadialRule<R> radial = radial_rule<R>(order, grading);
  const IntervalRule<R> across = gauss_rule<R>(order, IntervalWeight::one);
  TriangleRule<R> rule;
  for (std::size_t i = 0; i < radial.weights.size(); ++i)
    for (std::size_t k = 0; k < across.nodes.size(); ++k) {
      const R& l = radial.from_apex[i];
      rule.points.push_back({{radial.from_base[i], l * (R(1) - across.nodes[k]), l * across.nodes[k]}});
      rule.weights.push_back(radial.weights[i] * across.weights[k]);
    }
  return rule;
}

template TriangleRule<double> conical_rule<double>(int, Grading);
template TriangleRule<Mpfr<50>> conical_rule<Mpfr<50>>(int, Grading);
template TriangleRule<Ball> conical_rule<Ball>(int, Grading);

}  // namespace radcert
