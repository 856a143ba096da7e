// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/framework/finding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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

/// A number of which no digit says nothing: as many as its radius leaves, and no more than twelve; all of its
/// own where it is exact.
EnclosingText readable(const Approximation& observed) {
  constexpr int most = 12;
  constexpr int all = 17;
  if (observed.radius == 0) return enclosing_text(observed.value, 0, DecimalForm::general(all));
  if (observed.value == 0) return enclosing_text(0, observed.radius, DecimalForm::general(1));
  const double places =
      std::floor(std::log10(std::abs(observed.value))) - std::floor(std::log10(observed.radius));
  const int digits = static_cast<int>(std::clamp(places + 2, 2.0, static_cast<double>(most)));
  return enclosing_text(observed.value, observed.radius, DecimalForm::general(digits));
}

/// A decimal that is exactly its number, without zeros behind it.
std::string without_zeros(const std::string& text) {
  const std::size_t e = std::min(text.find('e'), text.size());
  std::string mantissa = text.substr(0, e);
  if (mantissa.find('.') != std::string::npos) {
    mantissa.erase(mantissa.find_last_not_of('0') + 1);
    if (mantissa.back() == '.') mantissa.pop_back();
  }
  const std::string power = text.substr(e);
  return power.find_first_of("123456789") == std::string::npos ? mantissa : mantissa + power;
}

/// The two texts of a number; the first as short as it can be where it is the number itself.
void show(Evidence& evidence, const std::string& value, const std::string& radius) {
  evidence.value = radius == "0" ? without_zeros(value) : value;
  evidence.radius = radius;
}

