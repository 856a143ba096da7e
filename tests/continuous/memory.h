// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "radcert/core/files/kept_numbers.h"

namespace radcert::test {

/// Numbers by their names, and how often some were found.
class Memory final : public KeptNumbers {
public:
  Memory() = default;
  explicit Memory(std::map<std::string, std::vector<double>> of) : numbers(std::move(of)) {}

  std::optional<std::vector<double>> find(const std::string& name) override {
    const auto at = numbers.find(name);
    if (at == numbers.end()) return std::nullopt;
    ++found;
    return at->second;
  }
  void keep(const std::string& name, std::span<const double> kept) override {
    EXPECT_TRUE(numbers.emplace(name, std::vector<double>(kept.begin(), kept.end())).second) << name;
  }
  /// About half of the numbers.
  [[nodiscard]] std::map<std::string, std::vector<double>> half() const {
    std::map<std::string, std::vector<double>> out;
    for (const auto& [name, of_name] : numbers)
      if (2 * out.size() < numbers.size()) out.emplace(name, of_name);
    return out;
  }

  std::map<std::string, std::vector<double>> numbers;
  int found = 0;
};

}  // namespace radcert::test
