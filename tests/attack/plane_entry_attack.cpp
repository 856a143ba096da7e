// SPDX-License-Identifier: GPL-3.0-or-later
// Certified entries of pairs of triangles with a common edge, and what the solver "verified" makes of them.
// The judges are Lambert's formula and the polar integral, a Vandermonde system of rationals for the
// functions, and Cramer's rule.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "radcert/collocation/certified/certified_entries.h"
#include "radcert/core/errors.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/study/collocation/verified_level.h"
#include "radcert/surface/mesh_surface.h"
#include "tests/attack/attack.h"
#include "tests/attack/nasty_geometry.h"
#include "tests/study/problems.h"

namespace radcert::attack {
namespace {

struct Pair {
  /// Counterclockwise as seen from the side of their normals, which they see of each other
  std::array<Corners, 2> triangles;
  int degree = 0;
  long inset = 6;  ///< its reciprocal
  std::array<double, 2> reflectivity{0.5, 0.5};
  std::array<double, 2> emission{1, 1};
};

std::string text_of(const Pair& pair) {
  return text(pair.triangles[0]) + "\n" + text(pair.triangles[1]) + "\ndegree " +
         std::to_string(pair.degree) + ", inset 1/" + std::to_string(pair.inset) + ", rho " +
         shortest(pair.reflectivity[0]) + " " + shortest(pair.reflectivity[1]) + ", E " +
         shortest(pair.emission[0]) + " " + shortest(pair.emission[1]);
}

judge::Triple normal_of(const Corners& c) {
  return judge::cross(judge::minus(triple(c[1]), triple(c[0])), judge::minus(triple(c[2]), triple(c[0])));
}

Pair drawn(Draw& draw, int highest) {
  NastyGeometry nasty(draw);
  Pair pair;
  constexpr std::array bits{3, 8, 12, 20, 27};
  const auto [first, second] = nasty.nearly_coplanar_pair(bits[draw.below(bits.size())]);
  pair.triangles = {first, second};
  if (draw.below(8) == 0) {
    for (Corners& c : pair.triangles)
      for (Point& a : c) a = {a.x + 0x1p40, a.y, a.z};
  }
  // The corner that each has for itself: the first of the first triangle, the last of the second.
  if (judge::dot(normal_of(pair.triangles[0]),
                 judge::minus(triple(pair.triangles[1][2]), triple(pair.triangles[0][0])))
          .sign() < 0)
    std::swap(pair.triangles[0][1], pair.triangles[0][2]);
  if (judge::dot(normal_of(pair.triangles[1]),
                 judge::minus(triple(pair.triangles[0][0]), triple(pair.triangles[1][2])))
          .sign() < 0)
    std::swap(pair.triangles[1][0], pair.triangles[1][1]);
  pair.degree = static_cast<int>(draw.below(static_cast<std::size_t>(highest + 1)));
  pair.inset = 4 + static_cast<long>(draw.below(8));
  for (double& rho : pair.reflectivity) rho = std::array{0.5, 0.9, 0.25, 1e-3, 0.99}[draw.below(5)];
  for (double& e : pair.emission) e = std::array{1.0, 0.0, 1e40, 3.5, 1e-30}[draw.below(5)];
  return pair;
}

std::vector<Pair> simpler_pairs(const Pair& pair) {
  std::vector<Pair> all;
  if (pair.degree > 0) {
    all.push_back(pair);
    --all.back().degree;
  }
  for (const Point& origin : {pair.triangles[0][0], pair.triangles[0][1]}) {
    if (origin == Point{0, 0, 0}) continue;
    all.push_back(pair);
    for (Corners& c : all.back().triangles)
      for (Point& a : c) a = a - origin;
  }
  return all;
}

using Functions = std::vector<std::vector<Rational>>;

/// The coefficients of s^i t^j, by total degree and then by j, of the functions that are 1 at one node and 0
/// at the others.
Functions interpolating(const std::vector<judge::Pair>& nodes, int degree) {
  const std::size_t n = nodes.size();
  Functions rows(n, std::vector<Rational>(2 * n));
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t place = 0;
    for (int m = 0; m <= degree; ++m)
      for (int j = 0; j <= m; ++j) rows[k][place++] = power(nodes[k][0], m - j) * power(nodes[k][1], j);
    rows[k][n + k] = 1;
  }
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    while (rows[pivot][c].sign() == 0) ++pivot;
    std::swap(rows[c], rows[pivot]);
    const Rational factor = Rational(1) / rows[c][c];
    for (Rational& x : rows[c]) x = x * factor;
    for (std::size_t i = 0; i < n; ++i) {
      if (i == c) continue;
      const Rational times = rows[i][c];
      for (std::size_t j = 0; j < 2 * n; ++j) rows[i][j] -= times * rows[c][j];
    }
  }
  Functions result(n, std::vector<Rational>(n));
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t m = 0; m < n; ++m) result[j][m] = rows[m][n + j];
  return result;
}

