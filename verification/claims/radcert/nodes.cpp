// SPDX-License-Identifier: GPL-3.0-or-later

// Symmetric nodes with the degree of precision that superconvergence asks for.
//
// Checked      symmetric_nodes_superconvergence: for the degrees 2 and 4 to 10 a search finds nodes, and
//              Krawczyk's test proves that nodes beside them are inside the triangle, unisolvent, and those
//              of a rule with the degrees of precision that are claimed. Rejected: the nodes (13) of these
//              degrees at alpha = 1/20.
//              cubic_nodes_without_symmetry: a search finds ten nodes without symmetry, and Krawczyk's test
//              proves the same of nodes beside them; products of degree 6 are certainly missed. Rejected: the
//              symmetric nodes of degree 3 that come with radcert, and for products the nodes (13) at alpha =
//              1/10.
// Not checked  orders, which follow by [m06, Theorems 7, 9]; that nodes of a lesser norm do not exist.

#include <string>

#include "radcert/core/contract.h"
#include "radcert/polynomial/basis_facts.h"
#include "radcert/polynomial/lagrange_functions.h"
#include "radcert/polynomial/nodes/inset_family.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/polynomial/nodes/search/free_search.h"
#include "radcert/polynomial/nodes/search/symmetric_search.h"
#include "radcert/polynomial/nodes/symmetric_certificate.h"
#include "radcert/polynomial/nodes/symmetric_nodes.h"
#include "radcert/polynomial/rules/degree_of_precision.h"
#include "radcert/polynomial/rules/interpolatory_rule.h"
#include "radcert/polynomial/rules/product_precision.h"
#include "verification/framework/check.h"

namespace radcert::verification::radcert {

Finding symmetric_nodes_superconvergence(const Bench&) {
  const BallPrecision precision(512);
  Finding finding;
  for (const int degree : {2, 4, 5, 6, 7, 8, 9, 10}) {
    const SearchResult found =
        search_symmetric_nodes({.degree = degree, .precision = precision_for_orders(degree)},
                               {.starts = 32, .steps = 0}, [](const SearchResult&) { return true; });
    expects(found.best.has_value(), "nodes that the search finds", named("degree", degree));
    const auto certificate = certify(found.best->nodes, 1 / power(Rational(10), 55));
    expects(certificate.has_value(), "a certificate", named("degree", degree));
    const std::string r = ", r = " + std::to_string(degree);
    const LiesIn enough_on_the_triangle{.least = degree + 1, .largest = 2 * degree};
    const LiesIn enough{.least = degree + 3, .largest = 2 * degree + 1};
    finding.require("degree of precision on the triangle" + r, enough_on_the_triangle,
                    Ball(certificate->triangle.degree));
    finding.require("degree of precision on the parallelogram" + r, enough,
                    Ball(certificate->parallelogram.degree));
    if (degree > 5) continue;  // exact arithmetic takes seconds
    const auto inset = lagrange_functions(inset_nodes(degree, Rational(1, 20))).value();
    finding.control("degree of precision on the parallelogram, nodes (13) at alpha = 1/20" + r, enough,
                    Ball(degree_of_precision(interpolatory_rule(inset), Region::parallelogram).degree));
  }
  return finding;
}

Finding cubic_nodes_without_symmetry(const Bench&) {
  constexpr int degree = 3;
  const BallPrecision precision(512);
  Finding finding;
  const FreeSearchResult found = search_free_nodes(free_goal(degree), {.starts = 32, .steps = 0},
                                                   [](const FreeSearchResult&) { return true; });
  expects(found.best.has_value(), "nodes that the search finds", named("degree", degree));
  const Rational radius = 1 / power(Rational(10), 55);
  const auto certificate = certify(found.best->nodes, radius);
  expects(certificate.has_value(), "a certificate", named("degree", degree));
  const auto symmetric = certify(symmetric_nodes(degree), radius);
  expects(symmetric.has_value(), "a certificate of the symmetric nodes", named("degree", degree));
  const LiesIn enough_on_the_triangle{.least = degree + 1, .largest = 2 * degree};
  const LiesIn enough{.least = degree + 3, .largest = 2 * degree + 1};
  finding.require("degree of precision on the triangle", enough_on_the_triangle,
                  Ball(certificate->triangle.degree));
  finding.require("degree of precision on the parallelogram", enough,
                  Ball(certificate->parallelogram.degree));
  const LagrangeFunctions near = lagrange_functions(found.best->nodes.points()).value();
  const Outcome<BasisFacts> facts = certified_facts(basis_facts(near, Rational(1, 1000)), near, *certificate);
  expects(facts.has_value(), "products that are decided", named("degree", degree));
  const IsExactly of_products{degree + 2};
  finding.require("degree up to which products are exact on the parallelogram", of_products,
                  Rational(product_precision(*facts).parallelogram));
  const LagrangeFunctions inset = lagrange_functions(inset_nodes(degree, Rational(1, 10))).value();
  finding.control("the same, nodes (13) at alpha = 1/10", of_products,
                  Rational(product_precision(inset, Region::parallelogram)));
  finding.control("degree of precision on the parallelogram, symmetric nodes", enough,
                  Ball(symmetric->parallelogram.degree));
  return finding;
}

}  // namespace radcert::verification::radcert
