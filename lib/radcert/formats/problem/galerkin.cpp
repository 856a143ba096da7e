// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "radcert/formats/problem/problem_parts.h"

namespace radcert {

Galerkin read_galerkin(const JsonReader& basis) {
  basis.require_object({"method", "degree"});
  const std::vector<std::string> methods = {"galerkin"};
  (void)basis.at("method", "galerkin").word(methods);
  const std::string allowed = "a whole number from 0 to " + std::to_string(largest_galerkin_degree);
  return {.degree = static_cast<int>(basis.at("degree", allowed).whole(0, largest_galerkin_degree, allowed))};
}

JsonValue galerkin_json(const Galerkin& method) {
  return JsonValue::object({{"method", "galerkin"}, {"degree", method.degree}});
}

std::vector<std::string> galerkin_words(const Galerkin& method) {
  return {"Galerkin of degree " + std::to_string(method.degree)};
}

}  // namespace radcert
