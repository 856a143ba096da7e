// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "radcert/certificate/certificate.h"

namespace radcert {

/// A certificate as a file.
/// Source    formats/schema/certificate.json
/// Requires  as many pieces, elements and claims as belong together
/// Result    JSON on one line: exact numbers as decimals or fractions in strings, doubles so that they read
///           back, coefficients as the 64 bits of each in hexadecimal, without the last digits where they are
///           0 for a whole function. `digest` is digest_of the same line without it
[[nodiscard]] std::string certificate_text(const certificate::Certificate& certificate,
                                           const std::string& command);

/// A certificate that was read, and the digest of its content.
struct ReadCertificate {
  certificate::Certificate certificate;
  std::string digest;
  bool digest_holds = false;  ///< whether it is the one that the file states
};

/// Reads what certificate_text wrote.
/// Requires  nothing
/// Result    the certificate, whose lists have the lengths that belong together, numbers finite and from
///           1e-60 to 1e60 in size or 0 where they are data; otherwise InputError with the JSON pointer.
///           Whether it is true is the business of certificate::check
[[nodiscard]] ReadCertificate read_certificate(std::string_view text, const std::string& source);

/// The same of a file that is as it was written; InputError where its digest is not that of the content.
[[nodiscard]] certificate::Certificate intact_certificate(std::string_view text, const std::string& source);

}  // namespace radcert
