// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace radcert::fuzz {

/// One of the things that radcert reads from a user.
/// Result    `read` takes any bytes: it returns, or throws an error that is the input's fault; everything
///           else is a defect
struct Reader {
  std::string name;  ///< of its folder of seeds and its dictionary
  std::function<void(std::string_view)> read;
};

/// All of them.
[[nodiscard]] std::span<const Reader> readers();
[[nodiscard]] const Reader* find_reader(std::string_view name);

/// Reads the bytes; throws std::logic_error with the words of what should not have been thrown.
void read_any(const Reader& reader, std::string_view bytes);

/// The files of tests/fuzz/seeds/<name>, each a valid input, and the words of its dictionary.
[[nodiscard]] std::vector<std::string> seeds_of(const Reader& reader);
[[nodiscard]] std::vector<std::string> words_of(const Reader& reader);

}  // namespace radcert::fuzz
