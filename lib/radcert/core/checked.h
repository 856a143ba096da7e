// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

namespace radcert {

/// Sum and product of sizes, without wrapping round.
/// Maths     a + b and a b in the integers
/// Requires  nothing
/// Result    exact, or no value where it is 2^64 or more
[[nodiscard]] constexpr std::optional<std::uint64_t> checked_add(std::uint64_t a, std::uint64_t b) {
  const std::uint64_t sum = a + b;
  if (sum < a) return std::nullopt;
  return sum;
}

/// The product, or no value where it is 2^64 or more.
[[nodiscard]] constexpr std::optional<std::uint64_t> checked_multiply(std::uint64_t a, std::uint64_t b) {
  if (a != 0 && b > UINT64_MAX / a) return std::nullopt;
  return a * b;
}

/// The product, or 2^64 - 1 where it does not fit: "that or more", as MemoryPlan counts.
[[nodiscard]] constexpr std::uint64_t saturated_product(std::uint64_t a, std::uint64_t b) {
  return checked_multiply(a, b).value_or(UINT64_MAX);
}

}  // namespace radcert
