// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "radcert/scalar/approximation.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/rational.h"
#include "verification/framework/verdict.h"

namespace radcert::verification {

/// A figure that is the largest over a sample, and has no radius, as what was sampled.
/// Result    radius 0 in place of an infinite one, then not guaranteed
[[nodiscard]] Approximation as_sampled(const Approximation& figure);

/// "The error falls at least like h^order": the observed exponent may be short by the slack.
struct Bound {
  double order = 0;
  double slack = 0;
  std::string why;  ///< why the slack is what it is
};

/// "The number is `value`."
struct Equals {
  double value = 0;
  double slack = 0;
  std::string why;
};

/// "The number is at most `value`."
struct AtMost {
  double value = 0;
  double slack = 0;
  std::string why;
};

/// "The number is exactly `value`."
struct IsExactly {
  Rational value;
};

/// "The number differs from `value` by at most `within`": two enclosures of what should be one number.
struct AgreesWith {
  Ball value;
  double within = 0;
};

/// "The number lies in [least, largest]."
struct LiesIn {
  Rational least;
  Rational largest;
};

/// Whether an observation agrees with a statement.
enum class Standing { holds, violated, open };

/// "holds", "violated", "open".
[[nodiscard]] std::string_view name(Standing standing);

/// An observation held against a statement.
/// Maths     Bound: value - radius >= order - slack holds, value + radius < order - slack violates;
///           Equals: |v - value| + radius <= slack holds, |v - value| - radius > slack violates;
///           AtMost: v + radius <= value + slack holds, v - radius > value + slack violates;  IsExactly:
///           equality of rationals; AgreesWith: |v - value| <= within for all points of both balls holds, >
///           within for all violates; LiesIn: the whole enclosure in the interval holds, none of it violates
/// Source    ours
/// Requires  slack >= 0, else ContractViolation
/// Result    open where neither is the case, and for numbers that are not finite; the doubles of both sides
///           are compared exactly
[[nodiscard]] Standing judge(const Bound& statement, const Approximation& observed);
[[nodiscard]] Standing judge(const Equals& statement, const Approximation& observed);
[[nodiscard]] Standing judge(const AtMost& statement, const Approximation& observed);
[[nodiscard]] Standing judge(const IsExactly& statement, const Rational& observed);
[[nodiscard]] Standing judge(const AgreesWith& statement, const Ball& observed);
[[nodiscard]] Standing judge(const LiesIn& statement, const Approximation& observed);
[[nodiscard]] Standing judge(const LiesIn& statement, const Ball& observed);

/// One line of evidence.
struct Evidence {
  std::string what;                   ///< what was observed, and where
  std::string value;                  ///< the number, as text
  std::optional<std::string> radius;  ///< null: exact, or not estimated
  std::string allowed;                ///< what the statement allows
  Standing standing = Standing::open;
  bool control = false;  ///< an observation that the statement must not fit
  bool proved = false;   ///< exact, or with a guaranteed radius
};

/// What a check found: the evidence, and the verdict that follows from it.
/// Maths     a control that is not violated, no control, or nothing required: failed; a requirement violated:
///           contradicted; one open: undecided; else certified if every requirement is proved and without
///           slack, supported if not. AgreesWith is proved: `within` is part of the statement, no slack in it
/// Source    ours
/// Requires  each kind of statement is required and controlled by the same check: what is rejected is what
///           was believed
/// Result    evidence in the order in which it was given
/// Limits    cannot know whether a control is a good one
class Finding {
public:
  template <class Statement, class Observation>
  void require(const std::string& what, const Statement& statement, const Observation& observed) {
    add(what, statement, observed, false);
  }
  /// The same for something that the statement must reject.
  template <class Statement, class Observation>
  void control(const std::string& what, const Statement& statement, const Observation& observed) {
    add(what, statement, observed, true);
  }
  /// A line for the reader that decides nothing.
  void remark(std::string what, const Approximation& observed);
  /// What the figure beside the statement is.
  void show(const Approximation& figure) { figure_ = figure; }

  [[nodiscard]] Verdict verdict() const;
  [[nodiscard]] const std::vector<Evidence>& evidence() const { return evidence_; }
  [[nodiscard]] const std::vector<std::string>& remarks() const { return remarks_; }
  [[nodiscard]] const std::optional<Approximation>& figure() const { return figure_; }

private:
  void add(const std::string& what, const Bound& statement, const Approximation& observed, bool control);
  void add(const std::string& what, const Equals& statement, const Approximation& observed, bool control);
  void add(const std::string& what, const AtMost& statement, const Approximation& observed, bool control);
  void add(const std::string& what, const IsExactly& statement, const Rational& observed, bool control);
  void add(const std::string& what, const AgreesWith& statement, const Ball& observed, bool control);
  void add(const std::string& what, const LiesIn& statement, const Approximation& observed, bool control);
  void add(const std::string& what, const LiesIn& statement, const Ball& observed, bool control);

  std::vector<Evidence> evidence_;
  std::vector<std::string> remarks_;
  std::optional<Approximation> figure_;
};

}  // namespace radcert::verification
