// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace radcert {

class KrylovEngine;

/// Where a number stands that a rank needs and another one holds.
struct RemoteNumber {
  std::uint32_t rank = 0;
  std::uint64_t place = 0;  ///< among the numbers that this rank holds
};

/// Numbers that ranks hold and others need, again and again.
/// Result    immutable
class Exchange {
public:
  Exchange() = default;
  Exchange(const Exchange&) = delete;
  Exchange& operator=(const Exchange&) = delete;
  virtual ~Exchange() = default;

  /// wanted[i] becomes the number that was asked for as the i-th; `held` are those of this rank. Called by
  /// all ranks together.
  virtual void bring(std::span<const double> held, std::span<double> wanted) const = 0;
  /// The bytes that this rank sends each time.
  [[nodiscard]] virtual std::uint64_t bytes_sent() const = 0;
};

/// Another rank has come to its end, and so this one has to.
/// Result    the exit code of that rank, and what it had to say
class EndedElsewhere : public std::runtime_error {
public:
  EndedElsewhere(int code, const std::string& what) : std::runtime_error(what), code_(code) {}
  [[nodiscard]] int code() const { return code_; }

private:
  int code_;
};

/// The processes that compute one result together, each a part of it.
/// Requires  every rank calls the same functions in the same order, from one thread; a rank that cannot go on
///           says so to the others by whatever made this, and their next call throws
/// Result    numbers arrive as they were sent, to the bit, in the order of the ranks: what is computed of
///           them is the same on every rank. EndedElsewhere, or Interrupted, where another rank has ended
class Ranks {
public:
  Ranks() = default;
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
  virtual ~Ranks() = default;

  [[nodiscard]] virtual std::size_t count() const = 0;
  /// The number of this one, from 0.
  [[nodiscard]] virtual std::size_t here() const = 0;
  /// The bytes that each rank gives.
  [[nodiscard]] virtual std::vector<std::string> gather(std::string_view own) const = 0;
  /// The same for the first rank alone; nothing elsewhere.
  [[nodiscard]] virtual std::vector<std::string> gather_at_first(std::string_view own) const = 0;
  /// A way to these numbers; each rank holds so many of its own. Places are below 2^31.
  [[nodiscard]] virtual std::unique_ptr<const Exchange> exchange(
      std::size_t held, std::span<const RemoteNumber> wanted) const = 0;

  /// The Krylov methods that came with the ranks, or null.
  [[nodiscard]] virtual const KrylovEngine* krylov_engine() const { return nullptr; }

  [[nodiscard]] bool is_first() const { return here() == 0; }
  /// The numbers of all ranks after each other; at_first: none but on the first.
  [[nodiscard]] std::vector<double> gather_numbers(std::span<const double> own) const;
  [[nodiscard]] std::vector<double> gather_numbers_at_first(std::span<const double> own) const;
  /// The largest of the ranks' numbers; not a number where one is none.
  [[nodiscard]] double largest(double own) const;
  /// Whether something holds on all ranks.
  [[nodiscard]] bool all(bool here) const;
  /// What the first rank gives, wherever else.
  [[nodiscard]] std::string from_first(std::string_view own) const;
  [[nodiscard]] std::vector<double> numbers_from_first(std::span<const double> own) const;
  /// Numbers that go from rank to rank in their order, each carrying on with what those before it have made
  /// of them: what the last one makes of them, everywhere.
  [[nodiscard]] std::vector<double> carried(std::vector<double> numbers,
                                            const std::function<void(std::span<double>)>& on) const;
};

/// A process by itself.
[[nodiscard]] const Ranks& one_rank();

}  // namespace radcert
