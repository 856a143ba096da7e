// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "radcert/core/text.h"
#include "radcert/formats/problem/problem_parts.h"
#include "radcert/quadrature/tolerance.h"

namespace radcert {

QuadratureChoice read_quadrature(const JsonReader& quadrature) {
  quadrature.require_object({"tolerance"});
  const std::string allowed = "a number from " + shortest(Tolerance::finest) + ", what double can hold, to " +
                              shortest(Tolerance::coarsest) + ", or a decimal or fraction in a string";
  const JsonReader tolerance = quadrature.at("tolerance", allowed);
  QuadratureChoice choice;
  choice.tolerance = tolerance.rational(allowed);
  if (choice.tolerance.to_double() < Tolerance::finest || choice.tolerance.to_double() > Tolerance::coarsest)
    tolerance.refuse("is outside the range", allowed);
  return choice;
}

JsonValue quadrature_json(const QuadratureChoice& quadrature) {
  JsonValue out = JsonValue::object();
  out.set("tolerance", exact_json(quadrature.tolerance));
  return out;
}

}  // namespace radcert
