// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/scalar/decimal.h"

#include <cstddef>

namespace radcert {

bool is_decimal(std::string_view text) {
  constexpr std::size_t longest_exponent = 18;
  std::size_t at = 0;
  const auto take = [&](char a, char b) {
    const bool taken = at < text.size() && (text[at] == a || text[at] == b);
    if (taken) ++at;
    return taken;
  };
  const auto take_digits = [&] {
    const std::size_t start = at;
    while (at < text.size() && '0' <= text[at] && text[at] <= '9') ++at;
    return at - start;
  };
  take('+', '-');
  std::size_t digits = take_digits();
  if (take('.', '.')) digits += take_digits();
  if (digits == 0) return false;
  if (take('e', 'E')) {
    take('+', '-');
    const std::size_t exponent_digits = take_digits();
    if (exponent_digits == 0 || exponent_digits > longest_exponent) return false;
  }
  return at == text.size();
}

}  // namespace radcert
