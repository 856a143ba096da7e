// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "radcert/core/embedded_file.h"

namespace radcert {

/// SHA-256 of some bytes.
/// Maths     256 bits, as 64 hexadecimal digits in lower case
/// Source    NIST FIPS 180-4, by OpenSSL's libcrypto
/// Requires  nothing
/// Result    exact; EnvironmentError where libcrypto refuses the function
/// Limits    two contents with one value are not known, and nobody knows how to make them
[[nodiscard]] std::string sha256(std::string_view bytes);

/// The name of a content, by which it is told from every other: of a mesh, a node file, a scene, a stored
/// result.
/// Maths     sha256(bytes)
/// Source    as sha256
/// Requires  nothing
/// Result    "sha256-" and 64 hexadecimal digits, the same for the same bytes
/// Limits    as sha256
[[nodiscard]] std::string digest_of(std::string_view bytes);

/// The name of a folder of files.
/// Maths     digest_of(the path and the sha256 of each file, in their order, a line each)
/// Source    as sha256
/// Requires  paths without line feeds
/// Result    changes with any path, any byte and the order
/// Limits    as sha256
[[nodiscard]] std::string digest_of(std::span<const EmbeddedFile> files);

/// Words as one text, by which they are told from all others whatever they hold: "1:a4:b, c".
/// Maths     of each word the number of its bytes, a colon and itself
/// Requires  nothing
/// Result    exact: lists with one text are one list
[[nodiscard]] std::string length_prefixed(std::span<const std::string> words);

/// Whether a text has the form of digest_of.
[[nodiscard]] bool is_digest(std::string_view text);

}  // namespace radcert
