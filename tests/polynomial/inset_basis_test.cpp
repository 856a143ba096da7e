// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/inset_basis.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/laws/basis_laws.h"

namespace radcert {
namespace {

using Points = std::vector<Barycentric<Rational>>;

const Rational exact = 0;
constexpr int largest = InsetBasis<Rational>::largest_degree;

/// 0, the superconvergent insets, and insets next to 1/3.
std::vector<Rational> insets() {
  return {0,
          Rational(1, 10),
          Rational(1, 8),
          Rational(1, 7),
          Rational(1, 6),
          Rational(1, 4),
          Rational(33, 100),
          Rational(333333, 1000000),
          Rational(1, 3) - Rational(1, 1L << 40)};
}

/// Every member of the family, with a title for messages.
template <class Visit>
void for_each_basis(const Visit& visit) {
  for (int degree = 0; degree <= largest; ++degree)
    for (const Rational& inset : insets())
      visit(InsetBasis<Rational>(degree, inset),
            "degree " + std::to_string(degree) + ", inset " + inset.to_text());
}

TEST(InsetBasis, IsOneAtItsNodeAndZeroAtTheOthers) {
  for_each_basis([](const InsetBasis<Rational>& basis, const std::string& title) {
    EXPECT_TRUE(laws::is_one_at_its_node_and_zero_at_the_others(basis, exact)) << title;
  });
}

TEST(InsetBasis, IsAPartitionOfUnity) {
  const Points points = laws::points_of_the_plane<Rational>(1);
  for_each_basis([&](const InsetBasis<Rational>& basis, const std::string& title) {
    EXPECT_TRUE(laws::is_a_partition_of_unity(basis, std::span<const Barycentric<Rational>>(points), exact))
        << title;
  });
}

TEST(InsetBasis, ReproducesPolynomialsOfItsDegreeAndNoOther) {
  const Points points = laws::points_of_the_plane<Rational>(2, 4);
  const std::span<const Barycentric<Rational>> span(points);
  for_each_basis([&](const InsetBasis<Rational>& basis, const std::string& title) {
    EXPECT_TRUE(laws::reproduces_polynomials(basis, basis.degree(), span, exact)) << title;
    EXPECT_FALSE(laws::reproduces_polynomials(basis, basis.degree() + 1, span, exact)) << title;
  });
}

TEST(InsetBasis, HasSymmetricNodesInTheTriangle) {
  for_each_basis([](const InsetBasis<Rational>& basis, const std::string& title) {
    EXPECT_TRUE(laws::has_symmetric_nodes_in_the_triangle(basis, exact)) << title;
  });
}

TEST(InsetBasis, KeepsItsNodesTheInsetAwayFromTheSides) {
  for_each_basis([](const InsetBasis<Rational>& basis, const std::string& title) {
    if (basis.degree() == 0) return;
    Rational least = 1;
    for (const Barycentric<Rational>& q : basis.nodes())
      for (const Rational& x : q.x) least = std::min(least, x);
    EXPECT_EQ(least, basis.inset()) << title;
  });
}

TEST(InsetBasis, HasTheNodesOfMicula) {
  // [m06, (13)]: q_ij = ((i + (r-3i) alpha)/r, (j + (r-3j) alpha)/r) = (s,t); ordered by falling u, then
  // falling t.
  for (int r = 1; r <= largest; ++r)
    for (const Rational& alpha : insets()) {
      Points expected;
      for (int k = r; k >= 0; --k)
        for (int j = r - k; j >= 0; --j) {
          const int i = r - k - j;
          const Rational s = (Rational(i) + Rational(r - 3 * i) * alpha) / Rational(r);
          const Rational t = (Rational(j) + Rational(r - 3 * j) * alpha) / Rational(r);
          expected.push_back({{Rational(1) - s - t, t, s}});
        }
      EXPECT_EQ(InsetBasis<Rational>(r, alpha).nodes(), expected) << r << " " << alpha.to_text();
      EXPECT_EQ(expected.size(), static_cast<std::size_t>((r + 1) * (r + 2) / 2));
    }
}

TEST(InsetBasis, OfDegreeOneIsTheLinearBasisOfAtkinsonAndChandler) {
  // [ac98, (33)]: nodes (s,t) = (a,a), (a,1-2a), (1-2a,a); l_1, l_2, l_3 = (u-a, t-a, s-a)/(1-3a).
  for (const Rational& a : insets()) {
    const InsetBasis<Rational> basis(1, a);
    const Rational far = Rational(1) - Rational(2) * a;
    EXPECT_EQ(basis.nodes(), (Points{{{far, a, a}}, {{a, far, a}}, {{a, a, far}}}));
    for (const Barycentric<Rational>& x : laws::points_of_the_plane<Rational>(3)) {
      std::vector<Rational> l(3);
      basis.values(x, l);
      for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(l[i], (x.x[i] - a) / (Rational(1) - Rational(3) * a));
    }
  }
}

TEST(InsetBasis, OfDegreeZeroIsOneAtTheCentroidWhateverTheInset) {
  for (const Rational& alpha : {Rational(0), Rational(1, 6), Rational(7)}) {
    const InsetBasis<Rational> basis(0, alpha);
    const Rational third(1, 3);
    EXPECT_EQ(basis.nodes(), (Points{{{third, third, third}}}));
    EXPECT_EQ(basis.inset(), Rational(0));
    for (const Barycentric<Rational>& x : laws::points_of_the_plane<Rational>(4)) {
      std::vector<Rational> l(1);
      basis.values(x, l);
      EXPECT_EQ(l[0], Rational(1));
    }
  }
}

TEST(InsetBasis, InDoubleIsTheExactOneRounded) {
  // 1/8 and the points k/64 are exact in double. A factor r y - a carries the rounding of r y, so that what
  // is left is small beside the largest of the functions at the point.
  for (int degree = 0; degree <= largest; ++degree) {
    const InsetBasis<Rational> truth(degree, Rational(1, 8));
    const InsetBasis<double> basis(degree, 0.125);
    const Points at = laws::points_of_the_plane<Rational>(5);
    const std::vector<Barycentric<double>> rounded = laws::points_of_the_plane<double>(5);
    for (std::size_t k = 0; k < at.size(); ++k) {
      std::vector<Rational> l(truth.size());
      std::vector<double> l_double(basis.size());
      truth.values(at[k], l);
      basis.values(rounded[k], l_double);
      double size = 1;
      for (const Rational& value : l) size = std::max(size, std::abs(value.to_double()));
      for (std::size_t i = 0; i < l.size(); ++i)
        EXPECT_NEAR(l_double[i], l[i].to_double(), 32 * std::numeric_limits<double>::epsilon() * size)
            << degree << " " << i;
    }
  }
}

TEST(InsetBasis, RefusesDegreesAndInsetsOutOfRange) {
  EXPECT_THROW(InsetBasis<Rational>(-1, Rational(1, 6)), ContractViolation);
  EXPECT_THROW(InsetBasis<Rational>(largest + 1, Rational(1, 6)), ContractViolation);
  for (const Rational& inset : {Rational(1, 3), Rational(1, 2), Rational(-1, 1000000)})
    EXPECT_THROW(InsetBasis<Rational>(1, inset), ContractViolation) << inset.to_text();
  EXPECT_THROW(InsetBasis<double>(1, 1.0 / 3), ContractViolation);
  EXPECT_THROW(InsetBasis<double>(1, std::numeric_limits<double>::quiet_NaN()), ContractViolation);
}

}  // namespace
}  // namespace radcert
