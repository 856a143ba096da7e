// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/problem/node_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "radcert/core/errors.h"
#include "radcert/core/files/atomic_file.h"
#include "radcert/expression/parse.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/json/json_reader.h"
#include "radcert/formats/problem/polynomial_expression.h"
#include "radcert/polynomial/nodes/free_nodes.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/scalar/real.h"
#include "tests/core/refusal.h"

namespace radcert {
namespace {

std::string refusal(const std::string& text) {
  return test::refusal_of([&] { return parse_nodes(text, "own.json"); });
}

using testing::HasSubstr;

constexpr const char* four_nodes =
    R"([["3/5", "1/5", "1/5"], ["1/5", "3/5", "1/5"], ["1/5", "1/5", "3/5"], ["1/3", "1/3", "1/3"]])";

std::string file_text(const std::string& space, const std::string& nodes = four_nodes) {
  return R"({"schema": "radcert/nodes/1", "space": )" + space + R"(, "nodes": )" + nodes + "}";
}

Outcome<PlanePolynomial<Rational>> polynomial(const std::string& text) {
  return polynomial_of(parse_expression(text, ExpressionVariables::barycentric).value(), 8);
}

TEST(PolynomialExpression, IsMultipliedOutExactly) {
  for (const auto& [text, degree] : std::vector<std::pair<std::string, int>>{{"x1 + x2 + x3", 0},
                                                                             {"27*x1*x2*x3", 3},
                                                                             {"(x1 - x2)^2*(x3 - 1/3)/2", 3},
                                                                             {"-x2^3 + x2^3 + 0.25*x1", 1},
                                                                             {"(1 - x1 - x2)^4", 4},
                                                                             {"x1^0", 0},
                                                                             {"(x1 - x1)*x2^8", 0}}) {
    const Expression e = parse_expression(text, ExpressionVariables::barycentric).value();
    const PlanePolynomial<Rational> p = polynomial(text).value();
    EXPECT_EQ(p.degree(), degree) << text;
    const std::vector<Rational> c = bernstein_coefficients(p, 5);
    for (const auto& [s, t] :
         {std::pair(Rational(1, 7), Rational(2, 3)), std::pair(Rational(-2), Rational(5, 4))}) {
      const double value = p.value(s, t).to_double();
      const Rational x1 = 1 - s - t;
      // The expression evaluates in double, x1, x2, x3 in the place of x, y, z.
      std::string in_space = text;
      for (const auto& [name, letter] : {std::pair("x1", "x"), std::pair("x2", "y"), std::pair("x3", "z")})
        for (std::size_t at = in_space.find(name); at != std::string::npos; at = in_space.find(name))
          in_space.replace(at, 2, letter);
      const double expected =
          parse_expression(in_space).value().evaluate<double>({x1.to_double(), t.to_double(), s.to_double()});
      EXPECT_NEAR(value, expected, 1e-12 * (1 + std::abs(expected))) << text;
      Rational sum = 0;
      const std::vector<std::array<int, 3>> indices = lattice_indices(5);
      for (std::size_t k = 0; k < indices.size(); ++k) {
        Rational term = c[k];
        int above = 0;
        for (std::size_t i = 0; i < 3; ++i) {
          const Rational x = i == 0 ? x1 : (i == 1 ? t : s);
          for (int m = 1; m <= indices[k][i]; ++m) term *= x * Rational(++above, m);
        }
        sum += term;
      }
      EXPECT_EQ(sum, p.value(s, t)) << text;
    }
    if (degree > 0) {
      EXPECT_THROW(static_cast<void>(bernstein_coefficients(p, degree - 1)), ContractViolation);
    }
  }
}

TEST(PolynomialExpression, SaysWhyItIsNone) {
  for (const auto& [text, why] : std::vector<std::pair<std::string, std::string>>{
           {"sqrt(x1)", "has sqrt and is no polynomial"},
           {"pi*x1", "has pi, which is no fraction, and is no polynomial"},
           {"x1/x2", "divides by a coordinate"},
           {"x1/(x2 - x2)", "divides by zero"},
           {"x1^(1/2)", "has an exponent that is not a whole number from 0 to 8"},
           {"x1^-1", "has an exponent that is not a whole number"},
           {"x1^5*x2^4", "has a product of degree 9"},
           {"x1^9", "has an exponent that is not a whole number from 0 to 8"},
           {"max(x1, x2)", "has max and is no polynomial"}}) {
    const auto outcome = polynomial(text);
    ASSERT_FALSE(outcome.has_value()) << text;
    EXPECT_THAT(outcome.reason(), HasSubstr(why)) << text;
  }
}

TEST(NodeFile, HoldsASpaceOfOnesOwn) {
  const NodeFile file = parse_nodes(file_text(R"(["x1", "x2", "x3", "27*x1*x2*x3"])"), "own.json");
  EXPECT_EQ(file.functions.size(), 4U);
  EXPECT_EQ(file.functions.degree(), 3);
  EXPECT_EQ(file.functions.reproduced_degree(), 1);
  ASSERT_TRUE(file.space.has_value());
  EXPECT_EQ(file.space->back(), "27*x1*x2*x3");
  // The same space by other functions, and read back as it is written.
  const NodeFile other = parse_nodes(file_text(R"(["1", "x1 - x2", "x2*2", "x1*x2*x3 - x1/7"])"), "own.json");
  const NodeFile again = parse_nodes(nodes_json(*file.space, file.functions.nodes()).pretty(), "own.json");
  EXPECT_NE(other.digest, file.digest);
  for (const NodeFile* same : {&other, &again})
    for (std::size_t j = 0; j < 4; ++j) {
      const auto one = file.functions.bernstein_coefficients(j);
      const auto two = same->functions.bernstein_coefficients(j);
      EXPECT_TRUE(std::equal(one.begin(), one.end(), two.begin(), two.end())) << j;
    }
}

TEST(NodeFile, RefusesSpacesWithTheReason) {
  for (const auto& [text, said] : std::vector<std::pair<std::string, std::string>>{
           {file_text(R"(["x1", "x2", "x3"])"), "has 4 nodes: too many"},
           {file_text(R"(["x1", "x2", "x3", "x1*x2", "x2*x3"])"), "has 4 nodes: too few"},
           {file_text("[]"), "has 0 functions"},
           {file_text(R"(["x1", "x2", "x3", "y"])"), "/space/3"},
           {file_text(R"f(["x1", "x2", "x3", "exp(x1)"])f"), "has exp and is no polynomial"},
           {file_text(R"(["x1", "x2", "x3", "x1 + x2"])"), "linearly dependent"},
           {file_text(R"(["x1", "x2", "x3", "x1*x2 + x2*x3 + x3*x1 - 7/25"])"), ""},
           {file_text(R"f(["x1", "x2", "x3", "(x1 - x2)*(x2 - x3)*(x3 - x1)"])f"),
            "a function of the space other than zero vanishes at all 4 nodes"},
           {file_text(R"(["x1", "x2", "x3^2", "x1*x2*x3"])"),
            "does not contain the constants: the interpolant of 1"},
           {R"({"schema": "radcert/nodes/1", "space": ["1"], "nodes": [["1/3", "1/3", "1/3"]],
               "certificate": {"method": "krawczyk", "precision": 2, "radius": "1e-9",
                               "orbits": [{"size": 1, "held": false}]}})",
            "1 unknowns for the 2 invariant polynomials"},
           {R"({"schema": "radcert/nodes/1", "degree": 1, "space": ["1"], "nodes": []})",
            "stands beside a space"}}) {
    const std::string message = refusal(text);
    EXPECT_EQ(message.empty(), said.empty()) << text << message;
    EXPECT_THAT(message, HasSubstr(said)) << text;
  }
}

