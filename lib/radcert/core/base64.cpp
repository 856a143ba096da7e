// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/base64.h"

#include <algorithm>
#include <openssl/evp.h>

namespace radcert {

namespace {

// OpenSSL counts in int: whole groups of three bytes, of four letters.
constexpr std::size_t groups_at_a_time = std::size_t{1} << 20;

unsigned char* bytes_of(std::string& text, std::size_t at) {
  return reinterpret_cast<unsigned char*>(text.data() + at);
}
const unsigned char* bytes_of(std::string_view text, std::size_t at) {
  return reinterpret_cast<const unsigned char*>(text.data() + at);
}

}  // namespace

std::string base64(std::string_view bytes) {
  // EVP_EncodeBlock ends with a zero, for which there is room behind the last letter.
  std::string out((bytes.size() + 2) / 3 * 4, '\0');
  for (std::size_t done = 0; done < bytes.size(); done += 3 * groups_at_a_time) {
    const std::size_t count = std::min(3 * groups_at_a_time, bytes.size() - done);
    EVP_EncodeBlock(bytes_of(out, done / 3 * 4), bytes_of(bytes, done), static_cast<int>(count));
  }
  return out;
}

std::optional<std::string> from_base64(std::string_view text) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t filled = text.ends_with("==") ? 2 : text.ends_with('=') ? 1 : 0;
  // EVP_DecodeBlock passes over spaces, and takes "=" anywhere.
  if (text.size() % 4 != 0 || text.substr(0, text.size() - filled).find_first_not_of(letters) != text.npos)
    return std::nullopt;
  std::string out(text.size() / 4 * 3, '\0');
  for (std::size_t done = 0; done < text.size(); done += 4 * groups_at_a_time) {
    const std::size_t count = std::min(4 * groups_at_a_time, text.size() - done);
    EVP_DecodeBlock(bytes_of(out, done / 4 * 3), bytes_of(text, done), static_cast<int>(count));
  }
  out.resize(out.size() - filled);
  return out;
}

}  // namespace radcert
