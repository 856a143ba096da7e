// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "radcert/core/outcome.h"
#include "radcert/polynomial/nodes/inset_family.h"
#include "radcert/polynomial/real_zeros.h"

namespace radcert {

/// An inset for which the rule is exact further than for most.
/// Maths     the one zero of `condition` in the enclosure, and the degree of precision there
/// Source    [m06, section 3.1]: alpha_0
/// Requires  made by superconvergent_insets
/// Result    exact; precision on the region that was asked for
struct SuperconvergentInset {
  RealZero enclosure;
  int precision = 0;
  /// "1/6", "7/15 - 1/15 sqrt(34)": where the condition has degree 1 or 2, or the inset is rational.
  std::optional<std::string> closed_form;
};

/// The error of the rule at the inset lattice for one monomial.
struct InsetDefect {
  Monomial monomial;
  InsetFunction defect;
};

/// The insets in (0, 1/3) for which the interpolatory rule gains a degree of precision, with the proof.
/// Maths     every inset: exact of degree d = `precision`. D_t: the numerators of the defects of the
///           monomials of degree d + 1, all of them, or so many that they have no common zero; condition =
///           gcd_t D_t = sum_t cofactor_t D_t. An inset gains a degree if and only if condition(inset) = 0
/// Source    [m06, (13), (28), Theorem 7]. On the parallelogram d is odd: polynomials odd about the centre
///           cost nothing
/// Requires  made by superconvergent_insets
/// Result    condition = 1: no inset, real or complex, gains a degree, and the cofactors prove it. Otherwise
///           `insets` are all zeros in (0, 1/3), ascending, isolated by Sturm's theorem
/// Limits    degree 0 does not depend on the inset
struct SuperconvergentInsets {
  int degree = 0;
  Region region = Region::triangle;
  int precision = 0;
  std::vector<InsetDefect> defects;
  RationalPolynomial condition;
  std::vector<RationalPolynomial> cofactors;
  std::vector<SuperconvergentInset> insets;

  /// "none: the defects of s^6 and s^4 t^2 have no common zero".
  [[nodiscard]] std::string to_text() const;
};

/// For which insets the rule of a degree gains a degree of precision on a region.
/// Maths     see SuperconvergentInsets. The answers for r <= 12: triangle r = 1: 1/6; r = 2: (1 +
///           cos((arccos(4/5) + 2 pi k)/3))/3, k = 1, 2; r = 3: (7 - sqrt 34)/15; r = 4 and r = 6: two each,
///           zeros of quintics; none for the others. Parallelogram: those of r = 1 and r = 3, and none for
///           the others
/// Source    [m06, Theorem 7]: alpha_0
/// Requires  0 <= degree <= 30, else ContractViolation
/// Result    exact, with its certificate; enclosures of width <= 2^-40
/// Limits    time grows fast with the degree: a second for all degrees to 8, a second at 12
[[nodiscard]] SuperconvergentInsets superconvergent_insets(int degree, Region region);

/// Whether a certificate proves what it says, given its defects.
/// Maths     sum_t cofactor_t D_t = condition;  condition divides every D_t;  as many insets as Sturm's
///           theorem counts in (0, 1/3), one in each enclosure
/// Result    success, or the first step that fails
/// Limits    the defects are taken as they stand: compare them with radcert::defect at as many insets as
///           their degree
[[nodiscard]] Outcome<void> recheck(const SuperconvergentInsets& answer);

/// A fraction that is an inset, or lies so close to it as was asked for.
struct NearInset {
  Rational value;
  bool is_exact = false;
};

/// The inset alpha_0 that Theorem 7 of m06 supposes.
/// Maths     the inset in (0, 1/3) whose rule on the parallelogram is exact further than that of every other
///           inset
/// Source    [m06, Theorem 7]
/// Requires  1 <= degree <= 30, width > 0, else ContractViolation
/// Result    a fraction, exact where alpha_0 is one, else within `width` of it; or why there is none, proved
/// Limits    for even degrees there is none for r <= 12: there every inset has the order r + 2 at the nodes
[[nodiscard]] Outcome<NearInset> superconvergent_inset(int degree, const Rational& width);

}  // namespace radcert
