// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/result/stored_numbers.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "radcert/core/base64.h"
#include "radcert/core/files/result_store.h"
#include "radcert/core/version.h"
#include "radcert/formats/problem/problem_json.h"

namespace radcert {
namespace {

/// Eight bytes a number, the lowest first.
std::string bytes_of(std::span<const double> numbers) {
  std::string bytes;
  bytes.reserve(numbers.size() * sizeof(double));
  for (const double x : numbers) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    for (unsigned shift = 0; shift < 64; shift += 8)
      bytes.push_back(static_cast<char>(bits >> shift & 0xffU));
  }
  return bytes;
}

std::vector<double> numbers_of(std::string_view bytes) {
  std::vector<double> numbers;
  numbers.reserve(bytes.size() / sizeof(double));
  for (std::size_t first = 0; first + sizeof(double) <= bytes.size(); first += sizeof(double)) {
    std::uint64_t bits = 0;
    for (std::size_t k = sizeof(double); k-- > 0;)
      bits = bits << 8U | static_cast<unsigned char>(bytes[first + k]);
    numbers.push_back(std::bit_cast<double>(bits));
  }
  return numbers;
}

}  // namespace

std::optional<std::vector<double>> StoredNumbers::find(const std::string& name) {
  const std::optional<std::string> text = store_.get(key_ + "\n" + name);
  if (!text) return std::nullopt;
  const std::optional<std::string> bytes = from_base64(*text);
  if (!bytes) return std::nullopt;
  return numbers_of(*bytes);
}

void StoredNumbers::keep(const std::string& name, std::span<const double> numbers) {
  static_cast<void>(store_.put(key_ + "\n" + name, base64(bytes_of(numbers))));
}

std::string guarantee_key(const Problem& problem, bool with_certificate) {
  Problem alone = problem;
  alone.label.clear();
  return std::string(with_certificate ? "certify " : "enclose ") + std::string(source_digest()) + " " +
         problem_json(alone).compact();
}

}  // namespace radcert
