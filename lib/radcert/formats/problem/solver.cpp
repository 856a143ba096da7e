// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "radcert/core/text.h"
#include "radcert/formats/problem/problem_parts.h"
#include "radcert/solve/linear_solver.h"

namespace radcert {

namespace {

constexpr const char* as_far_as_double_holds = "rounding";

Rational read_tolerance(const JsonReader& tolerance) {
  const std::string allowed =
      "a number from " + shortest(least_tolerance) +
      ", about what double can hold, to below 1, or a decimal or fraction in a string; "
      "rounding: as far as double holds";
  const Rational value = tolerance.rational(allowed);
  if (value < Rational::exactly(least_tolerance) || value >= Rational(1))
    tolerance.refuse("is outside the range", allowed);
  return value;
}

}  // namespace

std::vector<std::string> solvers_without_tolerance() {
  return solver_names([](const LinearSolver& solver) { return !solver.iterates(); });
}

SolverChoice read_solver(const JsonReader& solver) {
  solver.require_object({"name", "tolerance"});
  const std::vector<std::string> names = solver_names();
  SolverChoice choice{.name = solver.at("name", "one of " + listed(names)).word(names)};
  if (!find_linear_solver(choice.name)->iterates()) {
    if (const auto tolerance = solver.find("tolerance"))
      tolerance->refuse("is not for " + choice.name,
                        listed(solver_names([](const LinearSolver& each) { return each.iterates(); })) +
                            " with a tolerance");
    return choice;
  }
  if (const auto tolerance = solver.find("tolerance")) {
    const std::string* word = tolerance->value().string();
    if (word == nullptr || *word != as_far_as_double_holds) choice.tolerance = read_tolerance(*tolerance);
  }
  return choice;
}

JsonValue solver_json(const SolverChoice& solver) {
  JsonValue out = JsonValue::object();
  out.set("name", solver.name);
  if (find_linear_solver(solver.name)->iterates())
    out.set("tolerance",
            solver.tolerance ? exact_json(*solver.tolerance) : JsonValue(as_far_as_double_holds));
  return out;
}

}  // namespace radcert
