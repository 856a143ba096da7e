// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "radcert/formats/json/json_value.h"
#include "radcert/polynomial/basis_facts.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert {

/// A basis with the words by which it was asked for.
struct BasisRecord {
  std::string family;                ///< "inset", "symmetric", "file"
  std::optional<std::string> alpha;  ///< as it was asked for
  std::optional<std::string> file;
  std::optional<std::vector<std::string>> space;  ///< of the file; absent: all polynomials of a degree
  BasisFacts facts;
  [[nodiscard]] PredictedOrders orders() const { return predicted_orders(facts); }
};

/// The facts of bases as JSON.
/// Source    the file format radcert/basis/1
/// Requires  nothing
/// Result    exact numbers as strings, rounded to the nearest of 60 digits where they are long; the norm
///           between doubles that enclose it
/// Limits    the same bits on every run, apart from `command`
[[nodiscard]] JsonValue basis_record_json(std::span<const BasisRecord> records, const std::string& command);

/// The nodes and weights, a row each: degree, node, x1, x2, x3, weight.
[[nodiscard]] std::string basis_csv(std::span<const BasisRecord> records);

/// A table in LaTeX, a row a basis: degree, nodes, degrees of precision, norm, condition, orders.
[[nodiscard]] std::string basis_latex(std::span<const BasisRecord> records);

/// An exact number for people: as it stands where that is short, else rounded to nearest with so many digits,
/// trailing zeros included: the number is then within half a unit of the last one.
[[nodiscard]] std::string readable(const Rational& value, int digits);

/// A bound for people: as it stands where that is short, else "<= " and so many digits, rounded up.
[[nodiscard]] std::string upper_readable(const Rational& bound, int digits);

/// The norm of interpolation with a radius that reaches both of its bounds.
[[nodiscard]] EnclosingText norm_text(const LebesgueConstant& norm, int digits);

/// "h^4", "h^4 |log h|".
[[nodiscard]] std::string order_text(int order, bool has_logarithm);

}  // namespace radcert
