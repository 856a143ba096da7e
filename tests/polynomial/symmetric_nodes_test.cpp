// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/nodes/symmetric_nodes.h"

#include <gtest/gtest.h>

#include <map>

#include "radcert/polynomial/nodes/symmetric_certificate.h"
#include "radcert/polynomial/rules/interpolatory_rule.h"
#include "tests/polynomial/node_sets.h"

namespace radcert {
namespace {

Rational ten_to_minus(int digits) { return 1 / power(Rational(10), digits); }

const std::map<int, std::pair<int, int>> precisions = {{1, {2, 3}}, {2, {4, 5}}, {3, {5, 5}},
                                                       {4, {7, 7}}, {5, {9, 9}}, {6, {10, 11}}};

TEST(SymmetricNodes, AreCertified) {
  const BallPrecision scope(256);
  for (const auto& [degree, expected] : precisions) {
    const SymmetricNodes& set = symmetric_nodes(degree);
    EXPECT_EQ(set.degree, degree);
    const Outcome<SymmetricCertificate> proof = certify(set, ten_to_minus(59));
    ASSERT_TRUE(proof) << degree << ": " << proof.reason();
    EXPECT_EQ(proof->triangle.degree, expected.first) << degree;
    EXPECT_EQ(proof->parallelogram.degree, expected.second) << degree;
    EXPECT_EQ(proof->triangle.first_failure, (Monomial{expected.first + 1, 0})) << degree;
    Ball sum(0);
    for (const Ball& weight : proof->rule.weights) {
      EXPECT_TRUE(certainly_positive(weight)) << degree;
      sum += weight;
    }
    EXPECT_TRUE(sum.contains(Rational(1, 2))) << degree;
    // Exact arithmetic at the printed digits.
    if (degree <= 4) {
      const LagrangeFunctions functions = functions_of(set.nodes());
      const TriangleRule<Rational> rule = interpolatory_rule(functions);
      const Ball near(ten_to_minus(50));
      EXPECT_TRUE(overlaps(widened(proof->determinant, near), Ball(functions.determinant()))) << degree;
      EXPECT_TRUE(overlaps(widened(proof->triangle.defect, near),
                           Ball(defect(rule, Region::triangle, proof->triangle.first_failure))));
      EXPECT_TRUE(overlaps(widened(proof->parallelogram.defect, near),
                           Ball(defect(rule, Region::parallelogram, proof->parallelogram.first_failure))));
    }
    const std::vector<Barycentric<Rational>> nodes = set.nodes();
    ASSERT_EQ(nodes.size(), proof->rule.points.size());
    for (std::size_t j = 0; j < nodes.size(); ++j)
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_TRUE(
            certainly_less(abs(proof->rule.points[j].x[i] - Ball(nodes[j].x[i])), Ball(3 * ten_to_minus(59))))
            << degree;
  }
}

// Exact arithmetic at the printed digits, all monomials, no invariant polynomials.
TEST(SymmetricNodes, HaveDefectsBelowTheirDigits) {
  for (const auto& [degree, expected] : precisions) {
    if (degree > 5) continue;  // exact arithmetic takes seconds
    const TriangleRule<Rational> rule = interpolatory_rule(functions_of(symmetric_nodes(degree).nodes()));
    for (const auto& [region, precision] :
         {std::pair(Region::triangle, expected.first), std::pair(Region::parallelogram, expected.second)})
      for (int total = 0; total <= precision + 1; ++total) {
        Rational largest = 0;
        for (int t = 0; t <= total; ++t)
          largest = std::max(largest, abs(defect(rule, region, {total - t, t})));
        if (total <= precision)
          EXPECT_LE(largest, ten_to_minus(59)) << degree << " " << total;
        else
          EXPECT_GE(largest, ten_to_minus(9)) << degree;
      }
  }
}

TEST(SymmetricNodes, OfDegreeTwoAreTheClassicalSixPoints) {
  const BallPrecision scope(256);
  const Outcome<SymmetricCertificate> proof = certify(symmetric_nodes(2), ten_to_minus(55));
  ASSERT_TRUE(proof);
  // a = (8 - sqrt 10 +- sqrt(38 - 44 sqrt(2/5)))/18
  const Ball root = sqrt(Ball(38) - Ball(44) * sqrt(Ball(Rational(2, 5))));
  for (const int sign : {-1, 1}) {
    const Ball a = (Ball(8) - sqrt(Ball(10)) + Ball(sign) * root) / Ball(18);
    const std::size_t place = sign < 0 ? 0 : 3;
    EXPECT_TRUE(overlaps(a, proof->rule.points[place].x[1]))
        << a.to_text() << " " << proof->rule.points[place].x[1].to_text();
    // w = (620 +- sqrt(213125 - 53320 sqrt 10))/7440, of the area 1/2
    const Ball w = (Ball(620) + Ball(sign) * sqrt(Ball(213125) - Ball(53320) * sqrt(Ball(10)))) / Ball(7440);
    EXPECT_TRUE(overlaps(w, proof->rule.weights[place])) << w.to_text();
  }
}

TEST(Certify, RefusesWhatIsNotSo) {
  const Rational radius = ten_to_minus(30);
  const auto refused = [&](const SymmetricNodes& set, const char* why) {
    const Outcome<SymmetricCertificate> proof = certify(set, radius);
    ASSERT_FALSE(proof) << why;
    EXPECT_NE(proof.reason().find(why), std::string::npos) << proof.reason();
  };
  SymmetricNodes moved = symmetric_nodes(2);
  moved.orbits[0].a += ten_to_minus(20);
  refused(moved, "does not lie inside");
  SymmetricNodes modest = symmetric_nodes(2);
  modest.precision = 5;
  refused(modest, "4 unknowns for the 5 invariant polynomials");
  SymmetricNodes held = symmetric_nodes(2);
  held.orbits[0].is_held = true;
  refused(held, "3 unknowns for the 4");
  // Held at the coordinate that has precision 4, of which 3 is claimed: not where the precision ends.
  held.precision = 3;
  refused(held, "no monomial of degree 4 is certainly missed");
  // One orbit of six and none of three would do.
  SymmetricNodes wrong{.degree = 3,
                       .precision = 3,
                       .orbits = {{.size = 1},
                                  {.size = 3, .a = Rational(5, 97)},
                                  {.size = 3, .a = Rational(17, 97)},
                                  {.size = 3, .a = Rational(41, 97)}}};
  EXPECT_FALSE(certify(wrong, radius));
  wrong.orbits.pop_back();
  refused(wrong, "7 nodes in place of 10");
  // The midpoints of the sides: precision 2, but not inside.
  refused({.degree = 1, .precision = 2, .orbits = {{.size = 3, .a = Rational(1, 2)}}},
          "not certainly inside");
  EXPECT_THROW(static_cast<void>(certify(symmetric_nodes(1), 0)), ContractViolation);
  EXPECT_THROW(static_cast<void>(certify({.degree = 2, .precision = 1, .orbits = {}}, 1)), ContractViolation);
}

// The nodes with the coordinates 2/3, 1/6, 1/6 are exact for degree 2. At them (x_1 - 1/6)(x_2 - x_3)
// vanishes, so that they determine no function of the space that it spans with 1 and x_1; nodes beside them
// do.
TEST(Certify, RefusesNodesThatAreNotUnisolvent) {
  const SymmetricNodes beside{
      .degree = 2, .precision = 2, .orbits = {{.size = 3, .a = Rational(1, 6) + ten_to_minus(40)}}};
  PlanePolynomial<Rational> one(0);
  one(0, 0) = 1;
  PlanePolynomial<Rational> first(1);
  first(0, 0) = 1, first(1, 0) = -1, first(0, 1) = -1;
  PlanePolynomial<Rational> vanishing(2);  // (5/6 - s - t)(t - s)
  vanishing(0, 1) = Rational(5, 6), vanishing(1, 0) = Rational(-5, 6), vanishing(2, 0) = 1,
               vanishing(0, 2) = -1;
  const std::vector<PlanePolynomial<Rational>> space{one, first, vanishing};
  const Outcome<SymmetricCertificate> proof = certify(beside, ten_to_minus(30), space);
  ASSERT_FALSE(proof);
  EXPECT_EQ(proof.reason(), "the true nodes are not certainly unisolvent");
  PlanePolynomial<Rational> other = vanishing;
  other(0, 1) = 1;
  const std::vector<PlanePolynomial<Rational>> sound{one, first, other};
  EXPECT_TRUE(certify(beside, ten_to_minus(30), sound));
}

// The zero is unique in the box: it encloses the digits of the set that comes with radcert.
TEST(Certify, EnclosesTheSameNodesFromAFarStart) {
  const BallPrecision scope(256);
  SymmetricNodes rough = symmetric_nodes(2);
  for (SymmetricOrbit& orbit : rough.orbits) orbit.a += ten_to_minus(5);
  const Outcome<SymmetricCertificate> proof = certify(rough, ten_to_minus(4));
  ASSERT_TRUE(proof) << proof.reason();
  const std::vector<Barycentric<Rational>> sharp = symmetric_nodes(2).nodes();
  for (std::size_t j = 0; j < sharp.size(); ++j)
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_TRUE(overlaps(proof->rule.points[j].x[i], widened(Ball(sharp[j].x[i]), Ball(ten_to_minus(60)))));
}

TEST(Certify, RefusesABoxInWhichTheZeroIsNot) {
  for (const int degree : {1, 2}) {
    SymmetricNodes rough = symmetric_nodes(degree);
    for (SymmetricOrbit& orbit : rough.orbits)
      if (orbit.size == 3 && !orbit.is_held) orbit.a += ten_to_minus(20);
    EXPECT_TRUE(certify(rough, ten_to_minus(18))) << degree;
    EXPECT_FALSE(certify(rough, ten_to_minus(21))) << degree;
    EXPECT_FALSE(certify(rough, ten_to_minus(22))) << degree;
  }
}

TEST(SymmetricNodes, RefuseWhatIsOutOfRange) {
  EXPECT_THROW(static_cast<void>(symmetric_nodes(0)), ContractViolation);
  EXPECT_THROW(static_cast<void>(symmetric_nodes(7)), ContractViolation);
  EXPECT_THROW(static_cast<void>(symmetric_places(2)), ContractViolation);
}

}  // namespace
}  // namespace radcert
