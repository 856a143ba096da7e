// SPDX-License-Identifier: GPL-3.0-or-later

// A surface as a C++ type: a floor below a barrel vault. One call tries all laws; then the collocation
// equations are set up on it and solved, step by step.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "radcert/collocation/assembly.h"
#include "radcert/collocation/nodes.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/solve/direct.h"
#include "radcert/study/problem.h"
#include "radcert/surface/catalogue/rectangle.h"
#include "radcert/triangulation/triangulation.h"
#include "tests/laws/surface_laws.h"

namespace {

using namespace radcert;

/// F(s, t) = (s, t, 4 h s (1 - s)). Written once, for every arithmetic: T differentiates, R holds the
/// constants.
template <Field R>
class Vault {
public:
  explicit Vault(const Rational& height) : four_h_(from_rational<R>(Rational(4) * height)) {}

  template <Field T>
  Vector<T> operator()(const T& s, const T& t) const {
    return {s, t, four_h_ * (s * (R(1) - s))};
  }

private:
  R four_h_;
};

/// The unit square and the vault on it, open at both ends. It lies in the boundary of a convex body, so that
/// nothing hides anything.
Surface vaulted_hall(const Rational& height) {
  Surface surface;
  surface.name = "vaulted_hall";
  surface.parameters = {{"height", height}};
  surface.charts.push_back(
      make_rectangle({.name = "floor", .piece = "floor", .orientation = Orientation::along_the_cross_product},
                     {0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
  // D_s F x D_t F points upwards, and the inner normal of a roof points down.
  surface.charts.push_back(make_chart<Vault>(
      {.name = "vault", .piece = "vault", .orientation = Orientation::against_the_cross_product}, height));
  surface.diagonals.assign(2, Diagonal::main);
  surface.closed = false;
  surface.unoccluded = true;
  surface.pieces_meet_at_angle = true;  // the nodes keep off the springing line
  return surface;
}

TEST(OwnSurface, ObeysTheLaws) { EXPECT_TRUE(laws::obeys_the_surface_laws(vaulted_hall(Rational(1, 2)))); }

/// u is given, E = u - Ku by the second route, and the result is max |u - u_n| over the nodes.
double node_error(const Surface& surface, int level) {
  constexpr double rho = 0.5;
  const auto u = [](const Vector<double>& p) { return 1 + p.x * p.y; };
  const TriangleBasis<double> basis = triangle_basis({.degree = 1, .alpha = Rational(1, 6)});
  const Triangulation triangulation = triangulate(surface, level);
  const std::vector<CollocationPoint<double>> nodes =
      collocation_nodes<double>(surface, triangulation, basis);
  const std::vector<double> reflectivity(nodes.size(), rho);
  const CollocationMatrix<double> matrix =
      assemble<double>(surface, triangulation, basis, nodes, reflectivity);

  const reference::AppliedOperator integral(
      surface, [&u](const SurfacePoint<double>&, const Vector<double>& q) { return u(q); });
  std::vector<double> emission;
  for (const CollocationPoint<double>& node : nodes)
    emission.push_back(u(node.point) - rho / std::numbers::pi * integral(node.at).value);

  const std::vector<double> u_n = DirectSolver(matrix.entries).solve(emission);
  double error = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    error = std::max(error, std::abs(u(nodes[i].point) - u_n[i]));
  return error;
}

TEST(OwnSurface, IsSolvedOn) {
  const Surface surface = vaulted_hall(Rational(1, 2));
  double before = node_error(surface, 0);
  for (const int level : {1, 2}) {
    const double error = node_error(surface, level);
    EXPECT_LT(error, before / 2) << "level " << level;
    before = error;
  }
}

}  // namespace
