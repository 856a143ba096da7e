// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/digest.h"

#include <openssl/evp.h>

#include <algorithm>
#include <array>

#include "radcert/core/errors.h"

namespace radcert {
namespace {

constexpr std::size_t sha256_bytes = 32;
constexpr std::string_view digest_prefix = "sha256-";
constexpr std::string_view hexadecimal_digits = "0123456789abcdef";

}  // namespace

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, sha256_bytes> value{};
  unsigned int length = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), value.data(), &length, EVP_sha256(), nullptr) != 1 ||
      length != sha256_bytes)
    throw EnvironmentError("libcrypto", "does not compute SHA-256 here");
  std::string out;
  out.reserve(2 * sha256_bytes);
  for (const unsigned char byte : value) {
    out.push_back(hexadecimal_digits[byte >> 4U]);
    out.push_back(hexadecimal_digits[byte & 15U]);
  }
  return out;
}

std::string digest_of(std::string_view bytes) { return std::string(digest_prefix) + sha256(bytes); }

std::string digest_of(std::span<const EmbeddedFile> files) {
  std::string lines;
  for (const EmbeddedFile& file : files) lines += sha256(file.content) + " " + std::string(file.path) + "\n";
  return digest_of(lines);
}

std::string length_prefixed(std::span<const std::string> words) {
  std::string out;
  for (const std::string& word : words) out += std::to_string(word.size()) + ":" + word;
  return out;
}

bool is_digest(std::string_view text) {
  if (!text.starts_with(digest_prefix)) return false;
  const std::string_view digits = text.substr(digest_prefix.size());
  return digits.size() == 2 * sha256_bytes && std::all_of(digits.begin(), digits.end(), [](char digit) {
           return hexadecimal_digits.find(digit) != std::string_view::npos;
         });
}

}  // namespace radcert
