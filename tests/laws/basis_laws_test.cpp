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
