// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "radcert/formats/json/json_value.h"
#include "radcert/polynomial/lagrange_functions.h"
#include "radcert/polynomial/nodes/algebraic_nodes.h"
#include "radcert/polynomial/nodes/free_nodes.h"
#include "radcert/polynomial/nodes/symmetric_certificate.h"
#include "radcert/study/triangle_basis_choice.h"

namespace radcert {

/// Nodes of a user's own on the reference triangle, and perhaps a space of functions.
/// Maths     (r + 1)(r + 2)/2 different points of the closed triangle that are unisolvent for the polynomials
///           of degree r; or as many as the space has functions, unisolvent for these
/// Source    the file format radcert/nodes/1
/// Requires  made by read_nodes
/// Result    functions: nodes and Lagrange functions, exactly as the decimals or fractions of the file say;
///           algebraic: the exact nodes of a file with irrational numbers, beside which those of `functions`
///           lie; certificate: what the file claims of nodes close to these, proved again while reading;
///           space: the functions as written, none for all polynomials of a degree; digest: of the file's
///           bytes
struct NodeFile {
  LagrangeFunctions functions;
  std::optional<AlgebraicNodes> algebraic;
  std::optional<SymmetricCertificate> certificate;
  std::optional<std::vector<std::string>> space;
  std::string digest;
};

/// A file of nodes.
/// Maths     each node by its barycentric coordinates, decimals or fractions in strings, with the exact sum
///           1; the functions of a space by polynomials in these coordinates. Coordinates may be expressions
///           in numbers x, y, z of the file, each the one zero of a polynomial in an interval
/// Source    the file format radcert/nodes/1
/// Requires  a file of at most 64 MiB, nested at most 64 deep
/// Result    the nodes; otherwise InputError with file, JSON pointer, value and reason: outside the triangle,
///           repeated, too many or too few, not unisolvent (with the polynomial that vanishes at all of
///           them), a space without the constants (with a point and the sum of its functions there), a
///           certificate that proves nothing, an interval that holds no zero or several of the polynomial of
///           a number
/// Limits    degrees 0 to 12; the nodes of `functions` have irrational numbers rounded to 70 digits; that
///           coordinates lie in the triangle and have the sum 1 is decided for the irrational numbers
///           themselves. Functions that are no polynomials are refused: degrees and norms are exact or
///           enclosed
[[nodiscard]] NodeFile read_nodes(const std::filesystem::path& path);

/// The same from a text; `source` names it in messages.
[[nodiscard]] NodeFile parse_nodes(std::string_view text, const std::string& source);

/// Such nodes as the basis of a problem, which names them so.
/// Result    InputError, with the name, for functions of a degree above largest_basis_degree
[[nodiscard]] TriangleBasisChoice node_file_basis(NodeFile nodes, const std::string& name);

/// Nodes as such a file.
/// Source    the file format radcert/nodes/1
/// Requires  nodes with the exact sum 1
/// Result    fractions with a denominator that divides a power of ten as decimals, others as fractions:
///           nothing is rounded
[[nodiscard]] JsonValue nodes_json(int degree, std::span<const Barycentric<Rational>> nodes);

/// The same with the functions of a space in place of a degree.
[[nodiscard]] JsonValue nodes_json(std::span<const std::string> space,
                                   std::span<const Barycentric<Rational>> nodes);

/// The same for a symmetric set, with the certificate that reading it proves again.
[[nodiscard]] JsonValue nodes_json(const SymmetricNodes& set, const Rational& radius);

/// The same for nodes without symmetry, whose weights the file leaves to the interpolatory rule.
[[nodiscard]] JsonValue nodes_json(const FreeNodes& set, const Rational& radius);

/// An exact number as text: "0.125" where its decimals end, "1/3" elsewhere.
[[nodiscard]] std::string exact_text(const Rational& value);

}  // namespace radcert
