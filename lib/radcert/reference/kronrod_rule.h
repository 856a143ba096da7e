// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace radcert::reference {

/// The 15-point Kronrod rule on [0,1] with an estimate of its error.
/// Maths     sum_i w_i g(x_i) for Int_0^1 g;  the estimate comes from the coefficients c_7 ... c_14 of g in the polynomials that are orthonormal
///           at the nodes: they fall like q^k where g is analytic, and the error of the rule is about c_14 q^10
/// Source    Kronrod 1965 (nodes and weights: Boost.Math); the use of null rules as in Berntsen and Espelid, ACM TOMS 17 (1991)
/// Requires  -
/// Result    nodes increasing, weights positive with sum 1 to rounding; exact for polynomials of degree 23
/// Limits    the estimate is not a bound: it can be fooled by a function that oscillates between the nodes
class KronrodRule {
public:
  static constexpr int size = 15;
  using Samples = std::array<double, size>;

  KronrodRule();
  const Samples& nodes() const { return nodes_; }
  const Samples& weights() const { return weights_; }
  double integral(const Samples& g) const;
  double error(const Samples& g) const;

private:
  static constexpr int null_rules = 8;  // degrees 7 to 14
  Samples nodes_{};
  Samples weights_{};
  std::array<Samples, null_rules> null_{};
};

}  // namespace radcert::reference