judge::Triple at(const Corners& c, const judge::Pair& q) { return judged(c).point(q); }

Judgement judge_entries(const Pair& pair) {
  const LagrangeFunctions functions =
      lagrange_functions(inset_nodes(pair.degree, Rational(1, pair.inset))).value();
  std::vector<ExactTriangle> triangles;
  std::vector<double> rho;
  for (std::size_t k = 0; k < 2; ++k) {
    const Corners& c = pair.triangles[k];
    triangles.push_back({exactly(c[0]), exactly(c[1]), exactly(c[2])});
    rho.insert(rho.end(), functions.size(), pair.reflectivity[k]);
  }
  const Outcome<CertifiedEntries> found = certified_entries(triangles, functions, rho);
  if (!found) return Judgement::refused();
  const std::size_t p = functions.size();
  std::vector<judge::Pair> places;
  for (const Barycentric<Rational>& q : functions.nodes()) places.push_back({q.x[1], q.x[2]});
  const Functions exact = interpolating(places, pair.degree);
  for (std::size_t i = 0; i < 2 * p; ++i) {
    const std::size_t own = i / p;
    const judge::Triple node = at(pair.triangles[own], places[i % p]);
    const judge::Triple normal = normal_of(pair.triangles[own]);
    const judge::Polygon other = judged(pair.triangles[1 - own]);
    for (const long bits : {128L, 256L, 1024L}) {
      const BallPrecision precision(bits);
      std::vector<Ball> moments;
      if (pair.degree == 0) {
        moments.push_back(judge::lambert_integral(other, node, normal));
      } else {
        const judge::PolarIntegral integral(other, node, normal, pair.degree,
                                            bits == 128   ? 44
                                            : bits == 256 ? 96
                                                          : 192);
        for (int m = 0; m <= pair.degree; ++m)
          for (int j = 0; j <= m; ++j) moments.push_back(integral.moment(m - j, j));
      }
      bool narrow = true;
      for (std::size_t j = 0; j < p; ++j) {
        Ball truth;
        for (std::size_t m = 0; m < p; ++m) truth += Ball(exact[j][m]) * moments[m];
        truth = truth * Ball(pair.reflectivity[own]) / Ball::pi();
        const std::size_t column = (1 - own) * p + j;
        const Ball entry = widened(Ball(found->entries(i, column)), Ball(found->radius(i, column)));
        narrow = narrow && truth.radius() <= 0.1 * found->radius(i, column);
        if (overlaps(entry, truth)) continue;
        return Judgement::violated("entry " + std::to_string(i) + " " + std::to_string(column) + ": " +
                                   shortest(found->entries(i, column)) + " +- " +
                                   shortest(found->radius(i, column)) + ", the judge has " +
                                   truth.to_text(25));
      }
      if (narrow) break;
    }
  }
  return Judgement::held();
}

