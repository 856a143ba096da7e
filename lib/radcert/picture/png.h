// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "radcert/picture/image.h"

namespace radcert {

/// An image as a PNG file.
/// Source    ISO/IEC 15948, by libpng
/// Requires  a description of printable ASCII, else ContractViolation
/// Result    the bytes of the file: 8-bit RGB, the chunk sRGB, the texts `Software` (radcert and its version)
///           and `Description`; no time: the same image and description give the same bytes with the same
///           libpng and zlib
/// Limits    the whole file is held in memory. bad_alloc where memory does not do
[[nodiscard]] std::string png_bytes(const Image& image, const std::string& description);

}  // namespace radcert