std::string with_number(const std::string& polynomial, const std::string& between) {
  return R"({"schema": "radcert/nodes/1", "degree": 1, "numbers": {"x": {"polynomial": )" + polynomial +
         R"(, "between": )" + between + R"(}}, "nodes": [["1 - 2*x", "x", "x"], ["x", "1 - 2*x", "x"],
            ["x", "x", "1 - 2*x"]]})";
}

TEST(NodeFile, HasCoordinatesThatAreZerosOfPolynomials) {
  // (7 - sqrt 34)/15
  const NodeFile file = parse_nodes(with_number(R"(["1", "-14", "15"])", R"(["0.07", "0.08"])"), "own.json");
  const Rational x = file.functions.nodes()[0].x[1];
  EXPECT_LE(abs(15 * x * x - 14 * x + 1), 20 / power(Rational(10), 70));
  EXPECT_EQ(file.functions.nodes()[2].x[2], 1 - 2 * x);
  const NodeFile exact = parse_nodes(with_number(R"(["-1", 6])", R"([0, "1/3"])"), "own.json");
  EXPECT_EQ(exact.functions.nodes()[0].x[1], Rational(1, 6));
}

std::string with_root_of_two(const std::string& nodes, int degree) {
  return R"({"schema": "radcert/nodes/1", "degree": )" + std::to_string(degree) +
         R"(, "numbers": {"x": {"polynomial": [-2, 0, 1], "between": [1, 2]}}, "nodes": )" + nodes + "}";
}

