// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/basis_records.h"

#include <optional>
#include <vector>

#include "radcert/core/errors.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/polynomial/nodes/superconvergent_inset.h"
#include "radcert/polynomial/nodes/symmetric_nodes.h"
#include "radcert/scalar/real.h"

namespace radcert::app {

namespace {

// The norm is enclosed to ten digits.
const Rational& norm_tolerance() {
  static const Rational tolerance = 1 / power(Rational(10), 10);
  return tolerance;
}

// Irrational insets are rounded to as many digits as node files have.
const Rational& inset_width() {
  static const Rational width = 1 / power(Rational(10), 60);
  return width;
}

BasisFacts facts_of(const std::vector<Barycentric<Rational>>& nodes) {
  Outcome<LagrangeFunctions, NotUnisolvent> functions = lagrange_functions(nodes);
  if (!functions) throw InputError({.problem = "is not unisolvent: " + functions.reason().to_text()});
  return basis_facts(*functions, norm_tolerance());
}

// Facts that hold for the true nodes; a refusal where that is not decided.
BasisFacts decided(const Outcome<BasisFacts>& facts) {
  if (!facts) throw InputError({.problem = "has nodes that are not decided: " + facts.reason()});
  return *facts;
}

BasisFacts facts_with(const LagrangeFunctions& functions, const SymmetricCertificate& certificate) {
  return decided(certified_facts(basis_facts(functions, norm_tolerance()), functions, certificate));
}

BasisRecord superconvergent_record(int degree, OptionStyle style) {
  const Outcome<NearInset> alpha = superconvergent_inset(degree, inset_width());
  if (!alpha)
    throw InputError({.source = option_name(style, "alpha"),
                      .value = "superconvergent",
                      .problem = "does not exist: " + alpha.reason(),
                      .allowed = "a number in [0, 1/3)"});
  BasisRecord record{.family = "inset",
                     .alpha = "superconvergent",
                     .file = std::nullopt,
                     .space = std::nullopt,
                     .facts = facts_of(inset_nodes(degree, alpha->value))};
  if (!alpha->is_exact) {
    const BallPrecision scope(256);
    const std::vector<Barycentric<Rational>> nodes = inset_nodes(degree, alpha->value);
    const Ball alpha_0 = widened(Ball(alpha->value), Ball(inset_width()));
    record.facts = decided(at_true_nodes(std::move(record.facts), lagrange_functions(nodes).value(),
                                         inset_nodes(degree, alpha_0)));
    record.facts.triangle = precision_at_superconvergent_inset(degree, Region::triangle);
    record.facts.parallelogram = precision_at_superconvergent_inset(degree, Region::parallelogram);
    record.facts.proof = PrecisionProof::algebraic;
  }
  return record;
}

}  // namespace

const Rational& symmetric_radius() {
  static const Rational radius = 1 / power(Rational(10), 59);
  return radius;
}

BasisRecord inset_record(int degree, const std::string& alpha_text, OptionStyle style) {
  const std::string allowed =
      "a decimal or fraction in [0, 1/3), or superconvergent; none is needed at degree 0";
  if (degree > 0 && alpha_text.empty())
    throw InputError({.source = option_name(style, "alpha"), .problem = "is missing", .allowed = allowed});
  if (degree > 0 && alpha_text == "superconvergent") return superconvergent_record(degree, style);
  Rational alpha = 0;
  if (!alpha_text.empty() && alpha_text != "superconvergent") {
    const Outcome<Rational> value = Rational::parse(alpha_text);
    if (!value || value->sign() < 0 || *value >= Rational(1, 3))
      throw InputError({.source = option_name(style, "alpha"), .value = alpha_text, .allowed = allowed});
    alpha = *value;
  }
  BasisRecord record = node_record("inset", inset_nodes(degree, alpha));
  if (degree > 0) record.alpha = alpha.to_text();
  return record;
}

BasisRecord symmetric_record(int degree) {
  const SymmetricNodes& set = symmetric_nodes(degree);
  return certified_record("symmetric", set, certify(set, symmetric_radius()).value());
}

BasisRecord certified_record(const std::string& family, const SymmetricNodes& set,
                             const SymmetricCertificate& certificate) {
  return certified_record(family, set.nodes(), certificate);
}

BasisRecord certified_record(const std::string& family, const std::vector<Barycentric<Rational>>& nodes,
                             const SymmetricCertificate& certificate) {
  return {.family = family,
          .alpha = std::nullopt,
          .file = std::nullopt,
          .space = std::nullopt,
          .facts = facts_with(lagrange_functions(nodes).value(), certificate)};
}

BasisRecord node_record(const std::string& family, const std::vector<Barycentric<Rational>>& nodes) {
  return {.family = family,
          .alpha = std::nullopt,
          .file = std::nullopt,
          .space = std::nullopt,
          .facts = facts_of(nodes)};
}

BasisRecord basis_record(const std::string& name, const NodeFile& file) {
  return {.family = "file",
          .alpha = std::nullopt,
          .file = name,
          .space = file.space,
          .facts = with_source(name, [&] {
            if (file.algebraic)
              return decided(basis_facts(file.functions, *file.algebraic, norm_tolerance()));
            return file.certificate ? facts_with(file.functions, *file.certificate)
                                    : basis_facts(file.functions, norm_tolerance());
          })};
}

}  // namespace radcert::app
