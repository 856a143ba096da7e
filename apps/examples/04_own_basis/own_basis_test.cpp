// SPDX-License-Identifier: GPL-3.0-or-later

// A basis as a C++ type: linear functions and the bubble b = 27 x1 x2 x3, at four nodes. One call tries all
// laws; the same type then solves a problem.
#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "radcert/formats/problem/problem_json.h"
#include "radcert/polynomial/exact_basis.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/study/study.h"
#include "tests/laws/basis_laws.h"

namespace {

using namespace radcert;

/// L_i = (x_i - 1/5)/(2/5) is 1 at the node (3/5, 1/5, 1/5) and 1/3 at the centroid; B = (125 b - 81)/44 is 0
/// at the first three nodes and 1 at the centroid: l_i = L_i - B/3, l_4 = B.
template <Field R>
class LinearWithBubble {
public:
  static constexpr int reproduced = 1;  ///< all polynomials of this degree are among the functions

  int degree() const { return 3; }  ///< of the functions
  std::size_t size() const { return 4; }
  std::vector<Barycentric<R>> nodes() const {
    const R far = R(3) / R(5);
    const R near = R(1) / R(5);
    const R third = R(1) / R(3);
    return {{{far, near, near}}, {{near, far, near}}, {{near, near, far}}, {{third, third, third}}};
  }
  void values(const Barycentric<R>& x, std::span<R> out) const {
    const R bubble = R(27) * x.x[0] * x.x[1] * x.x[2];
    const R b = (R(125) * bubble - R(81)) / R(44);
    for (std::size_t i = 0; i < 3; ++i) out[i] = (R(5) * x.x[i] - R(1)) / R(2) - b / R(3);
    out[3] = b;
  }
};

TEST(OwnBasis, ObeysTheLaws) {
  const LinearWithBubble<Rational> basis;
  EXPECT_TRUE(laws::is_a_lagrange_basis(basis, basis.reproduced, Rational(0)));
}

TEST(OwnBasis, ObeysTheLawsInDouble) {
  const LinearWithBubble<double> basis;
  EXPECT_TRUE(laws::is_a_lagrange_basis(basis, basis.reproduced, 1e-13));
}

// problem.json with a basis that is a type: what a file of nodes gives, bit for bit.
TEST(OwnBasis, SolvesAProblemLikeItsFile) {
  const std::string folder = OWN_BASIS_FOLDER;
  const Problem by_file = read_problem(folder + "/problem.json");
  Problem by_type = by_file;
  const LagrangeFunctions functions = lagrange_functions_of(LinearWithBubble<Rational>());
  by_type.method = Collocation{{.degree = functions.degree(),
                                .alpha = std::nullopt,
                                .family = NodeFamily::file,
                                .file = "LinearWithBubble",
                                .functions = std::make_shared<const LagrangeFunctions>(functions)}};
  for (const int level : {0, 1}) {
    const LevelResult one = solve_level(by_type, level, reference::applied_operator).result;
    const LevelResult other = solve_level(by_file, level, reference::applied_operator).result;
    EXPECT_EQ(one.unknowns, 4 * one.elements);
    EXPECT_EQ(one.node_error.value().value, other.node_error.value().value) << "level " << level;
    EXPECT_EQ(one.discretisation_error.value().value, other.discretisation_error.value().value);
  }
}

}  // namespace
