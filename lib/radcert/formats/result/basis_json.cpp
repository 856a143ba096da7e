// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/result/basis_json.h"

#include <array>
#include <string_view>

#include "radcert/core/text.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/table/csv.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert {

namespace {

// The digits of long coordinates and weights, as in node files.
constexpr int long_digits = 60;

std::string proof_name(PrecisionProof proof) {
  switch (proof) {
    case PrecisionProof::exact: return "exact";
    case PrecisionProof::algebraic: return "algebraic";
    case PrecisionProof::certificate: return "certificate";
  }
  return "exact";
}

int count_with_sign(const BasisFacts& facts, int sign) {
  int count = 0;
  for (const Rational& weight : facts.weights) count += weight.sign() == sign ? 1 : 0;
  return count;
}

/// Of a table: a midpoint with its radius in units of the last digit.
std::string norm_word(const LebesgueConstant& norm) {
  constexpr int digits = 6;
  const Rational middle = Rational(1, 2) * (norm.lower + norm.upper);
  return parenthesised_text(middle, norm.upper - middle, digits);
}

JsonValue precision_json(const EnclosedPrecision& precision, PrecisionProof proof) {
  const BallDecimal defect = precision.defect.decimal(20);
  return JsonValue::object({{"degree", precision.degree},
                            {"first_failure", precision.first_failure.to_text()},
                            {"defect", defect.midpoint},
                            {"defect_radius", defect.radius},
                            {"proof", proof_name(proof)}});
}

JsonValue record_json(const BasisRecord& record) {
  const BasisFacts& facts = record.facts;
  JsonValue out = JsonValue::object();
  out.set("family", record.family);
  out.set("degree", facts.degree);
  out.set("reproduces", facts.reproduced);
  out.set("alpha", record.alpha);
  out.set("file", record.file);
  out.set("space", record.space ? json_array(*record.space) : JsonValue());
  JsonValue nodes = JsonValue::array();
  for (std::size_t j = 0; j < facts.nodes.size(); ++j) {
    nodes.push(JsonValue::object(
        {{"barycentric", json_array(facts.nodes[j].x,
                                    [](const Rational& x) { return JsonValue(readable(x, long_digits)); })},
         {"weight", readable(facts.weights[j], long_digits)}}));
  }
  out.set("nodes", std::move(nodes));
  out.set("weight_signs", JsonValue::object({{"positive", count_with_sign(facts, 1)},
                                             {"zero", count_with_sign(facts, 0)},
                                             {"negative", count_with_sign(facts, -1)}}));
  out.set("unisolvent", true);
  out.set("determinant", readable(facts.determinant, 20));
  out.set("precision",
          JsonValue::object({{"triangle", precision_json(facts.triangle, facts.proof)},
                             {"parallelogram", precision_json(facts.parallelogram, facts.proof)}}));
  const ProductPrecision of_products = product_precision(facts);
  out.set("product_precision", JsonValue::object({{"triangle", of_products.triangle},
                                                  {"parallelogram", of_products.parallelogram}}));
  out.set("norm", JsonValue::object({{"lower", finite_or_null(Ball(facts.norm.lower).lower_double())},
                                     {"upper", finite_or_null(Ball(facts.norm.upper).upper_double())},
                                     {"near", json_array(facts.norm.near.x)}}));
  out.set("condition", finite_or_null(Ball(facts.condition).upper_double()));
  const PredictedOrders predicted = record.orders();
  out.set("orders", JsonValue::object({{"everywhere", predicted.everywhere},
                                       {"nodes_smooth", predicted.curved},
                                       {"nodes_smooth_logarithm", predicted.curved_has_logarithm},
                                       {"nodes_smooth_kernel", predicted.smooth_kernel},
                                       {"nodes_at_edges", predicted.at_edges}}));
  return out;
}

}  // namespace

std::string readable(const Rational& value, int digits) {
  std::string exact = value.to_text();
  constexpr std::size_t short_length = 24;
  if (exact.size() <= short_length) return exact;
  return nearest_text(value, DecimalForm::padded(digits));
}

EnclosingText norm_text(const LebesgueConstant& norm, int digits) {
  const Rational middle = Rational(1, 2) * (norm.lower + norm.upper);
  return enclosing_text(middle, norm.upper - middle, DecimalForm::padded(digits));
}

std::string upper_readable(const Rational& bound, int digits) {
  const std::string exact = readable(bound, digits);
  if (bound.to_text() == exact) return exact;
  return "<= " + upper_text(bound, DecimalForm::padded(digits));
}

std::string order_text(int order, bool has_logarithm) {
  return (order == 1 ? std::string("h") : "h^" + std::to_string(order)) + (has_logarithm ? " |log h|" : "");
}

JsonValue basis_record_json(std::span<const BasisRecord> records, const std::string& command) {
  JsonValue out = document_head("basis", command);
  out.set("bases", json_array(records, record_json));
  return out;
}

std::string basis_csv(std::span<const BasisRecord> records) {
  constexpr std::array<std::string_view, 6> columns = {"degree", "node", "x1", "x2", "x3", "weight"};
  CsvTable table(columns);
  for (const BasisRecord& record : records)
    for (std::size_t j = 0; j < record.facts.nodes.size(); ++j) {
      const Barycentric<Rational>& q = record.facts.nodes[j];
      const std::array<JsonValue, 6> row = {
          record.facts.degree,           j,
          readable(q.x[0], long_digits), readable(q.x[1], long_digits),
          readable(q.x[2], long_digits), readable(record.facts.weights[j], long_digits)};
      table.add(row);
    }
  return table.text();
}

std::string basis_latex(std::span<const BasisRecord> records) {
  std::string out =
      "\\begin{tabular}{rrrrrrll}\n"
      "$r$ & nodes & negative weights & triangle & parallelogram & $\\|P_n\\|$ & everywhere & at nodes \\\\\n"
      "\\hline\n";
  for (const BasisRecord& record : records) {
    const BasisFacts& facts = record.facts;
    const PredictedOrders orders = record.orders();
    const auto power = [](int order) { return "$h^{" + std::to_string(order) + "}$"; };
    out += std::to_string(facts.degree) + " & " + std::to_string(facts.nodes.size()) + " & " +
           std::to_string(count_with_sign(facts, -1)) + " & " + std::to_string(facts.triangle.degree) +
           " & " + std::to_string(facts.parallelogram.degree) + " & " + norm_word(facts.norm) + " & " +
           power(orders.everywhere) + " & " +
           (orders.curved_has_logarithm ? "$h^{" + std::to_string(orders.curved) + "} |\\log h|$"
                                        : power(orders.curved)) +
           " \\\\\n";
  }
  return out + "\\end{tabular}\n";
}

}  // namespace radcert
