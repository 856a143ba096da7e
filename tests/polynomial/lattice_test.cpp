// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/nodes/lattice.h"

#include <gtest/gtest.h>

#include "radcert/polynomial/inset_basis.h"
#include "radcert/scalar/rational.h"

namespace radcert {
namespace {

TEST(Lattice, HasTheDimensionOfThePolynomialSpace) {
  for (int degree = 0; degree <= 20; ++degree) {
    EXPECT_EQ(lattice_indices(degree).size(), polynomial_dimension(degree));
    EXPECT_EQ(degree_of_dimension(polynomial_dimension(degree)), degree);
  }
  EXPECT_EQ(polynomial_dimension(12), 91U);
  for (const std::size_t between : {0U, 2U, 4U, 5U, 7U, 9U, 11U, 90U, 92U})
    EXPECT_FALSE(degree_of_dimension(between).has_value()) << between;
}

TEST(Lattice, KnowsThePlaceOfEachIndex) {
  for (int degree = 0; degree <= 13; ++degree) {
    const std::vector<std::array<int, 3>> indices = lattice_indices(degree);
    for (std::size_t place = 0; place < indices.size(); ++place) {
      EXPECT_EQ(lattice_place(indices[place]), place);
      EXPECT_EQ(indices[place][0] + indices[place][1] + indices[place][2], degree);
    }
  }
}

TEST(Lattice, OfAnyDegreeIsPulledInByTheInset) {
  const Rational inset(1, 10);
  const std::vector<Barycentric<Rational>> nodes = inset_nodes(12, inset);
  ASSERT_EQ(nodes.size(), 91U);
  EXPECT_EQ(nodes.front(), (Barycentric<Rational>{{Rational(8, 10), inset, inset}}));
  EXPECT_EQ(nodes.back(), (Barycentric<Rational>{{inset, inset, Rational(8, 10)}}));
}

TEST(Lattice, RefusesInsetsAndDegreesOutOfRange) {
  EXPECT_THROW(static_cast<void>(inset_nodes(1, Rational(1, 3))), ContractViolation);
  EXPECT_THROW(static_cast<void>(inset_nodes(1, Rational(-1, 1000000))), ContractViolation);
  EXPECT_THROW(static_cast<void>(inset_nodes(-1, Rational(0))), ContractViolation);
  EXPECT_THROW(static_cast<void>(polynomial_dimension(1001)), ContractViolation);
}

}  // namespace
}  // namespace radcert
