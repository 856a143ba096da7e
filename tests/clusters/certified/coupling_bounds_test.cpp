// SPDX-License-Identifier: GPL-3.0-or-later
// Each ingredient of the bound of a coupling by itself, against something that it must not be below.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <vector>

#include "radcert/clusters/certified/approximation_bound.h"
#include "radcert/clusters/certified/certified_coupling.h"
#include "radcert/clusters/certified/cluster_region.h"
#include "radcert/clusters/certified/enclosed_tables.h"
#include "radcert/clusters/certified/interpolation_bounds.h"
#include "radcert/clusters/mode_tables.h"
#include "radcert/core/contract.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/polynomial/triangle_modes.h"
#include "radcert/scalar/complex_ball.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/cone.h"
#include "radcert/surface/catalogue/cylinder.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/paraboloid_cap.h"
#include "radcert/surface/catalogue/spherical_cap.h"
#include "radcert/surface/catalogue/torus.h"
#include "radcert/surface/catalogue/two_piece.h"

namespace radcert {
namespace {

Barycentric<double> random_point(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  double s = uniform(random);
  double t = uniform(random);
  if (s + t > 1) {
    s = 1 - s;
    t = 1 - t;
  }
  return {{1 - s - t, s, t}};
}

TEST(ApproximationBound, IsAboveTheDistanceOfAPoleFromPolynomials) {
  // f = 2/(A - x), x = 2 lambda_1 - 1, has on a side of the triangle the distance 2 (A - root)^p / (A^2 - 1)
  // from polynomials of degree p (Chebyshev), root = sqrt(A^2 - 1), and where sum |lambda_i| <= g the bound
  // 2/(A - g).
  for (const double a : {1.2, 1.7, 3.0, 10.0})
    for (int degree = 0; degree <= 22; ++degree) {
      const double distance = 2 * std::pow(a - std::sqrt(a * a - 1), degree) / (a * a - 1);
      double least = std::numeric_limits<double>::infinity();
      for (double part = 0.05; part < 1; part += 0.05) {
        const double g = 1 + part * (a - 1);
        const double bound = approximation_bound(2 / (a - g), g, degree);
        EXPECT_GE(bound, distance) << a << " " << degree << " " << g;
        least = std::min(least, bound / distance);
      }
      EXPECT_LE(least, 80 * (degree + 2)) << a << " " << degree;
    }
  EXPECT_EQ(approximation_bound(1, 1, 3), std::numeric_limits<double>::infinity());
  EXPECT_EQ(approximation_bound(0, 2, 3), 0);
}

TEST(ApproximationBound, IsTheSumOfItsSeries) {
  for (const double g : {1.1, 1.5, 3.0})
    for (const int degree : {0, 1, 5, 20}) {
      const double rho = g + std::sqrt(g * g - 1);
      double sum = 0;
      for (int m = degree + 1; m < degree + 400; ++m) sum += std::sqrt(2.0 * (4 * m + 1)) * std::pow(rho, -m);
      const double series = 3 * sum / (1 - 1 / rho);
      EXPECT_GE(approximation_bound(3, g, degree), series * (1 - 1e-9));
      EXPECT_LE(approximation_bound(3, g, degree), series * 1.7) << g << " " << degree;
    }
}

TEST(InterpolationBounds, AreAboveTheLebesgueFunctionAndNearIt) {
  std::mt19937 random(7);
  for (const int degree : {0, 1, 2, 3, 5, 8, 12}) {
    const InterpolationBounds& bounds = interpolation_bounds(degree);
    const Matrix<double>& w = ModeTables::instance().interpolation(degree).modes_of_values;
    const std::size_t k = mode_count(degree);
    std::vector<double> modes(k);
    double largest = 0;
    std::vector<Barycentric<double>> points;
    for (int i = 0; i < 3000; ++i) points.push_back(random_point(random));
    for (int i = 0; i <= 200; ++i) points.push_back({{0, i / 200.0, 1 - i / 200.0}});
    for (const Barycentric<double>& x : points) {
      triangle_modes<double>(degree, x, modes);
      double sum = 0;
      for (std::size_t a = 0; a < k; ++a) {
        double value = 0;
        for (std::size_t n = 0; n < k; ++n) value += w(n, a) * modes[n];
        sum += std::abs(value);
      }
      largest = std::max(largest, sum);
    }
    EXPECT_GE(bounds.stored, largest * (1 - 1e-12)) << degree;
    EXPECT_LE(bounds.stored, largest * 1.3) << degree;
    EXPECT_GE(bounds.exact, bounds.stored) << degree;
    EXPECT_LE(bounds.exact, bounds.stored * (1 + 1e-6)) << degree;
    // The mean of l_a^2 by a rule that is exact for it.
    TriangleRule<double> rule = conical_rule<double>(degree + 1, Grading::none);
    std::vector<double> squares(k);
    for (std::size_t q = 0; q < rule.points.size(); ++q) {
      triangle_modes<double>(degree, rule.points[q], modes);
      for (std::size_t a = 0; a < k; ++a) {
        double value = 0;
        for (std::size_t n = 0; n < k; ++n) value += w(n, a) * modes[n];
        squares[a] += 2 * rule.weights[q] * value * value;
      }
    }
    for (std::size_t a = 0; a < k; ++a) {
      EXPECT_GE(bounds.mean_size[a], std::sqrt(squares[a]) * (1 - 1e-12));
      EXPECT_LE(bounds.mean_size[a], std::sqrt(squares[a]) * (1 + 1e-6));
    }
  }
}

TEST(InterpolationBounds, HaveNodesInTheTriangle) {
  for (int degree = 0; degree <= largest_mode_degree; ++degree) {
    const auto& nodes = exact_interpolation_nodes(degree);
    EXPECT_EQ(nodes.size(), mode_count(degree));
    for (const ParameterPoint<double>& x : nodes) {
      EXPECT_GE(x.s, 0);
      EXPECT_GE(x.t, 0);
      EXPECT_LE(Rational::exactly(x.s) + Rational::exactly(x.t), Rational(1));
    }
  }
}

using Complex = std::complex<double>;

/// Random lambda with the sum 1 and sum |lambda_i| = g: (X_i + i Y_i)^2 of a circle on the sphere.
std::array<Complex, 3> random_lambda(std::mt19937& random, double g) {
  std::normal_distribution<double> normal;
  Vector<double> a{normal(random), normal(random), normal(random)};
  a = (1 / norm(a)) * a;
  Vector<double> b{normal(random), normal(random), normal(random)};
  b = b - dot(a, b) * a;
  b = (1 / norm(b)) * b;
  const double angle = std::uniform_real_distribution<double>(0, 2 * std::numbers::pi)(random);
  const Complex z(angle, std::acosh(g) / 2);
  const Complex c = std::cos(z);
  const Complex s = std::sin(z);
  const std::array<Complex, 3> x{c * a.x + s * b.x, c * a.y + s * b.y, c * a.z + s * b.z};
  return {x[0] * x[0], x[1] * x[1], x[2] * x[2]};
}

/// Any point of E_g, on its border more often than not.
std::array<Complex, 3> any_lambda(std::mt19937& random, double g) {
  const double part = std::uniform_real_distribution<double>(-1, 1)(random);
  return random_lambda(random, part < 0 ? g : 1 + (g - 1) * part);
}

using ComplexVector = Vector<Complex>;

Complex middle_of(const ComplexBall& x) { return {x.real().to_double(), x.imag().to_double()}; }
ComplexVector middle_of(const Vector<ComplexBall>& v) {
  return {middle_of(v.x), middle_of(v.y), middle_of(v.z)};
}

/// A chart at complex barycentric coordinates of a cluster, by its formula in complex balls.
struct ComplexFrame {
  ComplexVector point;
  ComplexVector normal;  ///< of unit length in the sense of the product without conjugation
  Complex area;
};
ComplexFrame complex_frame(const Chart& chart, const ParameterTriangle& triangle,
                           const std::array<Complex, 3>& lambda) {
  ParameterPoint<Complex> at;
  for (std::size_t i = 0; i < 3; ++i) {
    at.s += lambda[i] * triangle.vertices[i].s;
    at.t += lambda[i] * triangle.vertices[i].t;
  }
  const auto ball = [](const Complex& x) { return ComplexBall(Ball(x.real()), Ball(x.imag())); };
  const Frame<ComplexBall> frame = chart.in<ComplexBall>().frame({ball(at.s), ball(at.t)});
  const ComplexBall area = sqrt(dot(frame.area_normal, frame.area_normal));
  return {middle_of(frame.point), middle_of(reciprocal(area) * frame.area_normal), middle_of(area)};
}

Complex product(const ComplexVector& a, const ComplexVector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
ComplexVector complex_of(const Vector<double>& v) { return {v.x, v.y, v.z}; }

double lie_norm(const ComplexVector& w) {
  const Vector<double> u{w.x.real(), w.y.real(), w.z.real()};
  const Vector<double> v{w.x.imag(), w.y.imag(), w.z.imag()};
  return std::sqrt(dot(u, u) + dot(v, v) + 2 * norm(cross(u, v)));
}

std::vector<Surface> ellipsoids() { return {sphere(), ellipsoid(1, Rational(3, 2), 2), ellipsoid(1, 2, 5)}; }

/// Those with charts that are neither plane nor octants.
std::vector<Surface> other_curved_surfaces() {
  return {cylinder(1, 2),   cone(1, Rational(1, 2), 1),    two_piece(2),
          paraboloid_cap(), spherical_cap(Rational(1, 4)), torus(1, Rational(1, 2))};
}

/// How near the quantities of a region come to their bounds.
struct NearestToRegion {
  double bend = 0;
  double turn = 0;
  double weight = 0;
};
NearestToRegion nearest_to_region(const std::vector<Surface>& surfaces, int trials) {
  std::mt19937 random(17);
  NearestToRegion nearest;
  for (const Surface& surface : surfaces)
    for (const int level : {1, 2, 4}) {
      const Triangulation triangulation = triangulate(surface, level);
      for (int trial = 0; trial < trials; ++trial) {
        const ParameterTriangle& triangle =
            triangulation.triangles[random() % triangulation.triangles.size()];
        const Chart& chart = surface.charts[triangle.chart];
        if (chart.facts().plane) continue;
        const ClusterRegion region(chart, triangle);
        for (const double part : {0.0, 0.02, 0.1, 0.3, 0.6, 0.9}) {
          const double g = 1 + (region.limit() - 1) * part;
          if (!(g >= 1)) break;
          const ClusterRegion::Neighbourhood bounds = region.at(g);
          for (int point = 0; point < 20; ++point) {
            const std::array<Complex, 3> lambda = any_lambda(random, g);
            const ComplexFrame frame = complex_frame(chart, triangle, lambda);
            ComplexVector bend = frame.point;
            ComplexVector moved = -complex_of(region.centre());
            for (std::size_t i = 0; i < 3; ++i) {
              bend = bend - lambda[i] * complex_of(region.corners()[i]);
              moved = moved + lambda[i] * complex_of(region.corners()[i]);
            }
            const double turn = lie_norm(frame.normal - complex_of(region.normal()));
            const double weight = std::abs(frame.area) * parameter_area(triangle);
            const std::string where =
                surface.name + ", level " + std::to_string(level) + ", g = " + std::to_string(g);
            EXPECT_LE(lie_norm(moved), g * region.radius() * (1 + 1e-12)) << where;
            EXPECT_LE(lie_norm(bend), bounds.bend * (1 + 1e-9)) << where;
            EXPECT_LE(turn, bounds.turn * (1 + 1e-9) + 1e-14) << where;
            EXPECT_LE(weight, bounds.weight * (1 + 1e-9)) << where;
            nearest.bend = std::max(nearest.bend, lie_norm(bend) / bounds.bend);
            nearest.turn = std::max(nearest.turn, turn / bounds.turn);
            nearest.weight = std::max(nearest.weight, weight / bounds.weight);
          }
        }
        EXPECT_EQ(region.at(region.limit() * 1.001).bend, std::numeric_limits<double>::infinity());
      }
    }
  return nearest;
}

TEST(ClusterRegion, HoldsTheComplexNeighbourhoodsOfEllipsoids) {
  const NearestToRegion nearest = nearest_to_region(ellipsoids(), 30);
  EXPECT_GT(nearest.bend, 0.4);
  EXPECT_GT(nearest.turn, 0.8);
  EXPECT_GT(nearest.weight, 0.8);
}

TEST(ClusterRegion, HoldsTheComplexNeighbourhoodsOfOtherCurvedCharts) {
  for (const Surface& surface : other_curved_surfaces()) {
    const NearestToRegion nearest = nearest_to_region({surface}, 60);
    EXPECT_GT(nearest.bend, 0.8) << surface.name;
    EXPECT_GT(nearest.turn, 0.6) << surface.name;
    EXPECT_GT(nearest.weight, 0.9) << surface.name;
  }
}

/// How near the factors of G come to their bounds, P in one cluster and complex Q of another.
KernelFactors nearest_to_bounds(const Surface& surface, int level, int trials, std::mt19937& random) {
  KernelFactors reached;
  const Triangulation triangulation = triangulate(surface, level);
  const auto& triangles = triangulation.triangles;
  for (int trial = 0; trial < trials; ++trial) {
    const ParameterTriangle& seen = triangles[random() % triangles.size()];
    // A neighbour, or the same, as often as any.
    const ParameterTriangle& from = trial % 2 == 0 ? triangles[random() % triangles.size()]
                                                   : triangles[(&seen - triangles.data()) ^ (trial % 4)];
    if (in_one_plane(surface.charts[seen.chart], surface.charts[from.chart])) continue;
    const ClusterRegion in(surface.charts[seen.chart], seen);
    const ClusterRegion of(surface.charts[from.chart], from);
    const double farthest = std::min(std::max(of.least_distance(in.centre()) / in.radius(), 1.2), in.limit());
    for (const double part : {0.0, 0.3, 0.6, 0.85}) {
      const double g = 1 + (farthest - 1) * part;
      if (!(g >= 1)) break;
      const KernelFactors bounds = kernel_factors(in, of, g);
      const double of_kernel = kernel_bound(in, of, g);
      for (int point = 0; point < 60; ++point) {
        Barycentric<double> at = random_point(random);
        // The corners too, where the distance is least.
        if (point % 3 == 0)
          at = {{point % 9 == 0 ? 1.0 : 0.0, point % 9 == 3 ? 1.0 : 0.0, point % 9 == 6 ? 1.0 : 0.0}};
        const Frame<double> p = surface.charts[from.chart].in<double>().frame(from.at(at.x));
        const ComplexFrame q = complex_frame(surface.charts[seen.chart], seen, random_lambda(random, g));
        const ComplexVector d = q.point - complex_of(p.point);
        const Complex squared = product(d, d);
        const double over_p = std::abs(product(d, complex_of(unit_normal(p))));
        const double over_q = std::abs(product(d, q.normal));
        const std::string where = surface.name + ", g = " + std::to_string(g);
        EXPECT_LE(over_p, bounds.over_p * (1 + 1e-9)) << where;
        EXPECT_LE(over_q, bounds.over_q * (1 + 1e-9)) << where;
        reached.over_p = std::max(reached.over_p, over_p / bounds.over_p);
        reached.over_q = std::max(reached.over_q, over_q / bounds.over_q);
        if (!(bounds.nearest > 0)) continue;
        EXPECT_GE(std::sqrt(std::abs(squared)), bounds.nearest * (1 - 1e-9)) << where;
        EXPECT_LE(over_p * over_q, of_kernel * std::norm(squared) * (1 + 1e-9)) << where;
        reached.nearest = std::max(reached.nearest, bounds.nearest / std::sqrt(std::abs(squared)));
      }
    }
  }
  return reached;
}

TEST(KernelBound, HoldsOnComplexNeighbourhoodsAndIsNearlyReached) {
  std::mt19937 random(11);
  for (const Surface& surface : {cube(), box(1, 1, 3)}) {
    const KernelFactors reached = nearest_to_bounds(surface, 1, 300, random);
    EXPECT_GT(reached.nearest, 0.8) << surface.name;
    EXPECT_GT(reached.over_p, 0.8) << surface.name;
    EXPECT_GT(reached.over_q, 0.99) << surface.name;
  }
}

TEST(KernelBound, HoldsOnComplexNeighbourhoodsOfCurvedCharts) {
  std::mt19937 random(13);
  for (const Surface& surface : ellipsoids()) {
    const KernelFactors reached = nearest_to_bounds(surface, 3, 300, random);
    EXPECT_GT(reached.nearest, 0.8) << surface.name;
    EXPECT_GT(reached.over_p, 0.4) << surface.name;
    EXPECT_GT(reached.over_q, 0.4) << surface.name;
  }
  for (const Surface& surface : other_curved_surfaces()) {
    const KernelFactors reached = nearest_to_bounds(surface, 3, 60, random);
    EXPECT_GT(reached.nearest, 0.8) << surface.name;
    EXPECT_GT(reached.over_p, 0.5) << surface.name;
    EXPECT_GT(reached.over_q, 0.5) << surface.name;
  }
}

TEST(KernelBound, FallsWithTheSquareOfLengthsOrIsUnknown) {
  const auto bounds_at = [](int exponent) {
    Rational edge = 1;
    for (int k = 0; k < std::abs(exponent); ++k) edge = exponent > 0 ? edge * 2 : edge / 2;
    const Surface surface = box(edge, edge, edge);
    const Triangulation triangulation = triangulate(surface, 1);
    const auto& triangles = triangulation.triangles;
    const ClusterRegion from(surface.charts[triangles[0].chart], triangles[0]);
    std::vector<double> bounds;
    for (const ParameterTriangle& triangle : triangles)
      if (triangle.chart != triangles[0].chart)
        bounds.push_back(kernel_bound(ClusterRegion(surface.charts[triangle.chart], triangle), from, 1));
    return bounds;
  };
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<double> at_one = bounds_at(0);
  for (const int exponent : {-300, -258, -257, -256, -255, -254, -100, 100, 254, 255, 256, 257, 258, 300}) {
    const std::vector<double> bounds = bounds_at(exponent);
    std::size_t known = 0;
    for (std::size_t k = 0; k < bounds.size(); ++k) {
      if (bounds[k] == infinity) continue;
      ++known;
      EXPECT_EQ(std::ldexp(bounds[k], 2 * exponent), at_one[k]) << exponent << " " << k;
    }
    if (std::abs(exponent) <= 100) {
      EXPECT_GT(known, bounds.size() / 2) << exponent;
    }
  }
}

/// Holds couplings of the clusters of a level against integrals of |h - c|^2.
void expect_above_what_is_left_out(const Surface& surface, int level) {
  const Triangulation triangulation = triangulate(surface, level);
  const auto& triangles = triangulation.triangles;
  const CouplingDemand demand{.share = 1e-4, .functions_size = 1.5, .largest_degree = 15};
  const CertifiedOutlines certified(surface.charts, triangles);
  const ClusterOutlines estimated(surface.charts, triangles);
  const ModeSizes sizes;
  CertifiedLook look(certified, estimated, demand, sizes);
  TriangleRule<double> rule = conical_rule<double>(24, Grading::none);
  std::mt19937 random(3);
  int found = 0;
  double nearest = 0;
  for (int trial = 0; trial < 3000 && found < 40; ++trial) {
    const std::size_t a = random() % triangles.size();
    const std::size_t b = random() % triangles.size();
    if (in_one_plane(surface.charts[triangles[a].chart], surface.charts[triangles[b].chart])) continue;
    const std::optional<CouplingDegree> coupling = look(a, b);
    if (!coupling) continue;
    ++found;
    EXPECT_LE(coupling->error_a, demand.share);
    EXPECT_LE(coupling->error_b, demand.share);
    const ModeInterpolation& interpolation = ModeTables::instance().interpolation(coupling->degree);
    const std::size_t k = interpolation.nodes.size();
    const auto frame = [&](std::size_t cluster, const Barycentric<double>& x) {
      return surface.charts[triangles[cluster].chart].in<double>().frame(triangles[cluster].at(x.x));
    };
    const auto functions = [&](const Barycentric<double>& x) {
      std::vector<double> modes(k);
      triangle_modes<double>(coupling->degree, x, modes);
      std::vector<double> values(k);
      for (std::size_t i = 0; i < k; ++i)
        for (std::size_t n = 0; n < k; ++n) values[i] += interpolation.modes_of_values(n, i) * modes[n];
      return values;
    };
    const auto kernel = [&](const Frame<double>& p, const Frame<double>& q) {
      return geometric_kernel<double>(p.point, unit_normal(p), q.point, unit_normal(q));
    };
    for (const bool rows_in_a : {true, false}) {
      const std::size_t target = rows_in_a ? a : b;
      const std::size_t source = rows_in_a ? b : a;
      const auto weighted = [&](const Frame<double>& p, const Frame<double>& q) {
        return kernel(p, q) * area_element(q) * parameter_area(triangles[source]);
      };
      std::vector<Barycentric<double>> rows{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}};
      for (int i = 0; i < 12; ++i) rows.push_back(random_point(random));
      double largest = 0;
      for (const Barycentric<double>& x : rows) {
        const Frame<double> p = frame(target, x);
        const std::vector<double> at_x = functions(x);
        std::vector<double> of_node(k);
        for (std::size_t j = 0; j < k; ++j)
          for (std::size_t i = 0; i < k; ++i)
            of_node[j] += at_x[i] * weighted(frame(target, interpolation.nodes[i]),
                                             frame(source, interpolation.nodes[j]));
        double squares = 0;
        for (std::size_t q = 0; q < rule.points.size(); ++q) {
          double difference = weighted(p, frame(source, rule.points[q]));
          const std::vector<double> at_y = functions(rule.points[q]);
          for (std::size_t j = 0; j < k; ++j) difference -= of_node[j] * at_y[j];
          squares += 2 * rule.weights[q] * difference * difference;
        }
        largest = std::max(largest, std::sqrt(squares));
      }
      const double bound =
          (rows_in_a ? coupling->error_a : coupling->error_b) * std::numbers::pi / demand.functions_size;
      ASSERT_GE(bound, largest * (1 - 1e-6)) << a << " " << b << " degree " << coupling->degree;
      nearest = std::max(nearest, largest / bound);
    }
  }
  EXPECT_EQ(found, 40);
  EXPECT_GT(nearest, 0.2) << surface.name;
}

TEST(CertifiedLook, IsAboveWhatACouplingLeavesOutAndNotFarAbove) { expect_above_what_is_left_out(cube(), 2); }

TEST(CertifiedLook, IsAboveWhatACouplingOfCurvedClustersLeavesOut) {
  for (const Surface& surface : {sphere(), ellipsoid(1, 2, 5), two_piece(2)})
    expect_above_what_is_left_out(surface, 3);
  expect_above_what_is_left_out(cylinder(1, 2), 4);
}

TEST(EnclosedTables, ContainTheRoundedOnes) {
  for (const int degree : {0, 1, 3}) {
    const LagrangeFunctions functions =
        lagrange_functions(inset_nodes(degree, degree == 0 ? Rational(0) : Rational(1, 10))).value();
    const StepFunctions steps(functions);
    constexpr int most = 6;
    const EnclosedTables tables(functions, steps, 1, most);
    const TriangleBasis<double> basis = make_triangle_basis<double>(functions);
    const LeafTables rounded(basis, 1, most);
    const std::size_t k = mode_count(most);
    const auto expect_near = [](const Ball& exact, double value) {
      EXPECT_LE(exact.radius(), 1e-25);
      EXPECT_NEAR(exact.to_double(), value, 1e-12);
    };
    for (std::size_t c = 0; c < 4; ++c)
      for (std::size_t m = 0; m < k; ++m)
        for (std::size_t n = 0; n < k; ++n)
          expect_near(tables.transfer[c](n, m), ModeTables::instance().to_parent(c)(n, m));
    for (std::size_t i = 0; i < tables.unknowns; ++i)
      for (std::size_t n = 0; n < k; ++n) {
        expect_near(tables.moments(n, i), rounded.moments(n, i));
        expect_near(tables.values(i, n), rounded.values(i, n));
      }
    // q_j >= |l_j| in the mean.
    for (std::size_t i = 0; i < tables.unknowns; ++i) {
      EXPECT_GE(tables.sizes(0, i).to_double(), rounded.absolute_moments(0, i) * (1 - 1e-9));
    }
    EXPECT_GE(steps.size, size_of_functions(basis) * (1 - 1e-9));
    EXPECT_LE(steps.size, size_of_functions(basis) * 2.1);
  }
}

TEST(StepFunctions, AreAboveTheFunctionsAtRandomPoints) {
  std::mt19937 random(5);
  for (const int degree : {0, 1, 2, 4}) {
    const LagrangeFunctions functions =
        lagrange_functions(inset_nodes(degree, degree == 0 ? Rational(0) : Rational(1, 6))).value();
    const StepFunctions steps(functions);
    const TriangleBasis<double> basis = make_triangle_basis<double>(functions);
    std::vector<double> values(basis.size());
    const std::vector<Barycentric<double>> inside{random_point(random), random_point(random),
                                                  Barycentric<double>{{1, 0, 0}},
                                                  Barycentric<double>{{0, 1, 0}}};
    const std::vector<Barycentric<double>> points = points_of_parts(StepFunctions::cuts, inside);
    double nearest = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      basis.values(points[i], values);
      for (std::size_t j = 0; j < values.size(); ++j) {
        const double bound = steps.bounds[i / inside.size()][j];
        EXPECT_GE(bound, std::abs(values[j]) * (1 - 1e-12));
        nearest = std::max(nearest, std::abs(values[j]) / bound);
      }
    }
    EXPECT_GT(nearest, 0.99);
  }
}

}  // namespace
}  // namespace radcert
