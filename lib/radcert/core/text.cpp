// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace radcert {

namespace {

/// The length in bytes of the character that starts at `at`, 0 where none does.
std::size_t utf8_length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) -> unsigned {
    return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0U;
  };
  const auto continues = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return continues(1) ? 2 : 0;
  if (first >= 0xE0 && first <= 0xEF) {
    if (first == 0xE0 && byte(1) < 0xA0) return 0;   // overlong
    if (first == 0xED && byte(1) >= 0xA0) return 0;  // surrogates
    return continues(1) && continues(2) ? 3 : 0;
  }
  if (first >= 0xF0 && first <= 0xF4) {
    if (first == 0xF0 && byte(1) < 0x90) return 0;   // overlong
    if (first == 0xF4 && byte(1) >= 0x90) return 0;  // above U+10FFFF
    return continues(1) && continues(2) && continues(3) ? 4 : 0;
  }
  return 0;
}

/// Characters that do not print or that turn the direction of what follows: C1 controls, U+2028-202E,
/// U+2066-2069, U+FEFF and the like.
bool misleads(std::string_view character) {
  if (character.size() == 2)
    return static_cast<unsigned char>(character[0]) == 0xC2 &&
           static_cast<unsigned char>(character[1]) < 0xA0;
  if (character.size() != 3) return false;
  const unsigned code = ((static_cast<unsigned char>(character[0]) & 0x0FU) << 12U) |
                        ((static_cast<unsigned char>(character[1]) & 0x3FU) << 6U) |
                        (static_cast<unsigned char>(character[2]) & 0x3FU);
  return (code >= 0x200B && code <= 0x200F) || (code >= 0x2028 && code <= 0x202E) ||
         (code >= 0x2060 && code <= 0x206F) || code == 0xFEFF;
}

void append_escaped_byte(std::string& out, char byte) {
  constexpr std::string_view digits = "0123456789abcdef";
  const unsigned value = static_cast<unsigned char>(byte);
  out.append("\\x").push_back(digits[value >> 4U]);
  out.push_back(digits[value & 15U]);
}

}  // namespace

std::string shortest(double value) {
  if (std::isnan(value)) return "nan";
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), end.ptr};
}

std::optional<double> parse_double(std::string_view text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  if (read.ec != std::errc() || read.ptr != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

bool is_utf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8_length(text, at);
    if (length == 0) return false;
    at += length;
  }
  return true;
}

std::string quotation(std::string_view text, std::size_t limit) {
  std::string out = "\"";
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8_length(text, at);
    const std::size_t step = length == 0 ? 1 : length;
    if (at + step > limit) return out + "\"... (" + std::to_string(text.size()) + " bytes)";
    const std::string_view character = text.substr(at, step);
    const unsigned first = static_cast<unsigned char>(character[0]);
    if (character == "\"" || character == "\\") {
      out.append("\\").append(character);
    } else if (character == "\n") {
      out.append("\\n");
    } else if (character == "\t") {
      out.append("\\t");
    } else if (length == 0 || first < 0x20 || first == 0x7F || misleads(character)) {
      for (const char byte : character) append_escaped_byte(out, byte);
    } else {
      out.append(character);
    }
    at += step;
  }
  return out + "\"";
}

std::string listed(std::span<const std::string> words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : ", ") + word;
  return out;
}

}  // namespace radcert
