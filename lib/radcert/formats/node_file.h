// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "radcert/formats/json_value.h"
#include "radcert/polynomial/lagrange_functions.h"
#include "radcert/polynomial/symmetric_certificate.h"

namespace radcert {

/// Nodes of a user's own on the reference triangle.
/// Maths     (r + 1)(r + 2)/2 different points of the closed triangle that are unisolvent
/// Source    the file format radcert/nodes/1
/// Requires  made by read_nodes
/// Result    functions: nodes and Lagrange functions, exactly as the decimals or fractions of the file say; certificate: what the
///           file claims of nodes close to these, proved again while reading
/// Limits    -
struct NodeFile {
  LagrangeFunctions functions;
  std::optional<SymmetricCertificate> certificate;
};

/// A file of nodes.
/// Maths     each node by its barycentric coordinates, decimals or fractions in strings, with the exact sum 1
/// Source    the file format radcert/nodes/1
/// Requires  a file of at most 64 MiB, nested at most 64 deep
/// Result    the nodes; otherwise InputError with file, JSON pointer, value and reason: outside the triangle, repeated, too many or
///           too few, not unisolvent (with the polynomial that vanishes at all of them), a certificate that proves nothing
/// Limits    degrees 0 to 12
[[nodiscard]] NodeFile read_nodes(const std::filesystem::path& path);

/// The same from a text; `source` names it in messages.
[[nodiscard]] NodeFile parse_nodes(std::string_view text, const std::string& source);

/// Nodes as such a file.
/// Maths     none
/// Source    the file format radcert/nodes/1
/// Requires  nodes with the exact sum 1
/// Result    fractions with a denominator that divides a power of ten as decimals, others as fractions: nothing is rounded
/// Limits    -
[[nodiscard]] JsonValue nodes_json(int degree, std::span<const Barycentric<Rational>> nodes);

/// The same for a symmetric set, with the certificate that reading it proves again.
[[nodiscard]] JsonValue nodes_json(const SymmetricNodes& set, const Rational& radius);

/// An exact number as text: "0.125" where its decimals end, "1/3" elsewhere.
[[nodiscard]] std::string exact_text(const Rational& value);

}  // namespace radcert
