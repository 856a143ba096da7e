// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace radcert {

/// Numbers that long work has found, by names, so that the same work need not find them again.
/// Requires  names that tell the numbers of one work apart
class KeptNumbers {
public:
  KeptNumbers() = default;
  KeptNumbers(const KeptNumbers&) = delete;
  KeptNumbers& operator=(const KeptNumbers&) = delete;
  KeptNumbers(KeptNumbers&&) = delete;
  KeptNumbers& operator=(KeptNumbers&&) = delete;
  virtual ~KeptNumbers() = default;

  /// Those that keep() was given under this name, to the bit; or none.
  [[nodiscard]] virtual std::optional<std::vector<double>> find(const std::string& name) = 0;
  virtual void keep(const std::string& name, std::span<const double> numbers) = 0;
};

}  // namespace radcert
