// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/result/certificate_parts.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "radcert/core/control_characters.h"
#include "radcert/core/text.h"

namespace radcert {
namespace {

constexpr std::size_t digits_of_a_double = 16;
constexpr std::string_view hexadecimal = "0123456789abcdef";

constexpr const char* what_a_number_is = "a finite number";

}  // namespace

std::string bits_text(std::span<const double> numbers) {
  std::uint64_t all = 0;
  for (const double x : numbers) all |= std::bit_cast<std::uint64_t>(x);
  constexpr int least_digits = 3;
  const int dropped = std::min(all == 0 ? 64 : std::countr_zero(all), 64 - 4 * least_digits) / 4;
  std::string out;
  out.reserve(numbers.size() * digits_of_a_double);
  for (const double x : numbers) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    for (int shift = 60; shift >= 4 * dropped; shift -= 4)
      out += hexadecimal[(bits >> static_cast<unsigned>(shift)) & 15U];
  }
  return out;
}

void read_bits(const JsonReader& reader, std::size_t count, std::vector<double>& out) {
  const std::string what = std::to_string(count) +
                           " numbers, each as the first of the 16 hexadecimal digits of its 64 bits, as many "
                           "for all of them";
  const std::string& text = reader.string(what);
  const std::size_t digits = count == 0 ? 0 : text.size() / count;
  if (text.size() != count * digits || digits > digits_of_a_double || (count > 0 && digits == 0))
    reader.refuse("has " + std::to_string(text.size()) + " characters", what);
  for (std::size_t i = 0; i < count; ++i) {
    std::uint64_t bits = 0;
    for (std::size_t d = 0; d < digits; ++d) {
      const std::size_t digit = hexadecimal.find(text[i * digits + d]);
      if (digit == std::string_view::npos) reader.refuse("has a character that is no digit", what);
      bits = bits << 4U | digit;
    }
    bits <<= 4U * (digits_of_a_double - digits);
    const auto value = std::bit_cast<double>(bits);
    if (!(std::abs(value) <= 1e60))
      reader.refuse("has a number that is not finite or too large, number " + std::to_string(i),
                    "finite numbers of at most 1e60");
    out.push_back(value);
  }
}

std::string double_text(const Rational& value) { return shortest(value.to_double()); }

double number_from(const JsonReader& reader) { return reader.number(what_a_number_is); }

Rational exact_number(const JsonReader& reader) {
  const std::string what = "a decimal or fraction in a string, 0 or from 1e-60 to 1e60 in size";
  (void)reader.string(what);
  Rational value = reader.rational(what);
  Rational most = 1;
  for (int k = 0; k < 60; ++k) most *= Rational(10);
  if (value.sign() != 0 && (abs(value) > most || abs(value) * most < Rational(1)))
    reader.refuse("is too large or too small", what);
  return value;
}

Vector<Rational> exact_point(const JsonReader& reader) {
  const std::vector<JsonReader> x = reader.elements("three coordinates");
  if (x.size() != 3) reader.refuse("is not a point", "three coordinates");
  return {exact_number(x[0]), exact_number(x[1]), exact_number(x[2])};
}

Rational decimal_from(const JsonReader& reader) {
  (void)reader.string("a decimal in a string");
  return reader.rational("a decimal in a string");
}

std::string name_from(const JsonReader& reader) {
  const std::string& name = reader.string("a name");
  if (has_control_characters(name)) reader.refuse("has control characters", "names of printable characters");
  return name;
}

certificate::Enclosure read_enclosure(const JsonReader& reader) {
  const JsonReader radius = reader.at("radius", "a decimal");
  certificate::Enclosure out{decimal_from(reader.at("midpoint", "a decimal")), decimal_from(radius)};
  if (out.radius.sign() < 0) radius.refuse("is negative", "0 or more");
  return out;
}

}  // namespace radcert
