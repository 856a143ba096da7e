// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "radcert/core/text.h"
#include "radcert/formats/problem/problem_parts.h"
#include "radcert/solve/iteration.h"

namespace radcert {

namespace {

constexpr auto solvers = {SolverName::direct, SolverName::gmres, SolverName::neumann, SolverName::verified};
constexpr const char* as_far_as_double_holds = "rounding";

bool has_tolerance(SolverName solver) { return solver == SolverName::gmres || solver == SolverName::neumann; }

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

std::vector<std::string> solver_names() {
  std::vector<std::string> names;
  for (const SolverName solver : solvers) names.push_back(solver_name(solver));
  return names;
}

std::vector<std::string> solvers_without_tolerance() {
  std::vector<std::string> names;
  for (const SolverName solver : solvers)
    if (!has_tolerance(solver)) names.push_back(solver_name(solver));
  return names;
}

SolverChoice read_solver(const JsonReader& solver) {
  solver.require_object({"name", "tolerance"});
  const std::vector<std::string> names = solver_names();
  const std::string& chosen = solver.at("name", "one of " + listed(names)).word(names);
  SolverChoice choice;
  for (const SolverName each : solvers)
    if (solver_name(each) == chosen) choice.name = each;
  if (!has_tolerance(choice.name)) {
    solver.require_object({"name"});
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
  out.set("name", solver_name(solver.name));
  if (has_tolerance(solver.name))
    out.set("tolerance",
            solver.tolerance ? exact_json(*solver.tolerance) : JsonValue(as_far_as_double_holds));
  return out;
}

}  // namespace radcert
