// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/framework/enclosure_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "radcert/core/errors.h"
#include "radcert/formats/problem/problem_json.h"
#include "radcert/formats/result/stored_levels.h"
#include "radcert/reference/reference_value.h"
#include "radcert/scalar/ball_precision.h"
#include "radcert/study/study.h"

namespace radcert::verification {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// What settles nothing.
Approximation unknown() { return {.value = infinity, .radius = infinity}; }

struct FamilyMember {
  const reference::ValueFamily* family = nullptr;
  reference::Arguments arguments;
};

// Where in claims.toml a claim says something.
InputFault fault_at(const Paper& paper, const Claim& claim, const std::string& key, std::string value,
                    std::string problem, std::string allowed) {
  return {.source = paper.source("claims.toml") + ", line " + std::to_string(claim.line),
          .pointer = "/" + claim.label + "/" + key,
          .value = std::move(value),
          .problem = std::move(problem),
          .allowed = std::move(allowed)};
}

FamilyMember member_of(const Paper& paper, const Claim& claim, const EnclosedQuantity& number,
                       bool is_control) {
  const std::string key = is_control ? "control" : "reference";
  const std::string values_key = is_control ? "control_values" : "values";
  if (const reference::NamedValue* value = reference::find_value(number.reference)) {
    if (!number.values.empty())
      throw InputError(fault_at(paper, claim, values_key, number.values.front().first,
                                "is given, and " + number.reference + " is one value",
                                "none, or the family " + value->family));
    return {.family = reference::find_family(value->family), .arguments = value->arguments};
  }
  FamilyMember member{.family = reference::find_family(number.reference), .arguments = {}};
  if (member.family == nullptr)
    throw InputError(fault_at(paper, claim, key, number.reference, "is no reference value",
                              "the names of radcert list references"));
  member.arguments = reference::default_arguments(*member.family);
  const auto& parameters = member.family->parameters;
  for (const auto& [name, value] : number.values) {
    const auto found = std::find_if(parameters.begin(), parameters.end(),
                                    [&name = name](const auto& each) { return each.name == name; });
    std::string names;
    for (const reference::ValueParameter& each : parameters) names += (names.empty() ? "" : ", ") + each.name;
    if (found == parameters.end())
      throw InputError(fault_at(paper, claim, values_key, name, "is no parameter of " + number.reference,
                                names.empty() ? "it has none" : names));
    if (!found->allows(value))
      throw InputError(
          fault_at(paper, claim, values_key + "/" + name, value.to_text(), "is not allowed", found->allowed));
    member.arguments[static_cast<std::size_t>(found - parameters.begin())] = value;
  }
  return member;
}

Problem problem_of(const Paper& paper, const EnclosedQuantity& number) {
  return parse_problem(paper.file(number.problem), paper.source(number.problem));
}

bool is_value_of_u_n(const std::string& quantity) {
  return quantity == "least_u_n" || quantity == "largest_u_n";
}

void check_problem(const Paper& paper, const EnclosedQuantity& number) {
  const Problem problem = problem_of(paper, number);
  const std::string source = paper.source(number.problem);
  if (problem.solver.name != "verified")
    throw InputError({.source = source,
                      .pointer = "/solver/name",
                      .value = problem.solver.name,
                      .problem = "proves nothing",
                      .allowed = "verified, for a claim with check = \"enclosure\""});
  if (!problem.solution && !is_value_of_u_n(number.quantity))
    throw InputError({.source = source,
                      .pointer = "/solution",
                      .problem = "is missing, and " + number.quantity + " needs it",
                      .allowed = "a solution, or the quantities least_u_n and largest_u_n"});
}

// [low, high] as a number with a radius that encloses it.
Approximation enclosing(const Rational& low, const Rational& high) {
  Approximation out{.value = (Rational(1, 2) * (low + high)).to_double(), .radius = 0, .guaranteed = true};
  const Rational value = Rational::exactly(out.value);
  const Rational needed = value - low < high - value ? high - value : value - low;
  out.radius = needed.to_double();
  if (Rational::exactly(out.radius) < needed) out.radius = std::nextafter(out.radius, infinity);
  return out;
}

// The least or the largest value of u_n at a node; no finite radius where a node has none.
Approximation extreme_node(const std::vector<NodeValue>& nodes, bool least) {
  std::optional<std::pair<Rational, Rational>> extreme;
  for (const NodeValue& node : nodes) {
    if (!node.u_n.guaranteed || !std::isfinite(node.u_n.value) || !node.u_n.has_radius()) return unknown();
    const Rational value = Rational::exactly(node.u_n.value);
    const Rational radius = Rational::exactly(node.u_n.radius);
    const Rational low = value - radius;
    const Rational high = value + radius;
    if (!extreme) extreme = {low, high};
    if (least ? low < extreme->first : extreme->first < low) extreme->first = low;
    if (least ? high < extreme->second : extreme->second < high) extreme->second = high;
  }
  return extreme ? enclosing(extreme->first, extreme->second) : unknown();
}

Approximation figure_of(const std::optional<Approximation>& figure) {
  return figure && figure->guaranteed && figure->has_radius() ? *figure : unknown();
}

Approximation figure_of(const LevelOutcome& outcome, const std::string& quantity) {
  if (is_value_of_u_n(quantity)) return extreme_node(outcome.nodes, quantity == "least_u_n");
  return figure_of(quantity == "node_error" ? outcome.result.node_error
                                            : outcome.result.discretisation_error);
}

// An observation, or the reason why there is none, as a line of the finding.
class Line {
public:
  Line(Finding& finding, const LiesIn& interval, bool is_control)
      : finding_(&finding), interval_(&interval), is_control_(is_control) {}
  void add(const std::string& what, const auto& observed) const {
    if (is_control_)
      finding_->control(what, *interval_, observed);
    else
      finding_->require(what, *interval_, observed);
  }

private:
  Finding* finding_;
  const LiesIn* interval_;
  bool is_control_;
};

void observe_problem(const Paper& paper, const EnclosedQuantity& number, const Bench& bench, const Line& line,
                     Finding& finding, bool is_control) {
  const Problem problem = problem_of(paper, number);
  const int level = number.level.value_or(problem.triangulation.levels.back());
  const std::string what = number.quantity + ", " + number.problem + ", level " + std::to_string(level);
  try {
    const Approximation figure = figure_of(bench.levels.level(problem, level), number.quantity);
    line.add(what, figure);
    if (!is_control) finding.show(figure);
  } catch (const AccuracyNotReached& error) {
    line.add(what + " (" + error.what() + ")", unknown());
  }
}

// Digits enough to tell where any ball of observe_reference lies.
long bits_to_compare(int digits) {
  return 2 * reference::bits_for(Rational(1) / power(Rational(10), digits));
}

// By as many digits as it takes.
void observe_reference(const FamilyMember& member, const std::string& name, const LiesIn& interval,
                       const Line& line, Finding& finding, bool is_control) {
  constexpr int first_digits = 20;
  constexpr int most_digits = 160;
  const BallPrecision enough(bits_to_compare(most_digits));
  std::optional<Ball> ball;
  std::string reason;
  for (int digits = first_digits; digits <= most_digits; digits *= 2) {
    const Outcome<reference::EnclosedValue> value =
        reference::enclose(*member.family, member.arguments, digits);
    if (!value) {
      reason = value.reason();
      break;
    }
    ball = value->first.value;
    if (judge(interval, *ball) != Standing::open) break;
  }
  if (!ball) {
    line.add(name + " (" + reason + ")", unknown());
    return;
  }
  line.add(name, *ball);
  if (!is_control)
    finding.show(enclosing(Rational::exactly(ball->lower_double()), Rational::exactly(ball->upper_double())));
}

void observe(const Paper& paper, const Claim& claim, const Bench& bench, Finding& finding, bool is_control) {
  const EnclosureClaim& enclosure = claim.enclosure.value();
  const EnclosedQuantity& number = is_control ? enclosure.control : enclosure.number;
  const LiesIn interval{.least = enclosure.least, .largest = enclosure.largest};
  const Line line(finding, interval, is_control);
  if (number.reference.empty())
    observe_problem(paper, number, bench, line, finding, is_control);
  else
    observe_reference(member_of(paper, claim, number, is_control), number.reference, interval, line, finding,
                      is_control);
}

}  // namespace

void check_names(const Paper& paper, const Claim& claim) {
  for (const bool is_control : {false, true}) {
    const EnclosedQuantity& number = is_control ? claim.enclosure->control : claim.enclosure->number;
    if (number.reference.empty())
      check_problem(paper, number);
    else
      static_cast<void>(member_of(paper, claim, number, is_control));
  }
}

Finding check_enclosure(const Paper& paper, const Claim& claim, const Bench& bench) {
  Finding finding = Finding::of_data();
  observe(paper, claim, bench, finding, false);
  observe(paper, claim, bench, finding, true);
  return finding;
}

}  // namespace radcert::verification
