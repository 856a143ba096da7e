// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "radcert/certificate/certificate.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/json/json_reader.h"
#include "radcert/geometry/vector.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// What certificates of all surfaces have in common as files.

/// The 64 bits of each number in hexadecimal, without the last digits where they are 0 in all of them.
[[nodiscard]] std::string bits_text(std::span<const double> numbers);
/// What bits_text wrote, of so many numbers, after those that are there.
void read_bits(const JsonReader& reader, std::size_t count, std::vector<double>& out);

/// The decimal that reads back as the double nearest to a number: a certificate leaves room for that.
[[nodiscard]] std::string double_text(const Rational& value);

/// A JSON number as a double; InputError for anything else.
[[nodiscard]] double number_from(const JsonReader& reader);
/// An exact number, 0 or from 1e-60 to 1e60 in size, which double can work with.
[[nodiscard]] Rational exact_number(const JsonReader& reader);
[[nodiscard]] Vector<Rational> exact_point(const JsonReader& reader);
[[nodiscard]] Rational decimal_from(const JsonReader& reader);
/// The name of a piece, which a verdict prints.
[[nodiscard]] std::string name_from(const JsonReader& reader);
/// Midpoint and radius, of 0 or more.
[[nodiscard]] certificate::Enclosure read_enclosure(const JsonReader& reader);

/// The content of a certificate of an ellipsoid, without its digest.
[[nodiscard]] JsonValue ellipsoid_content_json(const certificate::EllipsoidCertificate& c,
                                               const std::string& command);
[[nodiscard]] certificate::EllipsoidCertificate read_ellipsoid_content(const JsonReader& reader);

}  // namespace radcert