// Six nodes whose rule is exact of degree 4, of which 70 digits are exact of degree 2 only.
TEST(NodeFile, KeepsAlgebraicNodesExactly) {
  const std::string number =
      R"({"polynomial": ["3888/5", "-15552", "93312", "-186624", "104976"], "between": )";
  const NodeFile file = parse_nodes(
      R"({"schema": "radcert/nodes/1", "degree": 2, "numbers": {"x": )" + number +
          R"(["0.09", "0.1"]}, "y": )" + number +
          R"(["0.44", "0.45"]}}, "nodes": [["1-2*x", "x", "x"], ["x", "1-2*x", "x"], ["x", "x", "1-2*x"],
          ["1-2*y", "y", "y"], ["y", "1-2*y", "y"], ["y", "y", "1-2*y"]]})",
      "own.json");
  ASSERT_TRUE(file.algebraic.has_value());
  const Rational tolerance(1, 1000);
  const BasisFacts facts = basis_facts(file.functions, *file.algebraic, tolerance).value();
  EXPECT_EQ(facts.triangle.degree, 4);
  EXPECT_EQ(facts.parallelogram.degree, 5);
  EXPECT_EQ(facts.proof, PrecisionProof::algebraic);
  const BasisFacts rounded = basis_facts(file.functions, tolerance);
  EXPECT_EQ(rounded.triangle.degree, 2);
  EXPECT_LE(facts.norm.lower, rounded.norm.lower);
  EXPECT_GE(facts.norm.upper, rounded.norm.upper);
  // A number that is rational leaves nothing irrational.
  EXPECT_FALSE(parse_nodes(with_number(R"(["-1", 6])", R"([0, "1/3"])"), "own.json").algebraic.has_value());
  EXPECT_TRUE(parse_nodes(with_number(R"(["1", "-14", "15"])", R"(["0.07", "0.08"])"), "own.json")
                  .algebraic.has_value());
}

// Sums, signs and zeros of coordinates are those of the irrational numbers, not of their digits.
TEST(NodeFile, DecidesAboutIrrationalCoordinatesExactly) {
  // On a side and at a corner, as x^2 - 2 = 0 and 3 - x^2 = 1; digits of x would put these nodes beside them,
  // inside or outside.
  const NodeFile file = parse_nodes(
      with_root_of_two(
          R"f([["x*x - 2", "x - 1", "2 - x"], ["3 - x*x", "(2 - x*x)/x", "0"], ["0", "0", "1"]])f", 1),
      "own.json");
  EXPECT_EQ(file.functions.nodes()[0].x[0], 0);
  EXPECT_EQ(file.functions.nodes()[0].x[1] + file.functions.nodes()[0].x[2], 1);
  EXPECT_EQ(file.functions.nodes()[1].x[0], 1);
  EXPECT_EQ(file.functions.nodes()[1].x[1], 0);
  // Of three roundings the sum is not 1, of the three numbers it is.
  const NodeFile thirds =
      parse_nodes(with_root_of_two(R"f([["1/(x + 1)", "1/(x + 1)", "3 - 2*x"]])f", 0), "own.json");
  const std::array<Rational, 3>& near = thirds.functions.nodes()[0].x;
  EXPECT_EQ(near[0] + near[1] + near[2], 1);
  const auto one_node = [](const std::string& x1, const std::string& x2, const std::string& x3) {
    return with_root_of_two("[[\"" + x1 + "\", \"" + x2 + "\", \"" + x3 + "\"]]", 0);
  };
  const Rational digits = file.functions.nodes()[0].x[1];
  const std::string tiny = "1/1" + std::string(80, '0');
  for (const auto& [text, said] : std::vector<std::pair<std::string, std::string>>{
           // The digits of the number make the sum of the fractions 1, and not that of the numbers.
           {one_node("x - 1", digits.to_text(), (1 - 2 * digits).to_text()), "has the sum"},
           {one_node("x - 1", "1", "1 - x + " + tiny), "outside the triangle"},
           {one_node("2 - x*x - " + tiny, "1", "0"), "outside the triangle"},
           {one_node("1/(x*x - 2)", "1", "0"), "divides by zero"},
           {one_node("x^2", "1", "0"), "another operation"}}) {
    const std::string message = refusal(text);
    EXPECT_THAT(message, HasSubstr(said)) << text;
  }
}

TEST(NodeFile, RefusesIntervalsThatDoNotIsolate) {
  for (
      const auto& [text, said] : std::vector<std::pair<std::string, std::string>>{
          {with_number(R"(["1", "-14", "15"])", R"(["0.2", "0.3"])"), "holds no zero of 15 x^2 - 14 x + 1"},
          {with_number(R"(["1", "-14", "15"])", R"(["0", "1"])"), "holds 2 zeros"},
          {with_number(R"(["1", "-14", "15"])", R"(["1", "0"])"), "has the larger one first"},
          {with_number(R"(["1", "-14", "15"])", R"(["1"])"), "has 1 numbers"},
          {with_number(R"(["1", "0"])", R"(["0", "1"])"), "is constant"},
          {with_number(R"(["0.9", "-1"])", R"(["0", "1"])"), "outside the triangle"},
          {R"({"schema": "radcert/nodes/1", "degree": 0, "numbers": {"x": {"polynomial": [0, 1], "between": [0, 1]}},
                "nodes": [["y", "1/3", "1/3"]]})",
           "does not define"}}) {
    const std::string message = refusal(text);
    EXPECT_THAT(message, HasSubstr(said)) << text;
  }
}

