// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "radcert/core/text.h"
#include "radcert/formats/problem/problem_parts.h"

namespace radcert {

std::vector<std::string> guaranteed_quantities() { return {"means"}; }

Guarantee read_guarantee(const JsonReader& guarantee) {
  guarantee.require_object({"width", "of"});
  const std::string allowed = "a positive decimal or fraction in a string";
  const JsonReader width = guarantee.at("width", allowed);
  Guarantee out{.width = width.rational(allowed)};
  if (out.width.sign() <= 0) width.refuse("is not positive", allowed);
  const std::vector<std::string> quantities = guaranteed_quantities();
  if (const auto of = guarantee.find("of")) static_cast<void>(of->word(quantities));
  return out;
}

JsonValue guarantee_json(const Guarantee& guarantee) {
  JsonValue out = JsonValue::object();
  out.set("width", exact_json(guarantee.width));
  out.set("of", guaranteed_quantities().front());
  return out;
}

}  // namespace radcert
