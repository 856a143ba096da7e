// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "verification/claims/induction.h"
#include "verification/claims/rational_function.h"

namespace radcert::verification::psg10 {

/// (11): the sums over any number of elements before and after they are divided by a total.
/// Maths     raw = sum psi_i, divided = sum psi_i/t, t any symbol
/// Source    [psg10, (11)]
struct DividedElements {
  RationalFunction raw;
  RationalFunction divided;

  [[nodiscard]] static RationalFunction total() { return RationalFunction::variable("t"); }
  [[nodiscard]] static DividedElements none() { return {0, 0}; }
  [[nodiscard]] static DividedElements any() {
    const RationalFunction sum = RationalFunction::variable("sum");
    return {sum, sum / total()};
  }
  [[nodiscard]] DividedElements with(const RationalFunction& psi, const RationalFunction& divisor) const {
    return {raw + psi, divided + psi / divisor};
  }
};

/// Terms in which any number of elements, divided by `divisor`, do not sum to raw/t, which is 1 where t is
/// their sum.
[[nodiscard]] inline Rational not_divided(const RationalFunction& divisor) {
  return left_over_by_induction(
      DividedElements::none(), DividedElements::any(),
      [&](const DividedElements& before) { return before.with(RationalFunction::variable("psi"), divisor); },
      [](const DividedElements& elements) {
        return differing_terms(elements.divided, elements.raw / DividedElements::total());
      });
}

/// (16): what the squared distances u_k of any number of sites come to, seen from one more.
/// Maths     product = prod u_k,  without_one = sum_k prod_{j != k} u_j,  inverses = sum 1/u_k; so that
///           without_one = product * inverses
/// Source    ours
struct OtherSites {
  RationalFunction product;
  RationalFunction without_one;
  RationalFunction inverses;

  [[nodiscard]] static OtherSites none() { return {1, 0, 0}; }
  [[nodiscard]] static OtherSites any() {
    const RationalFunction product = RationalFunction::variable("D");
    const RationalFunction inverses = RationalFunction::variable("Q");
    return {product, product * inverses, inverses};
  }
  /// One more site, of the raw element psi.
  [[nodiscard]] OtherSites with(const RationalFunction& square, const RationalFunction& psi) const {
    return {product * square, without_one * square + product, inverses + psi};
  }
};

/// Shepard's element of a site among any number of others, without a division by a distance.
/// Maths     prod u_k/(prod u_k + u without_one) over the others: prod_{j != i} u_j / sum_k prod_{j != k} u_j
/// Source    [psg10, (16)], multiplied by all squared distances
[[nodiscard]] inline RationalFunction shepard_element(const RationalFunction& square,
                                                      const OtherSites& others) {
  return others.product / (others.product + square * others.without_one);
}

}  // namespace radcert::verification::psg10
