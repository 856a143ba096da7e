// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/framework/finding.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "radcert/core/contract.h"
#include "radcert/core/text.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/scalar/real.h"

namespace radcert::verification {
namespace {

bool settles(const Approximation& observed) {
  return std::isfinite(observed.value) && std::isfinite(observed.radius) && observed.radius >= 0;
}

// Both ends, exactly: a sum of doubles that is rounded could put them on the wrong side of a bound.
struct Ends {
  Rational low;
  Rational high;
};

Ends ends_of(const Approximation& observed) {
  const Rational value = Rational::exactly(observed.value);
  const Rational radius = Rational::exactly(observed.radius);
  return {.low = value - radius, .high = value + radius};
}

void require_slack(double slack) { expects(slack >= 0, "slack >= 0", named("slack", slack)); }

Evidence line(const std::string& what, const Approximation& observed, std::string allowed, Standing standing,
              bool control, double slack) {
  Evidence evidence{.what = what,
                    .value = "",
                    .radius = std::nullopt,
                    .allowed = std::move(allowed),
                    .standing = standing,
                    .control = control,
                    .proved = observed.guaranteed && slack == 0};
  if (settles(observed)) {
    const EnclosingText text = enclosing_text(observed.value, observed.radius, DecimalForm::scientific(12));
    evidence.value = text.value;
    evidence.radius = text.radius;
  } else {
    evidence.value = shortest(observed.value);
  }
  return evidence;
}

std::string with_slack(std::string text, double slack, const std::string& why) {
  if (slack != 0) text += ", slack " + shortest(slack);
  if (!why.empty()) text += " (" + why + ")";
  return text;
}

/// Proved: a ball as midpoint and radius, or why it has failed.
Evidence line(const std::string& what, const Ball& observed, int digits, std::string allowed,
              Standing standing, bool control) {
  Evidence evidence{.what = what,
                    .value = observed.to_text(digits),
                    .radius = std::nullopt,
                    .allowed = std::move(allowed),
                    .standing = standing,
                    .control = control,
                    .proved = true};
  if (observed.is_finite()) {
    const BallDecimal text = observed.decimal(digits);
    evidence.value = text.midpoint;
    evidence.radius = text.radius;
  }
  return evidence;
}

// A decimal where the number is one of at most so many places, else a fraction.
std::string decimal_or_fraction(const Rational& q) {
  constexpr std::size_t most_places = 60;
  Rational scaled = abs(q);
  for (std::size_t places = 0; places <= most_places; ++places, scaled = Rational(10) * scaled) {
    if (!scaled.is_integer()) continue;
    std::string digits = scaled.to_text();
    if (places == 0) return q.to_text();
    if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
    digits.insert(digits.size() - places, ".");
    return (q.sign() < 0 ? "-" : "") + digits;
  }
  return q.to_text();
}

std::string interval_text(const LiesIn& statement) {
  return "in [" + decimal_or_fraction(statement.least) + ", " + decimal_or_fraction(statement.largest) + "]";
}

}  // namespace

std::string_view name(Standing standing) {
  constexpr std::array<std::string_view, 3> names{"holds", "violated", "open"};
  return names.at(static_cast<std::size_t>(standing));
}

Approximation as_sampled(const Approximation& figure) {
  return figure.has_radius() ? figure : Approximation::estimated(figure.value, 0);
}

Standing judge(const Bound& statement, const Approximation& observed) {
  require_slack(statement.slack);
  if (!settles(observed) || !std::isfinite(statement.order) || !std::isfinite(statement.slack))
    return Standing::open;
  const Ends ends = ends_of(observed);
  const Rational least = Rational::exactly(statement.order) - Rational::exactly(statement.slack);
  if (ends.low >= least) return Standing::holds;
  return ends.high < least ? Standing::violated : Standing::open;
}

Standing judge(const Equals& statement, const Approximation& observed) {
  require_slack(statement.slack);
  if (!settles(observed) || !std::isfinite(statement.value) || !std::isfinite(statement.slack))
    return Standing::open;
  const Rational distance = abs(Rational::exactly(observed.value) - Rational::exactly(statement.value));
  const Rational radius = Rational::exactly(observed.radius);
  const Rational slack = Rational::exactly(statement.slack);
  if (distance + radius <= slack) return Standing::holds;
  return distance - radius > slack ? Standing::violated : Standing::open;
}

Standing judge(const AtMost& statement, const Approximation& observed) {
  require_slack(statement.slack);
  if (!settles(observed) || !std::isfinite(statement.value) || !std::isfinite(statement.slack))
    return Standing::open;
  const Ends ends = ends_of(observed);
  const Rational largest = Rational::exactly(statement.value) + Rational::exactly(statement.slack);
  if (ends.high <= largest) return Standing::holds;
  return ends.low > largest ? Standing::violated : Standing::open;
}

Standing judge(const IsExactly& statement, const Rational& observed) {
  return observed == statement.value ? Standing::holds : Standing::violated;
}

Standing judge(const LiesIn& statement, const Approximation& observed) {
  if (!settles(observed)) return Standing::open;
  const Ends ends = ends_of(observed);
  if (statement.least <= ends.low && ends.high <= statement.largest) return Standing::holds;
  const bool outside = ends.high < statement.least || statement.largest < ends.low;
  return outside ? Standing::violated : Standing::open;
}

Standing judge(const LiesIn& statement, const Ball& observed) {
  const Ball least(statement.least);
  const Ball largest(statement.largest);
  if (certainly_at_most(least, observed) && certainly_at_most(observed, largest)) return Standing::holds;
  const bool outside = certainly_less(observed, least) || certainly_less(largest, observed);
  return outside ? Standing::violated : Standing::open;
}

Standing judge(const AgreesWith& statement, const Ball& observed) {
  expects(statement.within >= 0, "within >= 0", named("within", statement.within));
  const Ball distance = abs(observed - statement.value);
  if (certainly_at_most(distance, Ball(statement.within))) return Standing::holds;
  return certainly_less(Ball(statement.within), distance) ? Standing::violated : Standing::open;
}

void Finding::add(const std::string& what, const Bound& statement, const Approximation& observed,
                  bool control) {
  evidence_.push_back(line(
      what, observed, with_slack("order >= " + shortest(statement.order), statement.slack, statement.why),
      judge(statement, observed), control, statement.slack));
}

void Finding::add(const std::string& what, const Equals& statement, const Approximation& observed,
                  bool control) {
  evidence_.push_back(line(what, observed,
                           with_slack("= " + shortest(statement.value), statement.slack, statement.why),
                           judge(statement, observed), control, statement.slack));
}

void Finding::add(const std::string& what, const AtMost& statement, const Approximation& observed,
                  bool control) {
  evidence_.push_back(line(what, observed,
                           with_slack("<= " + shortest(statement.value), statement.slack, statement.why),
                           judge(statement, observed), control, statement.slack));
}

void Finding::add(const std::string& what, const IsExactly& statement, const Rational& observed,
                  bool control) {
  evidence_.push_back({.what = what,
                       .value = observed.to_text(),
                       .radius = std::nullopt,
                       .allowed = "= " + statement.value.to_text() + " exactly",
                       .standing = judge(statement, observed),
                       .control = control,
                       .proved = true});
}

void Finding::add(const std::string& what, const AgreesWith& statement, const Ball& observed, bool control) {
  // Enough to see agreement to within 1e-30 of a number near 1.
  constexpr int digits = 34;
  evidence_.push_back(
      line(what, observed, digits,
           "= " + statement.value.to_text(digits) + " to within " + shortest(statement.within),
           judge(statement, observed), control));
}

void Finding::add(const std::string& what, const LiesIn& statement, const Approximation& observed,
                  bool control) {
  evidence_.push_back(line(what, observed, interval_text(statement), judge(statement, observed), control, 0));
}

void Finding::add(const std::string& what, const LiesIn& statement, const Ball& observed, bool control) {
  evidence_.push_back(
      line(what, observed, 20, interval_text(statement), judge(statement, observed), control));
}

void Finding::remark(std::string what, const Approximation& observed) {
  if (settles(observed)) {
    const EnclosingText text = enclosing_text(observed.value, observed.radius, DecimalForm::scientific(12));
    what += ": " + text.value + " +- " + text.radius;
  } else {
    what += ": " + shortest(observed.value);
  }
  remarks_.push_back(std::move(what));
}

Verdict Finding::verdict() const {
  const auto count = [&](bool control, auto&& which) {
    return std::count_if(evidence_.begin(), evidence_.end(),
                         [&](const Evidence& e) { return e.control == control && which(e); });
  };
  const auto standing = [](Standing wanted) {
    return [wanted](const Evidence& e) { return e.standing == wanted; };
  };
  const auto all = [](const Evidence&) { return true; };
  const auto controls = count(true, all);
  if (count(false, all) == 0 || controls == 0 || count(true, standing(Standing::violated)) != controls)
    return Verdict::failed;
  if (count(false, standing(Standing::violated)) > 0) return Verdict::contradicted;
  if (count(false, standing(Standing::open)) > 0) return Verdict::undecided;
  const bool proved = count(false, [](const Evidence& e) { return e.proved; }) == count(false, all);
  return proved ? Verdict::certified : Verdict::supported;
}

}  // namespace radcert::verification
