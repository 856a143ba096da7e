// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/nodes/search/symmetric_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/polynomial/basis_facts.h"
#include "radcert/polynomial/nodes/inset_family.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/polynomial/nodes/orbit_structure.h"
#include "radcert/polynomial/nodes/symmetric_certificate.h"
#include "radcert/polynomial/rules/degree_of_precision.h"
#include "radcert/polynomial/rules/interpolatory_rule.h"
#include "tests/polynomial/node_sets.h"

namespace radcert {
namespace {

bool goes_on(const SearchResult& /*so_far*/) { return true; }

// Points of a lattice are permuted as nodes are; and the dimensions of what the permutations leave as it is,
// and of what changes its sign, are the numbers of orbits, and of those of six.
TEST(OrbitStructure, IsThatOfALatticeAndOfTheInvariants) {
  for (int degree = 0; degree <= 60; ++degree) {
    const OrbitStructure structure = orbit_structure(degree);
    OrbitStructure counted;
    for (const auto& [i, j, k] : lattice_indices(degree)) {
      if (i < j || j < k) continue;
      ++(i == k ? counted.ones : i == j || j == k ? counted.threes : counted.sixes);
    }
    EXPECT_EQ(structure.ones, counted.ones) << degree;
    EXPECT_EQ(structure.threes, counted.threes) << degree;
    EXPECT_EQ(structure.sixes, counted.sixes) << degree;
    EXPECT_EQ(structure.orbits(), invariant_count(degree)) << degree;
    EXPECT_EQ(structure.sixes, invariant_count(degree - 3)) << degree;
  }
  for (int degree = 1; degree <= 6; ++degree) {
    OrbitStructure known;
    for (const SymmetricOrbit& orbit : symmetric_nodes(degree).orbits)
      ++(orbit.size == 1 ? known.ones : orbit.size == 3 ? known.threes : known.sixes);
    EXPECT_EQ(orbit_structure(degree).threes, known.threes) << degree;
    EXPECT_EQ(orbit_structure(degree).sixes, known.sixes) << degree;
    EXPECT_LE(symmetric_nodes(degree).precision, largest_regular_precision(degree)) << degree;
  }
}

TEST(OrbitStructure, CountsPolynomialsThatPermutationsLeave) {
  // By Molien's series, 1/((1 - t^2)(1 - t^3)) for those that are homogeneous in the differences, summed.
  std::vector<int> series(61, 0);
  series[0] = 1;
  for (const int step : {2, 3})
    for (std::size_t n = static_cast<std::size_t>(step); n < series.size(); ++n)
      series[n] += series[n - static_cast<std::size_t>(step)];
  int sum = 0;
  for (int degree = 0; degree <= 60; ++degree) {
    sum += series[static_cast<std::size_t>(degree)];
    EXPECT_EQ(invariant_count(degree), sum) << degree;
  }
  EXPECT_EQ(invariant_count(-1), 0);
}

TEST(SymmetricSearch, FindsSetsThatAreProved) {
  for (const auto& [degree, precision] : {std::pair(2, 4), {3, 5}, {4, 7}, {5, 8}, {5, 9}, {7, 10}}) {
    const SearchResult found = search_symmetric_nodes({.degree = degree, .precision = precision},
                                                      {.starts = 64, .steps = 40}, goes_on);
    ASSERT_TRUE(found.best) << degree;
    EXPECT_EQ(found.starts, 64);
    EXPECT_GE(found.solutions, 1);
    const SymmetricNodes& nodes = found.best->nodes;
    EXPECT_EQ(nodes.degree, degree);
    const Outcome<SymmetricCertificate> proof = certify(nodes, 1 / power(Rational(10), 59));
    ASSERT_TRUE(proof) << degree << ": " << proof.reason();
    EXPECT_GE(proof->triangle.degree, precision) << degree;
    for (const Barycentric<Rational>& q : nodes.nodes())
      for (const Rational& x : q.x) EXPECT_GT(x, Rational(99, 100'000)) << degree;
    if (degree > 4) continue;  // exact arithmetic takes seconds
    const BasisFacts facts = basis_facts(functions_of(nodes.nodes()), Rational(1, 1000));
    EXPECT_LE(found.best->norm, facts.norm.upper.to_double() * (1 + 1e-9)) << degree;
    EXPECT_GE(found.best->norm, 0.95 * facts.norm.lower.to_double()) << degree;
  }
}

// What the parallelogram adds, for rules of which both degrees are computed.
TEST(SymmetricSearch, KnowsThePrecisionOnTheParallelogram) {
  for (int degree = 0; degree <= 6; ++degree)
    for (const Rational& alpha : {Rational(1, 6), Rational(1, 10), Rational(1, 20), Rational(1, 4)}) {
      const TriangleRule<Rational> rule = interpolatory_rule(functions_of(inset_nodes(degree, alpha)));
      const int on_triangle = degree_of_precision(rule, Region::triangle).degree;
      EXPECT_EQ(degree_of_precision(rule, Region::parallelogram).degree, parallelogram_precision(on_triangle))
          << degree << " " << alpha.to_text();
    }
}

TEST(SymmetricSearch, FindsNodesOfALesserNormWhereLessIsAsked) {
  const SearchResult any =
      search_symmetric_nodes({.degree = 4, .precision = 4}, {.starts = 32, .steps = 300}, goes_on);
  const SearchResult precise =
      search_symmetric_nodes({.degree = 4, .precision = 7}, {.starts = 32, .steps = 300}, goes_on);
  ASSERT_TRUE(any.best && precise.best);
  EXPECT_LT(any.best->norm, precise.best->norm);
  // Decimals, nothing held: they are the nodes.
  for (const SymmetricOrbit& orbit : any.best->nodes.orbits) EXPECT_FALSE(orbit.is_held);
  // Below that of all inset nodes of the degree.
  const BasisFacts facts = basis_facts(functions_of(any.best->nodes.nodes()), Rational(1, 1000));
  for (int k = 0; k <= 10; ++k) {
    const BasisFacts inset = basis_facts(functions_of(inset_nodes(4, Rational(k, 200))), Rational(1, 1000));
    EXPECT_LT(facts.norm.upper, inset.norm.lower) << k;
  }
}

TEST(SymmetricSearch, GivesTheSameForAnyNumberOfThreadsAndStopsWhenAsked) {
  const SymmetricGoal goal{.degree = 5, .precision = 8, .positive = true};
  const auto with = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    return search_symmetric_nodes(goal, {.starts = 40, .steps = 40, .seed = 7}, goes_on);
  };
  const SearchResult one = with(1);
  const SearchResult three = with(3);
  ASSERT_TRUE(one.best && three.best);
  EXPECT_EQ(one.solutions, three.solutions);
  EXPECT_EQ(one.best->norm, three.best->norm);
  ASSERT_EQ(one.best->nodes.orbits.size(), three.best->nodes.orbits.size());
  for (std::size_t k = 0; k < one.best->nodes.orbits.size(); ++k) {
    EXPECT_EQ(one.best->nodes.orbits[k].a, three.best->nodes.orbits[k].a);
    EXPECT_EQ(one.best->nodes.orbits[k].b, three.best->nodes.orbits[k].b);
  }
  const Outcome<SymmetricCertificate> proof = certify(one.best->nodes, 1 / power(Rational(10), 59));
  ASSERT_TRUE(proof) << proof.reason();
  for (const Ball& weight : proof->rule.weights) EXPECT_TRUE(certainly_positive(weight));
  int asked = 0;
  const SearchResult stopped =
      search_symmetric_nodes(goal, {.starts = 1000, .steps = 0}, [&](const SearchResult& so_far) {
        EXPECT_EQ(so_far.starts, 32);
        ++asked;
        return false;
      });
  EXPECT_EQ(asked, 2);  // after the starts, and told of the steps
  EXPECT_EQ(stopped.starts, 32);
}

TEST(SymmetricSearch, SaysWhatCannotBeLookedFor) {
  EXPECT_EQ(precision_for_orders(1), 2);
  EXPECT_EQ(precision_for_orders(2), 4);
  EXPECT_EQ(precision_for_orders(3), 4);  // 5 on the parallelogram, as 5 on the triangle has
  EXPECT_EQ(precision_for_parallelogram(3), 4);
  EXPECT_EQ(precision_for_orders(4), 6);
  EXPECT_EQ(precision_for_parallelogram(9), 16);
  for (const int degree : {4, 5, 7, 8, 9, 10}) {
    const int precision = precision_for_orders(degree);
    EXPECT_GE(parallelogram_precision(precision), degree + 3) << degree;
    // From there on orders do not grow.
    const PredictedOrders orders = predicted_orders(degree, precision, parallelogram_precision(precision));
    const PredictedOrders beyond = predicted_orders(degree, precision + 4, precision + 4);
    EXPECT_EQ(orders.curved, beyond.curved) << degree;
    EXPECT_LE(precision, precision_for_parallelogram(degree)) << degree;
    EXPECT_EQ(parallelogram_precision(precision_for_parallelogram(degree)),
              parallelogram_precision(largest_regular_precision(degree)))
        << degree;
    EXPECT_FALSE(orders.curved_has_logarithm) << degree;
    EXPECT_FALSE(hindrance({.degree = degree, .precision = precision})) << degree;
    EXPECT_FALSE(hindrance({.degree = degree, .precision = degree})) << degree;
    EXPECT_TRUE(hindrance({.degree = degree, .precision = largest_regular_precision(degree) + 1})) << degree;
  }
  // 12 numbers and 7 equations with 5 orbits; 20 and 10 with 8.
  EXPECT_FALSE(hindrance({.degree = 5, .precision = 6}));
  EXPECT_TRUE(hindrance({.degree = 7, .precision = 8}));
  EXPECT_THROW(static_cast<void>(
                   search_symmetric_nodes({.degree = 7, .precision = 8}, {.starts = 1, .steps = 0}, goes_on)),
               ContractViolation);
  EXPECT_THROW(static_cast<void>(
                   search_symmetric_nodes({.degree = 5, .precision = 8}, {.starts = 0, .steps = 0}, goes_on)),
               ContractViolation);
}

}  // namespace
}  // namespace radcert
