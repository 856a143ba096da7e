// SPDX-License-Identifier: GPL-3.0-or-later
// The assembly against a plain program, entry by entry.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "apps/bench/plain.h"
#include "radcert/collocation/assembly.h"
#include "radcert/collocation/nodes.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"

namespace radcert {
namespace {

void expect_agreement(const Surface& surface, int level, int degree, double inset) {
  const Triangulation triangulation = triangulate(surface, level);
  const InsetBasis<double> basis(degree, inset);
  const std::vector<CollocationPoint<double>> nodes = collocation_nodes(surface, triangulation, basis);
  const std::vector<double> reflectivity(nodes.size(), 1.0);
  const CollocationMatrix<double> fast = assemble<double>(surface, triangulation, basis, nodes, reflectivity);
  const Matrix<double> plain = bench::plain_collocation_matrix(surface, triangulation, basis);
  double largest = 0;
  for (std::size_t j = 0; j < nodes.size(); ++j)
    for (std::size_t i = 0; i < nodes.size(); ++i)
      largest = std::max(largest, std::abs(fast.entries(i, j) - plain(i, j)));
  EXPECT_LT(largest, 5e-11) << surface.name;
  std::cout << surface.name << ", degree " << degree << ": entries differ by at most " << largest << '\n';
}

TEST(PlainAssembly, AgreesOnPlanePieces) {
  expect_agreement(cube(), 1, 1, 1.0 / 6);
  expect_agreement(cube(), 1, 3, 0.1);
}

TEST(PlainAssembly, AgreesOnCurvedPieces) {
  expect_agreement(two_piece(2), 2, 1, 1.0 / 6);
  expect_agreement(two_piece(3), 1, 2, 0.1);
  expect_agreement(sphere(), 1, 1, 1.0 / 6);
}

}  // namespace
}  // namespace radcert
