// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "radcert/core/text.h"
#include "radcert/formats/problem/problem_parts.h"
#include "radcert/solve/iteration.h"

namespace radcert {

namespace {

const std::vector<std::string> available_solvers = {"direct", "gmres", "neumann", "verified"};
constexpr const char* as_far_as_double_holds = "rounding";

bool has_tolerance(const std::string& solver) { return solver == "gmres" || solver == "neumann"; }

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

SolverChoice read_solver(const JsonReader& solver) {
  solver.require_object({"name", "tolerance"});
  const std::string& name = solver.at("name", "one of " + listed(available_solvers)).word(available_solvers);
  SolverChoice choice;
  if (!has_tolerance(name)) {
    solver.require_object({"name"});
    if (name == "verified") choice.name = SolverName::verified;
    return choice;
  }
  choice.name = name == "gmres" ? SolverName::gmres : SolverName::neumann;
  if (const auto tolerance = solver.find("tolerance")) {
    const std::string* word = tolerance->value().string();
    if (word == nullptr || *word != as_far_as_double_holds) choice.tolerance = read_tolerance(*tolerance);
  }
  return choice;
}

JsonValue solver_json(const SolverChoice& solver) {
  JsonValue out = JsonValue::object();
  out.set("name", solver_name(solver.name));
  if (has_tolerance(solver_name(solver.name)))
    out.set("tolerance",
            solver.tolerance ? exact_json(*solver.tolerance) : JsonValue(as_far_as_double_holds));
  return out;
}

}  // namespace radcert
