// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "radcert/scalar/approximation.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/rational.h"
#include "verification/framework/observed_order.h"
#include "verification/framework/verdict.h"

namespace radcert::verification {

/// A figure that is the largest over a sample, and has no radius, as what was sampled.
/// Result    radius 0 in place of an infinite one, then not guaranteed
[[nodiscard]] Approximation as_sampled(const Approximation& figure);

/// "The error falls like h^order": at least so fast, at most so fast, or both.
/// Maths     an order is told from its neighbours: the exponent must lie beyond the middle between the order
///           and the neighbour. In a model with |log h| the lower neighbour is h^below without it, which that
///           model takes for the exponent below + lambda
/// Requires  below < order < above, else ContractViolation
/// Limits    has no slack: how exact the exponent is known is said by what is observed
struct Order {
  double order = 0;
  std::optional<double> below;  ///< the next slower order; absent: any slower error is one of this order
  std::optional<double> above;  ///< the next faster order; absent: any faster error is one of this order

  [[nodiscard]] static Order at_least(double order) { return {order, order - 1, std::nullopt}; }
  [[nodiscard]] static Order at_least(double order, double below) { return {order, below, std::nullopt}; }
  [[nodiscard]] static Order at_most(double order, double above) { return {order, std::nullopt, above}; }
  [[nodiscard]] static Order is(double order) { return {order, order - 1, order + 1}; }
  [[nodiscard]] static Order is(double order, double below, double above) { return {order, below, above}; }
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
/// Maths     Order: an exponent all of whose interval lies between the middles holds, one all of whose
///           interval lies beyond one of them violates;
///           Equals: |v - value| + radius <= slack holds, |v - value| - radius > slack violates;
///           AtMost: v + radius <= value + slack holds, v - radius > value + slack violates;  IsExactly:
///           equality of rationals; AgreesWith: |v - value| <= within for all points of both balls holds, >
///           within for all violates; LiesIn: the whole enclosure in the interval holds, none of it violates
/// Source    ours
/// Requires  slack >= 0, else ContractViolation
/// Result    open where neither is the case, and for numbers that are not finite; the doubles of both sides
///           are compared exactly
[[nodiscard]] Standing judge(const Order& statement, const ObservedOrder& observed);
[[nodiscard]] Standing judge(const Equals& statement, const Approximation& observed);
[[nodiscard]] Standing judge(const AtMost& statement, const Approximation& observed);
[[nodiscard]] Standing judge(const IsExactly& statement, const Rational& observed);
[[nodiscard]] Standing judge(const AgreesWith& statement, const Ball& observed);
[[nodiscard]] Standing judge(const LiesIn& statement, const Approximation& observed);
[[nodiscard]] Standing judge(const LiesIn& statement, const Ball& observed);

/// What an observation is in a check.
/// Maths     requirement: the statement must fit it; control: a computation of its own in which something
///           that the statement needs is false, so that the statement must not fit it; instead: of a
///           statement that is contradicted, what holds in its place
enum class Role { requirement, control, instead };

/// "requirement", "control", "instead".
[[nodiscard]] std::string_view name(Role role);

/// One line of evidence.
struct Evidence {
  std::string what;                   ///< what was observed, and where
  std::string value;                  ///< the number, as text
  std::optional<std::string> radius;  ///< null: exact, or not estimated
  std::string allowed;                ///< what the statement allows
  Standing standing = Standing::open;
  double number = 0;      ///< the observed number, rounded
  std::string kind = {};  ///< of the statement: "order", "equals", "at most", "exactly", "agrees", "lies in"
  Role role = Role::requirement;
  bool proved = false;  ///< exact, or with a guaranteed radius
};

/// What a check found: the evidence, and the verdict that follows from it.
/// Maths     failed, if nothing is required, there is no control or one that is not violated, a control's
///           number is that of a requirement, its opposite or its reciprocal, or a requirement is violated
///           and neither another one of its kind nor an `instead` holds: a check that rejects everything
///           contradicts nothing. Else a requirement violated: contradicted; one open: undecided; else
///           certified if every requirement is proved and without slack, supported if not. AgreesWith is
///           proved: `within` is part of the statement, no slack in it
/// Source    ours
/// Requires  each kind of statement is required and controlled by the same check: what is rejected is what
///           was believed
/// Result    evidence in the order in which it was given
/// Limits    cannot know whether a control is a good one
class Finding {
public:
  Finding() = default;
  /// For a check that the framework makes of data alone, an order or an enclosure: one check for all of them,
  /// which accepts others, so that a contradiction needs no counterpart of its own.
  [[nodiscard]] static Finding of_data() {
    Finding finding;
    finding.of_data_ = true;
    return finding;
  }

  /// What an earlier check of code has found, as its parts say.
  [[nodiscard]] static Finding restored(std::vector<Evidence> evidence, std::vector<std::string> remarks,
                                        const std::optional<Approximation>& figure) {
    Finding finding;
    finding.evidence_ = std::move(evidence);
    finding.remarks_ = std::move(remarks);
    finding.figure_ = figure;
    return finding;
  }

  template <class Statement, class Observation>
  void require(const std::string& what, const Statement& statement, const Observation& observed) {
    add(what, statement, observed, Role::requirement);
  }
  /// The same for something that the statement must reject.
  template <class Statement, class Observation>
  void control(const std::string& what, const Statement& statement, const Observation& observed) {
    add(what, statement, observed, Role::control);
  }
  /// The same for the corrected statement, where the printed one is contradicted: it must hold.
  template <class Statement, class Observation>
  void instead(const std::string& what, const Statement& statement, const Observation& observed) {
    add(what, statement, observed, Role::instead);
  }
  /// A line for the reader that decides nothing.
  void remark(std::string what, const Approximation& observed);
  /// What the figure beside the statement is.
  void show(const Approximation& figure) { figure_ = figure; }

  [[nodiscard]] Verdict verdict() const;
  /// Why the verdict is `failed`, in words; nothing where it is not.
  [[nodiscard]] std::optional<std::string> fault() const;
  [[nodiscard]] const std::vector<Evidence>& evidence() const { return evidence_; }
  [[nodiscard]] const std::vector<std::string>& remarks() const { return remarks_; }
  [[nodiscard]] const std::optional<Approximation>& figure() const { return figure_; }

private:
  void add(Role role, std::string_view kind, Evidence evidence);
  void add(const std::string& what, const Order& statement, const ObservedOrder& observed, Role role);
  void add(const std::string& what, const Equals& statement, const Approximation& observed, Role role);
  void add(const std::string& what, const AtMost& statement, const Approximation& observed, Role role);
  void add(const std::string& what, const IsExactly& statement, const Rational& observed, Role role);
  void add(const std::string& what, const AgreesWith& statement, const Ball& observed, Role role);
  void add(const std::string& what, const LiesIn& statement, const Approximation& observed, Role role);
  void add(const std::string& what, const LiesIn& statement, const Ball& observed, Role role);

  bool of_data_ = false;
  std::vector<Evidence> evidence_;
  std::vector<std::string> remarks_;
  std::optional<Approximation> figure_;
};

}  // namespace radcert::verification
