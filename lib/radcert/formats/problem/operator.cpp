// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "radcert/clusters/cluster_operator.h"
#include "radcert/core/text.h"
#include "radcert/formats/problem/problem_parts.h"
#include "radcert/study/collocation/matrix_form.h"

namespace radcert {

OperatorChoice read_operator(const JsonReader& matrix) {
  matrix.require_object({"name", "tolerance"});
  const std::vector<std::string> names = operator_names();
  OperatorChoice choice{.name = matrix.at("name", "one of " + listed(names)).word(names)};
  const auto tolerance = matrix.find("tolerance");
  if (!tolerance) return choice;
  if (choice.name == "dense") tolerance->refuse("is not for dense", "h2 or auto with a tolerance");
  const std::string allowed = "a number from " + shortest(ClusterTolerance::finest) +
                              ", what double can hold, to " + shortest(ClusterTolerance::coarsest) +
                              ", or a decimal or fraction in a string";
  choice.tolerance = tolerance->rational(allowed);
  const double value = choice.tolerance.to_double();
  if (!(ClusterTolerance::finest <= value && value <= ClusterTolerance::coarsest))
    tolerance->refuse("is outside the range", allowed);
  return choice;
}

JsonValue operator_json(const OperatorChoice& matrix) {
  JsonValue out = JsonValue::object();
  out.set("name", matrix.name);
  if (matrix.name != "dense") out.set("tolerance", exact_json(matrix.tolerance));
  return out;
}

}  // namespace radcert
