// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/mesh_file/base64_text.h"

#include <array>
#include <cstdint>

namespace radcert {
namespace {

constexpr std::uint32_t no_letter = 64;

std::uint32_t letter(char c) {
  if (c >= 'A' && c <= 'Z') return static_cast<std::uint32_t>(c - 'A');
  if (c >= 'a' && c <= 'z') return static_cast<std::uint32_t>(c - 'a' + 26);
  if (c >= '0' && c <= '9') return static_cast<std::uint32_t>(c - '0' + 52);
  return c == '+' ? 62U : c == '/' ? 63U : no_letter;
}

}  // namespace

std::optional<std::string> from_base64(std::string_view text) {
  if (text.size() % 4 != 0) return std::nullopt;
  std::string out;
  out.reserve(text.size() / 4 * 3);
  for (std::size_t at = 0; at < text.size(); at += 4) {
    std::size_t filled = 0;
    if (at + 4 == text.size()) filled = text.ends_with("==") ? 2 : text.ends_with('=') ? 1 : 0;
    std::uint32_t four = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t value = k < 4 - filled ? letter(text[at + k]) : 0;
      if (value == no_letter) return std::nullopt;
      four = four << 6U | value;
    }
    for (std::size_t k = 0; k < 3 - filled; ++k) out += static_cast<char>(four >> (16U - 8U * k) & 0xFFU);
  }
  return out;
}

}  // namespace radcert
