// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/framework/stored_number.h"

#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "radcert/core/text.h"
#include "radcert/core/version.h"

namespace radcert::verification {
namespace {

// "value radius guaranteed"
std::string number_text(const Approximation& number) {
  return shortest(number.value) + " " + shortest(number.radius) + (number.guaranteed ? " 1" : " 0");
}

std::optional<Approximation> read_number(std::string_view text) {
  const std::size_t first = text.find(' ');
  const std::size_t second = first == std::string_view::npos ? first : text.find(' ', first + 1);
  if (second == std::string_view::npos) return std::nullopt;
  const std::optional<double> value = parse_double(text.substr(0, first));
  const std::optional<double> radius = parse_double(text.substr(first + 1, second - first - 1));
  const std::string_view proved = text.substr(second + 1);
  if (!value || !radius || (proved != "0" && proved != "1")) return std::nullopt;
  return Approximation{.value = *value, .radius = *radius, .guaranteed = proved == "1"};
}

}  // namespace

Approximation stored(ResultStore& store, const std::string& key,
                     const std::function<Approximation()>& compute) {
  const std::string full_key = "verification number\n" + std::string(source_digest()) + "\n" + key;
  if (const std::optional<std::string> kept = store.get(full_key))
    if (const std::optional<Approximation> number = read_number(*kept)) return *number;
  const Approximation number = compute();
  static_cast<void>(store.put(full_key, number_text(number)));
  return number;
}

}  // namespace radcert::verification
