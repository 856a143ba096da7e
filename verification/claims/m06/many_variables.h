// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "radcert/scalar/rational.h"

namespace radcert::verification::m06 {

/// A polynomial of any number of variables with rational coefficients, for identities that hold for all
/// values.
/// Maths     sum c x_1^k_1 x_2^k_2 ...; the ring Q[x_1, x_2, ...]
/// Result    exact. Terms with c = 0 are not kept: terms() is zero if and only if the polynomial is
class ManyVariables {
public:
  ManyVariables() = default;
  ManyVariables(const Rational& constant) {  // NOLINT(google-explicit-constructor): exact
    if (constant != 0) terms_[{}] = constant;
  }
  ManyVariables(int constant) : ManyVariables(Rational(constant)) {}  // NOLINT(google-explicit-constructor)
  /// x_(number), the first has the number 0.
  [[nodiscard]] static ManyVariables variable(std::size_t number) {
    ManyVariables x;
    Exponents exponents(number + 1, 0);
    exponents.back() = 1;
    x.terms_[exponents] = 1;
    return x;
  }

  /// How many terms are left.
  [[nodiscard]] Rational terms() const { return {static_cast<long>(terms_.size())}; }

  ManyVariables& operator+=(const ManyVariables& other) {
    for (const auto& [exponents, c] : other.terms_) {
      Rational& sum = terms_[exponents];
      sum += c;
      if (sum == 0) terms_.erase(exponents);
    }
    return *this;
  }
  [[nodiscard]] ManyVariables operator-() const { return ManyVariables(-1) * *this; }
  [[nodiscard]] friend ManyVariables operator+(ManyVariables a, const ManyVariables& b) { return a += b; }
  [[nodiscard]] friend ManyVariables operator-(ManyVariables a, const ManyVariables& b) { return a += -b; }
  [[nodiscard]] friend ManyVariables operator*(const ManyVariables& a, const ManyVariables& b) {
    ManyVariables product;
    for (const auto& [of_a, c] : a.terms_)
      for (const auto& [of_b, d] : b.terms_) {
        const Exponents& longer = of_a.size() < of_b.size() ? of_b : of_a;
        const Exponents& shorter = of_a.size() < of_b.size() ? of_a : of_b;
        Exponents exponents = longer;
        for (std::size_t i = 0; i < shorter.size(); ++i) exponents[i] += shorter[i];
        ManyVariables term;
        term.terms_[exponents] = c * d;
        product += term;
      }
    return product;
  }

private:
  using Exponents = std::vector<int>;  ///< without zeros at the end
  std::map<Exponents, Rational> terms_;
};

}  // namespace radcert::verification::m06
