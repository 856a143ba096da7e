// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <string>

namespace radcert::test {

/// The text of a random expression in x, y, z, every operation fully in parentheses.
inline std::string random_expression(std::mt19937_64& random, int depth) {
  static constexpr const char* leaves[] = {"x", "y", "z", "pi", "0", "1", "2", "0.1", "1e-3", "3.25"};
  static constexpr const char* functions[] = {"sqrt", "exp", "log", "sin", "cos", "tan", "atan", "abs"};
  static constexpr const char* exponents[] = {"2", "3",   "0",    "1",     "-1", "-3",
                                              "7", "0.5", "(-2)", "(1+1)", "1e7"};
  if (depth == 0) return leaves[random() % std::size(leaves)];
  const auto part = [&] {
    return random_expression(random, static_cast<int>(random() % static_cast<unsigned>(depth)));
  };
  switch (random() % 10) {
    case 0: return "(-" + part() + ")";
    case 1: return "(" + part() + ")^" + exponents[random() % std::size(exponents)];
    case 2: return "(" + part() + ")^(" + part() + ")";
    case 3:
    case 4: return std::string(functions[random() % std::size(functions)]) + "(" + part() + ")";
    case 5: return "min(" + part() + "," + part() + ")";
    case 6: return "max(" + part() + "," + part() + ")";
    default: {
      std::string left = part();
      return "(" + std::move(left) + "+-*/"[random() % 4] + part() + ")";
    }
  }
}

}  // namespace radcert::test