Evidence line(const std::string& what, const Approximation& observed, std::string allowed, Standing standing,
              double slack) {
  Evidence evidence{.what = what,
                    .value = "",
                    .radius = std::nullopt,
                    .allowed = std::move(allowed),
                    .standing = standing,
                    .number = observed.value,
                    .proved = observed.guaranteed && slack == 0};
  if (settles(observed)) {
    const EnclosingText text = readable(observed);
    show(evidence, text.value, text.radius);
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

/// Where an order ends and its neighbours begin.
struct Middles {
  std::optional<double> lower;
  std::optional<double> upper;
};

Middles middles_of(const Order& statement, double logarithm) {
  Middles middles;
  if (statement.below) {
    expects(*statement.below < statement.order, "below < order", named("below", *statement.below));
    middles.lower = (*statement.below + logarithm + statement.order) / 2;
  }
  if (statement.above) {
    expects(statement.order < *statement.above, "order < above", named("above", *statement.above));
    middles.upper = (statement.order + *statement.above) / 2;
  }
  return middles;
}

// "order >= 4, |log h| taken out: from 3.87 on, 3 without |log h| gives 3.74".
std::string order_text(const Order& statement, double logarithm) {
  const Middles middles = middles_of(statement, logarithm);
  const auto rounded = [](double number) { return shortest(std::round(number * 1e4) / 1e4); };
  const std::string relation = !statement.above ? " >= " : statement.below ? " = " : " <= ";
  std::string text = "order" + relation + rounded(statement.order);
  if (logarithm != 0) text += ", |log h| taken out";
  if (middles.lower && middles.upper)
    text += ": between " + rounded(*middles.lower) + " and " + rounded(*middles.upper);
  else if (middles.lower)
    text += ": above " + rounded(*middles.lower);
  else if (middles.upper)
    text += ": below " + rounded(*middles.upper);
  if (statement.below) {
    text += ", the middle to " + rounded(*statement.below);
    if (logarithm != 0) text += " without |log h|, which gives " + rounded(*statement.below + logarithm);
  }
  if (statement.above)
    text += (statement.below ? " and to " : ", the middle to ") + rounded(*statement.above);
  return text;
}

/// Proved: a ball as midpoint and radius, or why it has failed.
Evidence line(const std::string& what, const Ball& observed, int digits, std::string allowed,
              Standing standing) {
  Evidence evidence{
      .what = what,
      .value = observed.to_text(digits),
      .radius = std::nullopt,
      .allowed = std::move(allowed),
      .standing = standing,
      .number = observed.is_finite() ? observed.to_double() : std::numeric_limits<double>::quiet_NaN(),
      .proved = true};
  if (observed.is_finite()) {
    const BallDecimal text = observed.decimal(digits);
    show(evidence, text.midpoint, text.radius);
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

/// Whether a number is another one, its opposite or its reciprocal, to rounding. Numbers of up to three
/// digits meet by chance.
bool follows_from(double number, double other) {
  constexpr double near = 0x1p-48;
  const auto is = [&](double candidate) {
    return std::isfinite(candidate) && std::abs(number - candidate) <= near * std::abs(candidate);
  };
  // At most eleven bits, or four characters.
  const double bits = number == 0 ? 0 : std::abs(std::ldexp(number, 10 - std::ilogb(number)));
  const bool is_short = bits == std::floor(bits) || shortest(number).size() <= 4;
  return std::isfinite(number) && !is_short && other != 0 &&
         (is(other) || is(-other) || is(1 / other) || is(-1 / other));
}

}  // namespace

std::string_view name(Role role) {
  constexpr std::array<std::string_view, 3> names{"requirement", "control", "instead"};
  return names.at(static_cast<std::size_t>(role));
}

std::string_view name(Standing standing) {
  constexpr std::array<std::string_view, 3> names{"holds", "violated", "open"};
  return names.at(static_cast<std::size_t>(standing));
}

Approximation as_sampled(const Approximation& figure) {
  return figure.has_radius() ? figure : Approximation::estimated(figure.value, 0);
}

Standing judge(const Order& statement, const ObservedOrder& observed) {
  const Middles middles = middles_of(statement, observed.logarithm);
  if (!settles(observed.exponent)) return Standing::open;
  const Ends ends = ends_of(observed.exponent);
  const auto at = [](double number) { return Rational::exactly(number); };
  if ((middles.lower && ends.high < at(*middles.lower)) || (middles.upper && ends.low > at(*middles.upper)))
    return Standing::violated;
  const bool above = !middles.lower || ends.low > at(*middles.lower);
  const bool below = !middles.upper || ends.high < at(*middles.upper);
  return above && below ? Standing::holds : Standing::open;
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

void Finding::add(Role role, std::string_view kind, Evidence evidence) {
  evidence.role = role;
  evidence.kind = kind;
  evidence_.push_back(std::move(evidence));
}

void Finding::add(const std::string& what, const Order& statement, const ObservedOrder& observed, Role role) {
  add(role, "order",
      line(what, observed.exponent, order_text(statement, observed.logarithm), judge(statement, observed),
           0));
}

void Finding::add(const std::string& what, const Equals& statement, const Approximation& observed,
                  Role role) {
  add(role, "equals",
      line(what, observed, with_slack("= " + shortest(statement.value), statement.slack, statement.why),
           judge(statement, observed), statement.slack));
}

void Finding::add(const std::string& what, const AtMost& statement, const Approximation& observed,
                  Role role) {
  add(role, "at most",
      line(what, observed, with_slack("<= " + shortest(statement.value), statement.slack, statement.why),
           judge(statement, observed), statement.slack));
}

void Finding::add(const std::string& what, const IsExactly& statement, const Rational& observed, Role role) {
  add(role, "exactly",
      {.what = what,
       .value = observed.to_text(),
       .radius = std::nullopt,
       .allowed = "= " + statement.value.to_text() + " exactly",
       .standing = judge(statement, observed),
       .number = observed.to_double(),
       .proved = true});
}

void Finding::add(const std::string& what, const AgreesWith& statement, const Ball& observed, Role role) {
  // Enough to see agreement to within 1e-30 of a number near 1.
  constexpr int digits = 34;
  add(role, "agrees",
      line(what, observed, digits,
           "= " + statement.value.to_text(digits) + " to within " + shortest(statement.within),
           judge(statement, observed)));
}

void Finding::add(const std::string& what, const LiesIn& statement, const Approximation& observed,
                  Role role) {
  add(role, "lies in", line(what, observed, interval_text(statement), judge(statement, observed), 0));
}

void Finding::add(const std::string& what, const LiesIn& statement, const Ball& observed, Role role) {
  add(role, "lies in", line(what, observed, 20, interval_text(statement), judge(statement, observed)));
}

void Finding::remark(std::string what, const Approximation& observed) {
  if (settles(observed)) {
    const EnclosingText text = readable(observed);
    what += ": " + text.value + (text.radius == "0" ? "" : " +- " + text.radius);
  } else {
    what += ": about " + shortest(observed.value);
  }
  remarks_.push_back(std::move(what));
}

std::optional<std::string> Finding::fault() const {
  const auto any = [&](auto&& which) { return std::any_of(evidence_.begin(), evidence_.end(), which); };
  const auto of = [](Role role) { return [role](const Evidence& e) { return e.role == role; }; };
  if (!any(of(Role::requirement))) return "nothing is required";
  if (!any(of(Role::control))) return "there is no control";
  for (const Evidence& e : evidence_) {
    if (e.role == Role::control && e.standing != Standing::violated)
      return "the control is not rejected: " + e.what;
    if (e.role == Role::instead && e.standing != Standing::holds)
      return "what is said to hold instead does not: " + e.what;
    if (e.role == Role::control)
      for (const Evidence& required : evidence_)
        if (required.role == Role::requirement && follows_from(e.number, required.number))
          return "the control \"" + e.what + "\" is made of the number of \"" + required.what + "\"";
    if (of_data_ || e.role != Role::requirement || e.standing != Standing::violated) continue;
    const bool can_hold = any([&](const Evidence& other) {
      return other.role != Role::control && other.kind == e.kind && other.standing == Standing::holds;
    });
    if (!can_hold)
      return "\"" + e.what +
             "\" is rejected, and nothing of its kind is shown to be accepted: what holds instead?";
  }
  return std::nullopt;
}

Verdict Finding::verdict() const {
  if (fault()) return Verdict::failed;
  const auto any_requirement = [&](auto&& which) {
    return std::any_of(evidence_.begin(), evidence_.end(),
                       [&](const Evidence& e) { return e.role == Role::requirement && which(e); });
  };
  if (any_requirement([](const Evidence& e) { return e.standing == Standing::violated; }))
    return Verdict::contradicted;
  if (any_requirement([](const Evidence& e) { return e.standing == Standing::open; }))
    return Verdict::undecided;
  return any_requirement([](const Evidence& e) { return !e.proved; }) ? Verdict::supported
                                                                      : Verdict::certified;
}

}  // namespace radcert::verification
