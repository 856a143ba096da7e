// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/ranks/ranks.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

class NoExchange final : public Exchange {
public:
  void bring(std::span<const double>, std::span<double> wanted) const override {
    expects(wanted.empty(), "no number that another rank holds", named("wanted", wanted.size()));
  }
  [[nodiscard]] std::uint64_t bytes_sent() const override { return 0; }
};

class OneRank final : public Ranks {
public:
  [[nodiscard]] std::size_t count() const override { return 1; }
  [[nodiscard]] std::size_t here() const override { return 0; }
  [[nodiscard]] std::vector<std::string> gather(std::string_view own) const override {
    return {std::string(own)};
  }
  [[nodiscard]] std::vector<std::string> gather_at_first(std::string_view own) const override {
    return {std::string(own)};
  }
  [[nodiscard]] std::unique_ptr<const Exchange> exchange(
      std::size_t, std::span<const RemoteNumber> wanted) const override {
    expects(wanted.empty(), "no number that another rank holds", named("wanted", wanted.size()));
    return std::make_unique<NoExchange>();
  }
};

std::string_view bytes_of(std::span<const double> numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()};
}

std::vector<double> numbers_of(const std::vector<std::string>& texts) {
  std::vector<double> all;
  for (const std::string& bytes : texts) {
    const std::size_t before = all.size();
    all.resize(before + bytes.size() / sizeof(double));
    if (!bytes.empty()) std::memcpy(&all[before], bytes.data(), bytes.size());
  }
  return all;
}

}  // namespace

std::vector<double> Ranks::gather_numbers(std::span<const double> own) const {
  if (count() == 1) return {own.begin(), own.end()};
  return numbers_of(gather(bytes_of(own)));
}

std::vector<double> Ranks::gather_numbers_at_first(std::span<const double> own) const {
  if (count() == 1) return {own.begin(), own.end()};
  return numbers_of(gather_at_first(bytes_of(own)));
}

double Ranks::largest(double own) const {
  double found = own;
  for (const double each : gather_numbers({&own, 1}))
    if (std::isnan(each) || (!std::isnan(found) && each > found)) found = each;
  return found;
}

bool Ranks::all(bool here) const { return largest(here ? 0 : 1) == 0; }

std::string Ranks::from_first(std::string_view own) const {
  return gather(is_first() ? own : std::string_view()).front();
}

std::vector<double> Ranks::numbers_from_first(std::span<const double> own) const {
  if (count() == 1) return {own.begin(), own.end()};
  return numbers_of({from_first(bytes_of(own))});
}

std::vector<double> Ranks::carried(std::vector<double> numbers,
                                   const std::function<void(std::span<double>)>& on) const {
  for (std::size_t rank = 0; rank < count(); ++rank) {
    if (rank == here()) on(numbers);
    if (count() > 1)
      numbers = numbers_of({gather(rank == here() ? bytes_of(numbers) : std::string_view())[rank]});
  }
  return numbers;
}

const Ranks& one_rank() {
  static const OneRank one;
  return one;
}

}  // namespace radcert
