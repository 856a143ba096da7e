// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/polynomial/rules/gauss.h"

namespace radcert::laws {

/// A sum with its terms' sizes, to say how far a rounded sum may be off.
template <class R>
struct RuleSum {
  R value{};
  R absolute{};
};

template <class R, class Place>
RuleSum<R> sum(const std::vector<Place>& places, const std::vector<R>& weights,
               const std::function<R(const Place&)>& f) {
  using std::abs;
  RuleSum<R> total;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const R term = weights[k] * f(places[k]);
    total.value += term;
    total.absolute += abs(term);
  }
  return total;
}

template <class R>
RuleSum<R> sum(const IntervalRule<R>& rule, const std::function<R(const R&)>& f) {
  return sum<R, R>(rule.nodes, rule.weights, f);
}

template <class R>
RuleSum<R> sum(const TriangleRule<R>& rule, const std::function<R(const Barycentric<R>&)>& f) {
  return sum<R, Barycentric<R>>(rule.points, rule.weights, f);
}

/// As many nodes as weights, nodes ascending and strictly inside (0,1), weights positive with the sum
/// `measure`.
template <class R>
::testing::AssertionResult is_positive_on_the_open_interval(const IntervalRule<R>& rule, const R& measure,
                                                            const R& tolerance) {
  using std::abs;
  if (rule.nodes.size() != rule.weights.size())
    return ::testing::AssertionFailure()
           << rule.nodes.size() << " nodes, " << rule.weights.size() << " weights";
  R before(0);
  R total(0);
  for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
    if (!(before < rule.nodes[k] && rule.nodes[k] < R(1)))
      return ::testing::AssertionFailure() << "node " << k << " is " << description(rule.nodes[k]);
    if (!(rule.weights[k] > R(0)))
      return ::testing::AssertionFailure() << "weight " << k << " is " << description(rule.weights[k]);
    before = rule.nodes[k];
    total += rule.weights[k];
  }
  if (!(abs(total - measure) <= tolerance))
    return ::testing::AssertionFailure() << "the weights sum to " << description(total);
  return ::testing::AssertionSuccess();
}

/// As many points as weights, points in the open triangle, weights positive with the sum 1/2.
template <class R>
::testing::AssertionResult is_positive_in_the_open_triangle(const TriangleRule<R>& rule, const R& tolerance) {
  using std::abs;
  if (rule.points.size() != rule.weights.size())
    return ::testing::AssertionFailure()
           << rule.points.size() << " points, " << rule.weights.size() << " weights";
  R total(0);
  for (std::size_t k = 0; k < rule.points.size(); ++k) {
    const auto& x = rule.points[k].x;
    for (const R& coordinate : x)
      if (!(R(0) < coordinate && coordinate <= R(1)))  // next to a corner 1 - small is 1
        return ::testing::AssertionFailure()
               << "point " << k << " has the coordinate " << description(coordinate);
    if (!(abs(x[0] + x[1] + x[2] - R(1)) <= tolerance))
      return ::testing::AssertionFailure() << "point " << k << " is not barycentric";
    if (!(rule.weights[k] > R(0)))
      return ::testing::AssertionFailure() << "weight " << k << " is " << description(rule.weights[k]);
    total += rule.weights[k];
  }
  if (!(abs(total - R(1) / R(2)) <= tolerance))
    return ::testing::AssertionFailure() << "the weights sum to " << description(total);
  return ::testing::AssertionSuccess();
}

/// Int x_1^a x_2^b x_3^c = a! b! c! / (a + b + c + 2)! over the reference triangle, to a relative tolerance,
/// for a + b + c <= degree.
template <class R>
::testing::AssertionResult integrates_polynomials(const TriangleRule<R>& rule, int degree,
                                                  const R& relative_tolerance) {
  using std::abs;
  for (int a = 0; a <= degree; ++a)
    for (int b = 0; a + b <= degree; ++b)
      for (int c = 0; a + b + c <= degree; ++c) {
        R exact = R(1) / (R(a + b + c + 1) * R(a + b + c + 2));
        for (int k = 1; k <= b; ++k) exact = exact * R(k) / R(a + k);
        for (int k = 1; k <= c; ++k) exact = exact * R(k) / R(a + b + k);
        const RuleSum<R> got = sum<R>(rule, [a, b, c](const Barycentric<R>& x) {
          return power(x.x[0], a) * power(x.x[1], b) * power(x.x[2], c);
        });
        if (!(abs(got.value - exact) <= relative_tolerance * exact))
          return ::testing::AssertionFailure()
                 << "x_1^" << a << " x_2^" << b << " x_3^" << c << ": " << description(got.value)
                 << " instead of " << description(exact);
      }
  return ::testing::AssertionSuccess();
}

}  // namespace radcert::laws
