// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/values/families.h"

#include <utility>

namespace radcert::reference::values {

ValueParameter positive(std::string name, std::string default_text) {
  return {.name = std::move(name),
          .default_text = std::move(default_text),
          .allowed = "a number > 0",
          .allows = [](const Rational& x) { return x.sign() > 0; }};
}

ValueParameter strictly_between(std::string name, std::string default_text, const Rational& from,
                                const Rational& to) {
  return {.name = std::move(name),
          .default_text = std::move(default_text),
          .allowed = "a number in (" + from.to_text() + ", " + to.to_text() + ")",
          .allows = [from, to](const Rational& x) { return from < x && x < to; }};
}

ValueParameter from_to_below(std::string name, std::string default_text, const Rational& from,
                             const Rational& to) {
  return {.name = std::move(name),
          .default_text = std::move(default_text),
          .allowed = "a number in [" + from.to_text() + ", " + to.to_text() + ")",
          .allows = [from, to](const Rational& x) { return from <= x && x < to; }};
}

ValueParameter whole(std::string name, std::string default_text, long from, long to) {
  return {.name = std::move(name),
          .default_text = std::move(default_text),
          .allowed = "a whole number from " + std::to_string(from) + " to " + std::to_string(to),
          .allows = [from, to](const Rational& x) {
            return x.is_integer() && Rational(from) <= x && x <= Rational(to);
          }};
}

ValueParameter any_number(std::string name, std::string default_text) {
  return {.name = std::move(name),
          .default_text = std::move(default_text),
          .allowed = "a number",
          .allows = [](const Rational&) { return true; }};
}

}  // namespace radcert::reference::values
