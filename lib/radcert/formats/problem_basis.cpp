// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "radcert/formats/problem_parts.h"

namespace radcert {

namespace {

constexpr int largest_degree = 8;
const std::vector<std::string> available_families = {"inset"};
const std::vector<std::string> planned_families = {"symmetric", "shepard", "gaussian", "lehtinen",
                                                   "meshless"};
constexpr const char* alpha_allowed =
    "a decimal or fraction in a string, or a number, in [0, 1/3); superconvergent at degree 1; "
    "at degree 0 it may be left out";

Rational read_alpha(const JsonReader& alpha, int degree) {
  if (const std::string* word = alpha.value().string(); word != nullptr && *word == "superconvergent") {
    // Superconvergence is proved for linear functions with the inset 1/6 [ac98, Theorem 3.7].
    if (degree == 1) return {1, 6};
    alpha.refuse("is not available in this version at degree " + std::to_string(degree), alpha_allowed);
  }
  const Rational value = alpha.rational(alpha_allowed);
  if (value < Rational(0) || value >= Rational(1, 3)) alpha.refuse("is outside the range", alpha_allowed);
  return value;
}

}  // namespace

BasisChoice read_basis(const JsonReader& basis) {
  if (basis.value().members() == nullptr) basis.refuse("is " + basis.value().kind(), "an object");
  if (const auto file = basis.find("file"))
    file->refuse("names a basis, which is not available in this version", "the key family with inset");
  (void)basis.at("family", "one of " + listed(available_families)).word(available_families, planned_families);
  basis.require_object({"family", "degree", "alpha"});

  BasisChoice choice;
  const std::string degree_allowed = "a whole number from 0 to 8";
  choice.degree =
      static_cast<int>(basis.at("degree", degree_allowed).whole(0, largest_degree, degree_allowed));
  if (const auto alpha = basis.find("alpha"))
    choice.alpha = read_alpha(*alpha, choice.degree);
  else if (choice.degree > 0)
    choice.alpha = read_alpha(basis.at("alpha", alpha_allowed), choice.degree);
  return choice;
}

JsonValue basis_json(const BasisChoice& basis) {
  JsonValue out = JsonValue::object();
  out.set("family", "inset");
  out.set("degree", basis.degree);
  if (basis.alpha) out.set("alpha", basis.alpha->to_text());
  return out;
}

}  // namespace radcert