// Ten cubic nodes of a published table, whose certificate holds the numbers that were chosen and no others.
TEST(NodeFile, ProvesNodesWithoutSymmetryAgain) {
  const std::string text =
      read_file(std::string(RADCERT_SOURCE_DIR) + "/papers/radcert/tables/free_3.json", 1 << 20);
  const NodeFile file = parse_nodes(text, "own.json");
  ASSERT_TRUE(file.certificate.has_value());
  EXPECT_EQ(file.certificate->triangle.degree, 4);
  EXPECT_EQ(file.certificate->parallelogram.degree, 7);
  EXPECT_LE(file.certificate->radius, 1 / power(Rational(10), 59));
  const JsonValue document = parse_json(text, "own.json");
  const std::vector<JsonReader> held = JsonReader(document).at("certificate", "").at("held", "").elements("");
  ASSERT_EQ(held.size(), 10u);
  FreeNodes set{.degree = 3, .triangle = 4, .parallelogram = 6, .nodes = {}};
  for (std::size_t j = 0; j < held.size(); ++j) {
    const std::array<Rational, 3>& x = file.functions.nodes()[j].x;
    FreeNode node{.s = x[2], .t = x[1]};
    for (const JsonReader& name : held[j].elements(""))
      (name.string("") == "x2" ? node.holds_t : node.holds_s) = true;
    // What was chosen is the true coordinate, of which the others are sixty digits.
    const std::array<Ball, 3>& proved = file.certificate->rule.points[j].x;
    EXPECT_EQ(proved[1].contains(x[1]), node.holds_t) << j;
    EXPECT_EQ(proved[2].contains(x[2]), node.holds_s) << j;
    set.nodes.push_back(node);
  }
  const Rational radius = file.certificate->radius;
  const NodeFile again = parse_nodes(nodes_json(set, radius).pretty(), "own.json");
  EXPECT_EQ(again.functions.nodes(), file.functions.nodes());
  EXPECT_EQ(again.certificate->parallelogram.degree, 7);

  const auto with = [&](const auto& change) {
    FreeNodes changed = set;
    change(changed);
    return refusal(nodes_json(changed, radius).pretty());
  };
  EXPECT_THAT(with([](FreeNodes& n) { n.nodes[4].s += Rational(1, 1000000); }), HasSubstr("proves nothing"));
  EXPECT_THAT(with([](FreeNodes& n) { n.parallelogram = 7; }), HasSubstr("/certificate/parallelogram"));
  EXPECT_THAT(with([](FreeNodes& n) { n.parallelogram = 8; }), HasSubstr("unknowns for"));
  EXPECT_THAT(with([](FreeNodes& n) { n.triangle = 2; }), HasSubstr("/certificate/precision"));
  EXPECT_THAT(with([](FreeNodes& n) { n.nodes[0].holds_s = !n.nodes[0].holds_s; }),
              HasSubstr("unknowns for"));
  const auto replaced = [&](const std::string& old, const std::string& put) {
    std::string other = text;
    other.replace(other.find(old), old.size(), put);
    return refusal(other);
  };
  EXPECT_THAT(replaced("\"x2\"", "\"x1\""), HasSubstr("/certificate/held"));
  EXPECT_THAT(replaced("\"held\"", "\"orbits\": [], \"held\""), HasSubstr("orbits"));
  EXPECT_THAT(replaced("\"held\": [", "\"held\": [[],"), HasSubstr("is for 11 nodes"));
}

// The files that come with radcert: their certificates hold, and they are the sets of the library.
TEST(NodeFile, OfEachSymmetricSetIsShippedWithItsCertificate) {
  const std::string folder = std::string(RADCERT_SOURCE_DIR) + "/apps/examples/nodes/symmetric_";
  for (int degree = smallest_symmetric_degree; degree <= largest_symmetric_degree; ++degree) {
    const NodeFile file = read_nodes(folder + std::to_string(degree) + ".json");
    const SymmetricNodes& set = symmetric_nodes(degree);
    EXPECT_EQ(file.functions.nodes(), set.nodes()) << degree;
    ASSERT_TRUE(file.certificate.has_value()) << degree;
    EXPECT_EQ(file.certificate->triangle.degree, set.precision) << degree;
    EXPECT_LE(file.certificate->radius, 1 / power(Rational(10), 59)) << degree;
  }
}

}  // namespace
}  // namespace radcert
