// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/attack/attack.h"

#include <gtest/gtest.h>

#include <charconv>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace radcert::attack::detail {

namespace {

constexpr std::uint64_t usual_seed = 1;

template <class Number>
std::optional<Number> from_environment(const char* name) {
  const char* text = std::getenv(name);
  if (text == nullptr) return std::nullopt;
  Number value{};
  const char* end = text + std::strlen(text);
  const auto [after, error] = std::from_chars(text, end, value);
  if (error != std::errc() || after != end || !(value >= Number(0)))
    throw std::invalid_argument(std::string(name) + " is '" + text + "', not a number >= 0");
  return value;
}

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Share::Share(std::size_t usual_instances)
    : usual_(usual_instances),
      seed_(from_environment<std::uint64_t>("RADCERT_ATTACK_SEED").value_or(usual_seed)) {
  if (const auto seconds = from_environment<double>("RADCERT_ATTACK"))
    until_ = now() + *seconds / testing::UnitTest::GetInstance()->test_to_run_count();
}

std::optional<std::size_t> Share::next() {
  if (until_ == 0 ? done_ == usual_ : now() >= until_) return std::nullopt;
  return done_++;
}

std::uint64_t seed_of(std::uint64_t seed, std::string_view kind, std::size_t k) {
  // Every bit of the three enters: multiply and shift, by odd constants.
  std::uint64_t mixed = seed + 0x9e3779b97f4a7c15U;
  const auto stir = [&mixed](std::uint64_t part) {
    mixed = (mixed ^ part) * 0xbf58476d1ce4e5b9U;
    mixed ^= mixed >> 31U;
  };
  for (const char letter : kind) stir(static_cast<unsigned char>(letter));
  stir(k);
  stir(0);
  return mixed;
}

void report(std::string_view kind, std::uint64_t seed, std::size_t k, const std::string& instance,
            const std::string& violation) {
  ADD_FAILURE() << kind << ", seed " << seed << ", instance " << k << ": " << violation << "\n" << instance;
}

void summary(std::string_view kind, const Count& count) {
  std::string line(kind);
  line += ": " + std::to_string(count.instances) + " instances, " + std::to_string(count.refused) +
          " refused, " + std::to_string(count.violated) + " violated";
  if (count.values > 0) line += ", " + std::to_string(count.values) + " values held";
  testing::Test::RecordProperty(std::string(kind), line);
  std::printf("[  ATTACK  ] %s\n", line.c_str());
}

}  // namespace radcert::attack::detail
