// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/laws/basis_laws.h"

#include "radcert/polynomial/inset_basis.h"

namespace radcert::laws {
namespace {

constexpr std::uint64_t seed = 20260101;
const Rational exact = 0;

/// Linear interpolation at the corners with one planted fault.
struct Corners {
  enum class Fault { none, scaled_function, node_outside, node_on_a_side, function_too_many };
  Fault fault = Fault::none;

  int degree() const { return 1; }
  std::size_t size() const { return fault == Fault::function_too_many ? 4 : 3; }
  std::vector<Barycentric<Rational>> nodes() const {
    std::vector<Barycentric<Rational>> q{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}};
    if (fault == Fault::node_outside) q[2] = {{Rational(-1, 8), 0, Rational(9, 8)}};
    if (fault == Fault::node_on_a_side) q[2] = {{Rational(1, 8), 0, Rational(7, 8)}};
    return q;
  }
  void values(const Barycentric<Rational>& x, std::span<Rational> out) const {
    for (std::size_t i = 0; i < 3; ++i) out[i] = x.x[i];
    if (fault == Fault::scaled_function) out[1] = out[1] * Rational(1000001, 1000000);
  }
};

bool obeys_all(const Corners& basis) {
  const auto points = points_of_the_plane<Rational>(seed);
  const std::span<const Barycentric<Rational>> span(points);
  return is_one_at_its_node_and_zero_at_the_others(basis, exact) &&
         is_a_partition_of_unity(basis, span, exact) && reproduces_polynomials(basis, 1, span, exact) &&
         has_symmetric_nodes_in_the_triangle(basis, exact);
}

TEST(BasisLaws, HoldForInterpolationAtTheCorners) { EXPECT_TRUE(obeys_all({})); }

TEST(BasisLaws, RejectAFunctionThatIsScaled) {
  const Corners basis{Corners::Fault::scaled_function};
  const auto points = points_of_the_plane<Rational>(seed);
  const std::span<const Barycentric<Rational>> span(points);
  EXPECT_FALSE(is_one_at_its_node_and_zero_at_the_others(basis, exact));
  EXPECT_FALSE(is_a_partition_of_unity(basis, span, exact));
  EXPECT_FALSE(reproduces_polynomials(basis, 1, span, exact));
}

TEST(BasisLaws, RejectNodesOutsideOrWithoutSymmetry) {
  EXPECT_FALSE(has_symmetric_nodes_in_the_triangle(Corners{Corners::Fault::node_outside}, exact));
  EXPECT_FALSE(has_symmetric_nodes_in_the_triangle(Corners{Corners::Fault::node_on_a_side}, exact));
  EXPECT_FALSE(is_one_at_its_node_and_zero_at_the_others(Corners{Corners::Fault::node_on_a_side}, exact));
}

TEST(BasisLaws, RejectAnotherNumberOfFunctionsThanNodes) {
  EXPECT_FALSE(is_one_at_its_node_and_zero_at_the_others(Corners{Corners::Fault::function_too_many}, exact));
}

TEST(BasisLaws, SayInOneCallWhichIsBrokenWhereAndByHowMuch) {
  const auto told = [](Corners::Fault fault) {
    return std::string(is_a_lagrange_basis(Corners{fault}, 1, exact).message());
  };
  EXPECT_TRUE(is_a_lagrange_basis(Corners{}, 1, exact));
  EXPECT_EQ(told(Corners::Fault::scaled_function),
            "the law \"one at its node and zero at the others\" is broken: l_1(q_1) = 1000001/1000000 in "
            "place of 1, "
            "q_1 = (0, 1, 0)");
  EXPECT_EQ(told(Corners::Fault::node_outside),
            "the law \"different nodes in the triangle\" is broken: q_2 = (-1/8, 0, 9/8) is outside the "
            "triangle by 1/8");
  EXPECT_EQ(told(Corners::Fault::node_on_a_side),
            "the law \"one at its node and zero at the others\" is broken: l_0(q_2) = 1/8 in place of 0, "
            "q_2 = (1/8, 0, 7/8)");
  EXPECT_NE(told(Corners::Fault::function_too_many).find("3 nodes for 4 functions"), std::string::npos);
  const std::string degree(is_a_lagrange_basis(Corners{}, 2, exact).message());
  EXPECT_NE(degree.find("\"reproduces the polynomials of degree 2\" is broken: t^0 s^2 at"),
            std::string::npos)
      << degree;
}

TEST(BasisLaws, SeeTheDegreeThatABasisDoesNotReproduce) {
  const auto points = points_of_the_plane<Rational>(seed);
  const std::span<const Barycentric<Rational>> span(points);
  for (int degree = 0; degree <= 3; ++degree) {
    const InsetBasis<Rational> basis(degree, Rational(1, 6));
    EXPECT_TRUE(reproduces_polynomials(basis, degree, span, exact)) << degree;
    EXPECT_FALSE(reproduces_polynomials(basis, degree + 1, span, exact)) << degree;
  }
}

}  // namespace
}  // namespace radcert::laws
