// SPDX-License-Identifier: GPL-3.0-or-later
// The pipeline in fifty digits: the reference for the pipeline in double.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "radcert/collocation/assembly.h"
#include "radcert/collocation/nodes.h"
#include "radcert/solve/direct.h"
#include "radcert/solve/elimination.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/two_piece.h"

namespace radcert {
namespace {

using FiftyDigits = Mpfr<50>;

/// A collocation system with E = x^2 + y^2 + z^2, and its solution.
template <class R>
struct System {
  std::vector<CollocationPoint<R>> nodes;
  CollocationMatrix<R> matrix;
  std::vector<R> emission;

  System(const Surface& surface, int level, const Rational& rho, double tolerance) {
    const Triangulation triangulation = triangulate(surface, level);
    const InsetBasis<R> basis(1, from_rational<R>(Rational(1, 6)));
    nodes = collocation_nodes(surface, triangulation, basis);
    const std::vector<R> reflectivity(nodes.size(), from_rational<R>(rho));
    matrix = assemble<R>(surface, triangulation, basis, nodes, reflectivity, Tolerance(tolerance));
    for (const CollocationPoint<R>& node : nodes) emission.push_back(dot(node.point, node.point));
  }
};

/// Every row and the solution in double lie within their radii of those in fifty digits; rows of a closed
/// surface sum to rho.
void expect_double_within_its_radii(const Surface& surface, int level, const Rational& rho,
                                    double tolerance) {
  const System<double> in_double(surface, level, rho, Tolerance::finest);
  const System<FiftyDigits> exact(surface, level, rho, tolerance);
  const std::size_t n = exact.nodes.size();
  double largest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    double row = 0;
    for (std::size_t j = 0; j < n; ++j) {
      const FiftyDigits difference = FiftyDigits(in_double.matrix.entries(i, j)) - exact.matrix.entries(i, j);
      row += std::abs(difference.to_double());
    }
    EXPECT_LE(row, in_double.matrix.row_radius[i] + exact.matrix.row_radius[i].to_double()) << i;
    EXPECT_LE(row, 1e-13 * in_double.matrix.kernel_integral[i]) << i;
    EXPECT_LE(exact.matrix.row_radius[i].to_double(), 10 * tolerance) << i;
    largest = std::max(largest, row);
    if (!surface.closed) continue;
    // Int_S G = pi, and the basis sums to one: [ac98, (7)].
    FiftyDigits sum = 0;
    for (std::size_t j = 0; j < n; ++j) sum += exact.matrix.entries(i, j);
    EXPECT_LE(std::abs((sum - from_rational<FiftyDigits>(rho)).to_double()), tolerance) << i;
  }
  const std::vector<double> u = DirectSolver(in_double.matrix.entries).solve(in_double.emission);
  const std::vector<FiftyDigits> v = solve_by_elimination(exact.matrix.entries, exact.emission);
  double error = 0;
  for (std::size_t i = 0; i < n; ++i)
    error = std::max(error, std::abs((FiftyDigits(u[i]) - v[i]).to_double()));
  EXPECT_LE(error, 1e-13);
  std::cout << surface.name << ", " << n << " unknowns: rows in double differ by at most " << largest
            << ", the solution by " << error << '\n';
}

TEST(FiftyDigits, HoldTheDoublePipelineOnTheTwoPieceSurface) {
  expect_double_within_its_radii(two_piece(2), 0, 1, 1e-44);
}

TEST(FiftyDigits, HoldTheDoublePipelineOnTheCube) {
  expect_double_within_its_radii(cube(), 0, Rational(1, 2), 1e-20);
}

}  // namespace
}  // namespace radcert