TEST(PlaneEntryAttack, ConstantsOnPairs) {
  hold(Attack<Pair>{.name = "certified plane entries, degree 0",
                    .usual_instances = 300,
                    .make = [](Draw& draw) { return drawn(draw, 0); },
                    .judge = judge_entries,
                    .text = text_of,
                    .smaller = simpler_pairs});
}

TEST(PlaneEntryAttack, PolynomialsOnPairs) {
  hold(Attack<Pair>{.name = "certified plane entries, degrees 0 to 3",
                    .usual_instances = 3,
                    .make = [](Draw& draw) { return drawn(draw, 3); },
                    .judge = judge_entries,
                    .text = text_of,
                    .smaller = simpler_pairs});
}

Problem problem_of(const Pair& pair) {
  TriangleMesh mesh;
  for (const Corners& c : pair.triangles) {
    const std::size_t place = mesh.vertices.size();
    for (const Point& a : c) mesh.vertices.push_back(a);
    mesh.triangles.push_back({place, place + 1, place + 2});
  }
  mesh.group = {0, 0};
  mesh.group_names = {""};
  mesh.face = {0, 1};
  const std::array<std::size_t, 2> pieces{0, 1};
  const std::vector<std::string> names{"a", "b"};
  const auto expressions = [](const std::array<double, 2>& values) {
    return testing::by_piece({{"a", shortest(values[0])}, {"b", shortest(values[1])}});
  };
  Problem problem = testing::with_basis(testing::sample_problem("pair"), 0, Rational(0));
  problem.surface = {.name = "pair", .parameters = {}, .mesh = MeshChoice{}};
  problem.surface.mesh->surface = std::make_shared<const Surface>(mesh_surface(
      "pair", mesh, pieces, names,
      {.orientation = Orientation::along_the_cross_product, .closed = false, .unoccluded = true}));
  problem.reflectivity = expressions(pair.reflectivity);
  problem.solution = std::nullopt;
  problem.emission = expressions(pair.emission);
  problem.solver.name = "verified";
  return problem;
}

Judgement judge_solution(const Pair& pair) {
  std::vector<NodeValue> nodes;
  try {
    nodes = verified_level(problem_of(pair), 0, reference::applied_operator).nodes;
  } catch (const AccuracyNotReached&) {
    return Judgement::refused();
  }
  const BallPrecision precision(512);
  const judge::Pair centroid{Rational(1, 3), Rational(1, 3)};
  std::array<Ball, 2> k;
  for (std::size_t i = 0; i < 2; ++i)
    k[i] = Ball(Rational::parse(shortest(pair.reflectivity[i])).value()) / Ball::pi() *
           judge::lambert_integral(judged(pair.triangles[1 - i]), at(pair.triangles[i], centroid),
                                   normal_of(pair.triangles[i]));
  for (std::size_t i = 0; i < 2; ++i) {
    const auto e = [&](std::size_t j) { return Ball(Rational::parse(shortest(pair.emission[j])).value()); };
    const Ball truth = (e(i) + k[i] * e(1 - i)) / (1 - k[0] * k[1]);
    const Ball value = widened(Ball(nodes[i].u_n.value), Ball(nodes[i].u_n.radius));
    if (overlaps(value, truth)) continue;
    return Judgement::violated("node " + std::to_string(i) + ": " + shortest(nodes[i].u_n.value) + " +- " +
                               shortest(nodes[i].u_n.radius) + ", the judge has " + truth.to_text(25));
  }
  return Judgement::held();
}

TEST(PlaneEntryAttack, VerifiedPairs) {
  hold(Attack<Pair>{.name = "verified pairs of triangles",
                    .usual_instances = 200,
                    .make = [](Draw& draw) { return drawn(draw, 0); },
                    .judge = judge_solution,
                    .text = text_of,
                    .smaller = simpler_pairs});
}

}  // namespace
}  // namespace radcert::attack
