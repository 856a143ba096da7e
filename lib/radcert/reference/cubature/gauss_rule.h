// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace radcert::reference {

/// A Gauss rule on [0,1] with an estimate of its error.
/// Maths     sum_i w_i g(x_i) for Int_0^1 g;  the estimate comes from the last coefficients c_{n-8} ...
///           c_{n-1} of g in the orthonormal Legendre polynomials, those from degree 2 on: they fall like q^k
///           where g is analytic, and the error of the rule is about c_{2n} = c_{n-1} q^(n+1). A part of g
///           that is small and falls slowly hides below the others: so the fall is continued over 2
///           `continued` <= n+1 degrees only
/// Source    Gauss 1814 (nodes: zeros of Legendre polynomials by Newton's method in long double); the use of
///           null rules as in Berntsen and Espelid, ACM TOMS 17 (1991)
/// Requires  smallest <= n <= largest
/// Result    nodes increasing, weights positive with sum 1 to rounding; exact for polynomials of degree 2n-1;
///           nodes and weights are correctly rounded but for ties. Arrays go on to a multiple of eight: the
///           nodes with the last one, the weights with zeros
/// Limits    the estimate is not a bound: it can be fooled by a function that oscillates between the nodes
class GaussRule {
public:
  static constexpr std::size_t smallest = 8;
  static constexpr std::size_t largest = 40;
  using Samples = std::array<double, largest>;

  explicit GaussRule(std::size_t n);
  /// The rule with n points from a table.
  static const GaussRule& of(std::size_t n);

  std::size_t size() const { return size_; }
  const Samples& nodes() const { return nodes_; }
  const Samples& weights() const { return weights_; }
  double integral(const Samples& g) const;

  struct Error {
    double value;
    double decay;  ///< q^2, the slowest fall seen over two degrees; 1 where they do not fall
  };
  Error error(const Samples& g, std::size_t continued) const;

private:
  static constexpr std::size_t most_pairs = 4;
  std::size_t size_;
  std::size_t pairs_;
  Samples nodes_{};
  Samples weights_{};
  std::array<std::array<double, 2 * most_pairs>, largest> null_{};  // by node: weight times polynomial
};

}  // namespace radcert::reference
