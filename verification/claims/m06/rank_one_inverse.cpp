// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/m06/rank_one_inverse.h"

#include "verification/claims/rational_function.h"

namespace radcert::verification::m06 {
namespace {

/// What is the same in both: f, R, M(f) and M(R).
struct Letters {
  Polynomial f = Polynomial::variable("f");
  Polynomial r = Polynomial::variable("R");
  Polynomial mean = Polynomial::variable("M(f)");
  Polynomial q = Polynomial::variable("q");
};

}  // namespace

Rational terms_of_right_inverse(int sign) {
  const Letters x;
  const Polynomial factor = 1 + sign * x.q;
  const Polynomial g = factor * x.f + x.r * x.mean;
  const Polynomial mean_of_g = factor * x.mean + x.q * x.mean;
  return differing_terms(g - x.r * mean_of_g, factor * x.f);
}

Rational terms_of_left_inverse(int sign) {
  const Letters x;
  const Polynomial factor = 1 + sign * x.q;
  const Polynomial y_g = factor * (x.f - x.r * x.mean) + x.r * (x.mean - x.q * x.mean);
  return differing_terms(y_g, factor * x.f);
}

}  // namespace radcert::verification::m06
