// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>

namespace radcert {

/// A Krylov method says no: what it was asked for by its own options.
class KrylovFailure : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// Krylov methods of another library, which come with the ranks.
/// Requires  called by all ranks together, each with its part of a vector
/// Result    the same bits for every number of ranks where the product and the dot product have them
class KrylovEngine {
public:
  /// y = A x.
  using Product = std::function<void(std::span<const double> x, std::span<double> y)>;
  /// Over the parts of all ranks.
  using Dot = std::function<double(std::span<const double> x, std::span<const double> y)>;

  KrylovEngine() = default;
  KrylovEngine(const KrylovEngine&) = delete;
  KrylovEngine& operator=(const KrylovEngine&) = delete;
  virtual ~KrylovEngine() = default;

  /// What a solution depends on beside the arguments: its options, as a text.
  [[nodiscard]] virtual std::string options() const = 0;

  /// r becomes d with |r - A d| <= relative |r| in the 2-norm, or the best that was found: how good it is,
  /// the caller has to look. Gives the number of iterations. KrylovFailure, and what the product throws.
  virtual std::size_t solve(const Product& a, const Dot& dot, double relative, std::span<double> r) const = 0;
};

}  // namespace radcert
