// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

#include "radcert/core/files/kept_numbers.h"
#include "radcert/study/problem.h"

namespace radcert {

class ResultStore;

/// The numbers of one work in the result store.
/// Requires  the store outlives it; a key that says everything that the work depends on
/// Result    to the bit; a file that was changed reads as absent
/// Limits    a store that is off keeps nothing
class StoredNumbers final : public KeptNumbers {
public:
  StoredNumbers(ResultStore& store, std::string key) : store_(store), key_(std::move(key)) {}

  [[nodiscard]] std::optional<std::vector<double>> find(const std::string& name) override;
  void keep(const std::string& name, std::span<const double> numbers) override;

private:
  ResultStore& store_;
  std::string key_;
};

/// The key of the search for a problem's guarantee; that for a certificate is another.
/// Requires  a problem with a guarantee that problem_json can write
/// Result    the digest of the sources and the canonical problem
[[nodiscard]] std::string guarantee_key(const Problem& problem, bool with_certificate);

}  // namespace radcert
