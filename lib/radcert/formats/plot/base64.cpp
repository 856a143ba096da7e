// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/plot/base64.h"

#include <algorithm>
#include <cstdint>

namespace radcert {

std::string base64(std::string_view bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t held = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t three = 0;
    for (std::size_t j = 0; j < 3; ++j)
      three = three << 8U | (j < held ? static_cast<unsigned char>(bytes[i + j]) : 0U);
    for (std::size_t j = 0; j < 4; ++j)
      out += j <= held ? letters[three >> (18U - 6U * static_cast<unsigned>(j)) & 0x3FU] : '=';
  }
  return out;
}

}  // namespace radcert
