// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/quadrature/element_integrator.h"
#include "radcert/quadrature/flat_rule_bound.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/cylinder.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/rectangle.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "radcert/surface/catalogue/two_squares.h"
#include "random_entries.h"

namespace radcert {
namespace {

struct Row {
  double sum = 0;
  double radius = 0;
};

/// Int G over the surface as the sum of a row: over all elements and functions.
Row row(const Surface& surface, const SurfacePoint<double>& at, int level, int degree, double inset) {
  const InsetBasis<double> basis(degree, inset);
  const CollocationPoint<double> p = collocation_point<double>(surface, at);
  Row row;
  for (const ParameterTriangle& triangle : triangulate(surface, level).triangles) {
    const ElementIntegral<double> integral = ElementIntegrator<double>(surface, triangle, basis).integrate(p);
    for (std::size_t j = 0; j < basis.size(); ++j) {
      row.sum += integral.value[j];
      row.radius += integral.radius[j];
    }
  }
  return row;
}

void expect_pi(const Surface& surface, std::size_t chart, const ParameterPoint<double>& at, int level,
               int degree, double inset, double accuracy) {
  const Row r = row(surface, {chart, at}, level, degree, inset);
  // Adding up the row is rounding beside the radii: a few u of the sum.
  EXPECT_LE(std::abs(r.sum - pi<double>()), r.radius + 1e-15)
      << surface.name << " chart " << chart << " at " << at.s << " " << at.t << " degree " << degree;
  EXPECT_NEAR(r.sum, pi<double>(), accuracy)
      << surface.name << " chart " << chart << " at " << at.s << " " << at.t << " degree " << degree;
}

TEST(ElementIntegrator, RowsSumToPiOnClosedSurfaces) {
  // Int_S G dS = pi on a closed convex surface [ac98, section 2]; the functions of a basis sum to 1.
  Stream stream(21);
  for (const Surface& surface : {cube(), box(1, 2, 5), sphere(), ellipsoid(1, 2, 5)})
    for (int degree = 0; degree <= 10; ++degree) {
      const std::size_t chart = stream.index(surface.charts.size());
      const double s = 0.02 + 0.5 * stream.uniform();
      const double accuracy = degree <= 3 ? 2e-13 : degree <= 8 ? 4e-12 : 4e-11;
      expect_pi(surface, chart, {s, (0.98 - s) * stream.uniform() + 0.01}, 1, degree, 0.1, accuracy);
    }
}

TEST(ElementIntegrator, RowsSumToPiBesideAnEdge) {
  const Surface surface = cube();
  for (const double inset : {1e-2, 1e-4, 1e-6})
    for (const int degree : {0, 1, 2}) expect_pi(surface, 4, {inset, 0.375}, 1, degree, inset, 1e-9);
  expect_pi(surface, 1, {1e-6, 1e-6}, 1, 1, 1e-6, 1e-9);
}

/// How far a value of a thin triangle is off against its radius: the largest of all functions.
double largest_share_of_the_radius(const Surface& surface, const ParameterTriangle& triangle,
                                   const SurfacePoint<double>& at) {
  const InsetBasis<double> basis(1, 0.1);
  const ElementIntegral<double> value =
      ElementIntegrator<double>(surface, triangle, basis).integrate(collocation_point<double>(surface, at));
  const SurfacePoint<Mpfr<50>> exactly{at.chart, {Mpfr<50>(at.at.s), Mpfr<50>(at.at.t)}};
  const ElementIntegral<Mpfr<50>> exact =
      ElementIntegrator<Mpfr<50>>(surface, triangle, InsetBasis<Mpfr<50>>(1, Mpfr<50>(0.1)), Tolerance(1e-20))
          .integrate(collocation_point<Mpfr<50>>(surface, exactly));
  double largest = 0;
  for (std::size_t j = 0; j < basis.size(); ++j) {
    const Mpfr<50> off = abs(Mpfr<50>(value.value[j]) - exact.value[j]);
    largest = std::max(largest, nearest_double<Mpfr<50>>(off) / value.radius[j]);
  }
  return largest;
}

TEST(ElementIntegrator, ThinElementsAwayFromTheOriginAreWithinTheirRadii) {
  // Corners of parts are rounded by 1e-16, which of their widths is as much as 1e-9: their areas must not be.
  Stream stream(5);
  for (int k = 0; k < 12; ++k) {
    const double width = std::pow(10, -3 - k % 5);
    const double begin = 0.5 * stream.uniform();
    const ParameterTriangle triangle{0, {{{1 - width, begin}, {1, begin}, {1 - width, begin + 0.3}}}};
    const std::size_t chart = 2 + stream.index(4);
    const double near = 0.1 * std::pow(10, -2 * stream.uniform());
    const ParameterPoint<double> at = k % 2 == 0 ? ParameterPoint<double>{near, stream.uniform()}
                                                 : ParameterPoint<double>{stream.uniform(), 1 - near};
    EXPECT_LE(largest_share_of_the_radius(cube(), triangle, {chart, at}), 1)
        << width << " chart " << chart << " at " << at.s << " " << at.t;
  }
}

TEST(ElementIntegrator, ThinElementsInAnyDirectionAreWithinTheirRadii) {
  for (const double width : {1e-3, 1e-5, 1e-8, 1e-12}) {
    const ParameterTriangle triangle{0, {{{0.1, 0.2}, {0.8, 0.7}, {0.45 - width / 2, 0.45 + 0.7 * width}}}};
    EXPECT_LE(largest_share_of_the_radius(cube(), triangle, {2, {0.3, 0.4}}), 0.2) << width;
  }
}

TEST(ElementIntegrator, ThinElementsAboutThePointAreWithinTheirRadii) {
  // Found by search: the width is 3.6e-7 and 6.6e-7, P lies inside and on the chart beside it.
  const Surface surface = cylinder(1, 1);
  EXPECT_LE(largest_share_of_the_radius(surface,
                                        {11,
                                         {{{0.83906112611293793, 0.518022820353508},
                                           {0.98519077897071838, 0.66415251791477203},
                                           {0.83652360737323761, 0.51548540592193604}}}},
                                        {11, {0.85853336053964291, 0.53749440397870873}}),
            1);
  EXPECT_LE(largest_share_of_the_radius(surface,
                                        {9,
                                         {{{0.99999933775880834, 0.0078879091820585057},
                                           {1, 0.0078879091820585057},
                                           {0.99999933775880834, 0.12496101857488498}}}},
                                        {8, {0.99999607313511385, 0.0078807759399423961}}),
            1);
}

TEST(ElementIntegrator, RowsSumToPiInThinBoxesWithinTheirRadii) {
  // The nearer the walls, the less their rounded coordinates say: the radius tells how little.
  for (const int k : {1, 3, 6, 8, 9, 10, 11, 12, 13, 14, 15, 17, 30}) {
    const Rational thickness = Rational(1) / power(Rational(10), k);
    for (const Surface& surface : {box(thickness, 1, 1), box(3, thickness, Rational(1, 3))})
      for (std::size_t chart = 0; chart < 6; chart += 2) {
        const Row r = row(surface, {chart, {1.0 / 6, 2.0 / 3}}, 0, 1, 1.0 / 6);
        EXPECT_LE(std::abs(r.sum - pi<double>()), r.radius + 1e-15) << "10^-" << k << " chart " << chart;
        if (k <= 6) {
          EXPECT_LT(r.radius, 1e-13 * std::pow(10.0, k + 2)) << k << " chart " << chart;
        }
      }
  }
}

TEST(ElementIntegrator, KnowsThatNothingIsKnownNearerThanRounding) {
  // Two walls that coordinates in double do not tell apart: the integral over the other is between 0 and pi.
  const Surface surface = box(Rational(1, 1000000) * Rational(1, 1000000) * Rational(1, 1000000), 1, 1);
  const InsetBasis<double> basis(0, 0);
  double value = 0;
  double radius = 0;
  for (const ParameterTriangle& triangle : triangulate(surface, 0).triangles) {
    if (surface.charts[triangle.chart].facts().name != "east") continue;
    const ElementIntegral<double> integral =
        ElementIntegrator<double>(surface, triangle, basis)
            .integrate(collocation_point<double>(surface, {0, {0.3, 0.4}}));
    value += integral.value[0];
    radius += integral.radius[0];
  }
  EXPECT_GE(value + radius, pi<double>());
  EXPECT_LE(value - radius, 0);
}

TEST(ElementIntegrator, RowsSumToPiOnSeamsAndCornersOfTheOctahedron) {
  for (const Surface& surface : {sphere(), ellipsoid(1, 2, 5)})
    for (const int degree : {0, 2})
      for (const ParameterPoint<double>& at : {ParameterPoint<double>{0, 0},
                                               {1, 0},
                                               {0, 1},
                                               {0.5, 0.5},
                                               {0.25, 0},
                                               {0, 0.375},
                                               {0.25, 0.25},
                                               {1.0 / 3, 2.0 / 3}})
        expect_pi(surface, 3, at, 1, degree, 0, 1e-12);
}

TEST(ElementIntegrator, RowsSumToPiBesideSeamsAndRims) {
  // Beside a seam the neighbouring chart continues to the collocation point; across the rim of a thin
  // ellipsoid the other side is nearer than the way round it.
  for (const Surface& surface : {ellipsoid(1, 2, 5), ellipsoid(1, 1, Rational(1, 20))})
    for (const int level : {1, 2, 3})
      for (const ParameterPoint<double>& at :
           {ParameterPoint<double>{0.2083333333333333, 0.08333333333333333},
            {0.01, 0.4},
            {0.3, 1e-5},
            {0.6, 0.399}})
        expect_pi(surface, 6, at, level, 1, 1.0 / 6, 1e-12);
}

TEST(ElementIntegrator, IsAQuarterOfTheAreaOnTheSphereOctantByOctant) {
  const Surface surface = sphere();
  const InsetBasis<double> constant(0, 0);
  for (const SurfacePoint<double>& at :
       {SurfacePoint<double>{0, {0.25, 0.5}}, {0, {1e-3, 0.5}}, {5, {0.75, 0.125}}}) {
    const CollocationPoint<double> p = collocation_point<double>(surface, at);
    for (const ParameterTriangle& octant : triangulate(surface, 0).triangles) {
      const ElementIntegral<double> integral =
          ElementIntegrator<double>(surface, octant, constant).integrate(p);
      EXPECT_LE(std::abs(integral.value[0] - pi<double>() / 8), integral.radius[0] + 1e-16) << octant.chart;
      EXPECT_NEAR(integral.value[0], pi<double>() / 8, 1e-12) << octant.chart;
    }
  }
}

TEST(ElementIntegrator, FunctionsSumToTheConstantAndChildrenToTheirParent) {
  Stream stream(22);
  const InsetBasis<double> constant(0, 0);
  for (const Surface& surface :
       {cube(), sphere(), ellipsoid(1, 2, 5), two_piece(3), two_piece(Rational(3, 2)), two_squares()}) {
    const std::vector<ParameterTriangle> fine = triangulate(surface, 2).triangles;
    const TouchingElements elements(surface, 1);
    for (const Place place : {Place::own, Place::edge, Place::vertex, Place::apart})
      for (int attempt = 0; attempt < 6; ++attempt) {
        const auto c = elements.draw(place, 3, 0.05, stream);
        if (!c) continue;
        const CollocationPoint<double> p = collocation_point<double>(surface, c->observer);
        const ElementIntegral<double> parent =
            ElementIntegrator<double>(surface, c->element, constant).integrate(p);
        const InsetBasis<double> basis(3, c->inset);
        const ElementIntegral<double> parts =
            ElementIntegrator<double>(surface, c->element, basis).integrate(p);
        double sum = 0;
        double allowed = parent.radius[0];
        for (std::size_t j = 0; j < basis.size(); ++j) {
          sum += parts.value[j];
          allowed += parts.radius[j];
        }
        EXPECT_NEAR(sum, parent.value[0], allowed) << c->text();
        EXPECT_GT(parent.value[0], 0) << c->text();
        double children = 0;
        allowed = parent.radius[0];
        for (std::size_t k = 0; k < 4; ++k) {
          const ElementIntegral<double> child =
              ElementIntegrator<double>(surface, fine[4 * c->element_index + k], constant).integrate(p);
          children += child.value[0];
          allowed += child.radius[0];
        }
        EXPECT_NEAR(children, parent.value[0], allowed) << c->text();
        EXPECT_LE(allowed, 1e-11) << c->text();
      }
  }
}

TEST(ElementIntegrator, IsExactlyZeroInOnePlane) {
  for (const Surface& surface : {cube(), box(1, 2, 5), two_squares(), two_piece(1)}) {
    const InsetBasis<double> basis(2, 0.1);
    for (const ParameterTriangle& triangle : triangulate(surface, 1).triangles) {
      ElementIntegrator<double> element(surface, triangle, basis);
      for (std::size_t chart = 0; chart < surface.charts.size(); ++chart) {
        const ElementIntegral<double> integral =
            element.integrate(collocation_point<double>(surface, {chart, {0.3, 0.45}}));
        const bool zero = chart == triangle.chart;
        for (std::size_t j = 0; j < basis.size(); ++j) {
          EXPECT_EQ(integral.value[j] == 0, zero);
          EXPECT_EQ(integral.radius[j] == 0, zero);
        }
        EXPECT_EQ(integral.absolute == 0, zero);
      }
    }
  }
}

TEST(ElementIntegrator, IsExactlyZeroBetweenTwoChartsInOnePlane) {
  Surface surface = two_squares();
  surface.charts.push_back(
      make_rectangle({.name = "beside", .piece = "beside"}, {1, 0, 0}, {Rational(1, 3), 0, 0}, {0, 1, 0}));
  surface.diagonals.push_back(Diagonal::main);
  const CollocationPoint<double> p = collocation_point<double>(surface, {1, {1 - 1e-9, 0.5}});
  for (const ParameterTriangle& triangle : triangulate(surface, 1).triangles) {
    const double value =
        ElementIntegrator<double>(surface, triangle, InsetBasis<double>(0, 0)).integrate(p).value[0];
    EXPECT_EQ(value == 0, triangle.chart != 0) << triangle.chart;
  }
}

TEST(ElementIntegrator, DoesNotDependOnTheScale) {
  // G dS is without dimension, and a power of two scales every operation exactly.
  const Surface surface = box(1, 2, 5);
  const Surface scaled = box(8, 16, 40);
  const InsetBasis<double> basis(2, 0.1);
  const std::vector<ParameterTriangle> triangles = triangulate(surface, 1).triangles;
  for (std::size_t k = 0; k < triangles.size(); k += 5)
    for (std::size_t chart = 0; chart < 6; ++chart) {
      const SurfacePoint<double> at{chart, {0.01, 0.3}};
      const ElementIntegral<double> a = ElementIntegrator<double>(surface, triangles[k], basis)
                                            .integrate(collocation_point<double>(surface, at));
      const ElementIntegral<double> b = ElementIntegrator<double>(scaled, triangles[k], basis)
                                            .integrate(collocation_point<double>(scaled, at));
      for (std::size_t j = 0; j < basis.size(); ++j) {
        EXPECT_EQ(a.value[j], b.value[j]) << k << " " << chart;
        EXPECT_EQ(a.radius[j], b.radius[j]) << k << " " << chart;
      }
    }
}

TEST(ElementIntegrator, KeepsACoarserToleranceWithFewerPoints) {
  const InsetBasis<double> basis(1, 1.0 / 6);
  for (const Surface& surface : {cube(), two_piece(2)}) {
    const Triangulation triangulation = triangulate(surface, 2);
    std::vector<CollocationPoint<double>> nodes;
    for (const ParameterTriangle& triangle : triangulation.triangles)
      for (const Barycentric<double>& node : basis.nodes())
        nodes.push_back(collocation_point<double>(surface, {triangle.chart, triangle.at(node.x)}));
    for (const double tolerance : {1e-3, 1e-6, 1e-10}) {
      std::vector<double> row(nodes.size());
      std::vector<double> largest_error(nodes.size());
      for (const ParameterTriangle& triangle : triangulation.triangles) {
        ElementIntegrator<double> coarse(surface, triangle, basis, Tolerance(tolerance));
        ElementIntegrator<double> fine(surface, triangle, basis);
        for (const CollocationPointBlock<double>& block : observer_blocks<double>(nodes)) {
          BlockIntegral<double> a;
          BlockIntegral<double> b;
          coarse.integrate(block, nodes, a);
          fine.integrate(block, nodes, b);
          for (std::size_t i = 0; i < block.count; ++i) {
            row[block.first + i] += b.absolute.lane(i);
            for (std::size_t j = 0; j < basis.size(); ++j) {
              const double error = std::abs(a.value[j].lane(i) - b.value[j].lane(i));
              EXPECT_LE(error, a.radius[j].lane(i) + b.radius[j].lane(i));
              largest_error[block.first + i] = std::max(largest_error[block.first + i], error);
            }
          }
        }
      }
      for (std::size_t i = 0; i < nodes.size(); ++i)
        EXPECT_LE(largest_error[i], tolerance * row[i]) << surface.name << " " << tolerance;
    }
  }
}

/// The largest |(Q - P).n_P| R^3 / |P - Q|^4 over complex Q on the chords of the unit ball through its
/// centre, z in the Bernstein ellipse rho, P at the distance R and n_P towards the centre.
double largest_on_ellipse(double distance, double rho) {
  constexpr int around = 64;
  double largest = 0;
  for (const double angle : {0.0, 0.2, 1.0})
    for (int k = 0; k < around; ++k) {
      const std::complex<double> turned = std::polar(rho, 2 * std::numbers::pi * k / around);
      const std::complex<double> z = 0.5 * (turned + 1.0 / turned);
      const std::complex<double> along = distance * std::cos(angle) - z;
      const std::complex<double> squared = along * along + std::pow(distance * std::sin(angle), 2);
      largest = std::max(
          largest, std::abs(distance - z * std::cos(angle)) * std::pow(distance, 3) / std::norm(squared));
    }
  return largest;
}

TEST(FlatRuleBound, IsThatOfTheBestEllipseForTheKernelItself) {
  // What the bound is made of: twice 2 M rho^-m/(rho-1), m = 2n - 1 - d, for two variables, M the largest
  // value of the kernel. P in the line of a chord comes as near to it as the bound says, but for sqrt(1 +
  // g^2) in place of g; the bound takes the largest (Q - P).n_P at the nearest Q, which is (1 + theta)/(1 -
  // theta) too much.
  for (const double eta : {8.0, 16.0, 64.0})
    for (const int degree : {0, 2})
      for (const int n : {3, 5, 8}) {
        double least = HUGE_VAL;
        for (double rho = 1.05; rho < 2 * eta; rho *= 1.01) {
          const double g = 0.5 * (rho + 1 / rho);
          if (g >= eta) break;
          least = std::min(
              least, 2 * 4 * largest_on_ellipse(eta, rho) * std::pow(rho, degree - (2 * n - 1)) / (rho - 1));
        }
        EXPECT_GE(flat_rule_bound(n, degree, eta), least) << eta << " " << degree << " " << n;
        EXPECT_LE(flat_rule_bound(n, degree, eta), 16 * least) << eta << " " << degree << " " << n;
      }
}

TEST(FlatRuleBound, LiesAboveTheErrorAndDecays) {
  // A right triangle in the plane z = 0 with its centroid at 0, seen by P at distance eta r in many
  // directions.
  const Surface surface = cube();
  const std::size_t floor = 4;
  ASSERT_EQ(surface.charts[floor].facts().name, "floor");
  const ParameterTriangle triangle{floor, {{{0, 0}, {0.5, 0}, {0, 0.5}}}};
  const Vector<double> centre{0.5 / 3, 0.5 / 3, 0};
  const double radius = std::sqrt(5.0) / 6;
  for (const int degree : {0, 1, 3}) {
    const InsetBasis<double> basis(degree, 0.1);
    const IntegrationScheme<double> scheme(surface, basis, Tolerance());
    const auto rule = [&](int order) {
      Samples<double> samples;
      take_samples(surface.charts[floor], whole_element<double>(triangle), basis, order, samples);
      return samples;
    };
    const Samples<double> exact = rule(24);
    for (const double eta : {2.5, 4.0, 8.0, 16.0})
      for (const int order : {2, 3, 4, 6, 8}) {
        const Samples<double> samples = rule(order);
        for (const double height : {0.05, 0.3, 0.9})
          for (const double angle : {0.3, 1.7, 3.0, 4.4, 5.9}) {
            const double level = std::sqrt(1 - height * height);
            const double distance = eta * radius;
            const Vector<double> d{level * std::cos(angle), level * std::sin(angle), height};
            const CollocationPoint<double> p{{0, {0, 0}}, centre + distance * d, -d};
            const KernelSums<double> a = kernel_sums(p, samples, 1.0);
            const KernelSums<double> b = kernel_sums(p, exact, 1.0);
            const double scale = 0.125 * distance * height / std::pow(distance, 3);
            for (std::size_t j = 0; j < basis.size(); ++j) {
              const double bound = flat_rule_bound(order, degree, eta) * scale * scheme.largest_value(j);
              EXPECT_LE(std::abs(a.value[j] - b.value[j]), bound + rounding(a, j) + rounding(b, j));
            }
          }
        EXPECT_LT(flat_rule_bound(order + 1, degree, eta), flat_rule_bound(order, degree, eta));
        EXPECT_LT(flat_rule_bound(order, degree, 1.1 * eta), flat_rule_bound(order, degree, eta));
      }
  }
}

TEST(ElementIntegrator, IsSymmetricInObserverAndElement) {
  // Int_A Int_B G = Int_B Int_A G: by a rule in the observer, between two faces well apart.
  const Surface surface = cube();
  const ParameterTriangle floor{4, {{{0, 0}, {1, 0}, {0, 1}}}};
  const ParameterTriangle ceiling{5, {{{0, 0}, {1, 0}, {1, 1}}}};
  const auto both = [&](const ParameterTriangle& from, const ParameterTriangle& onto) {
    ElementIntegrator<double> element(surface, onto, InsetBasis<double>(0, 0));
    const TriangleRule<double> rule = conical_rule<double>(16, Grading::none);
    double sum = 0;
    for (std::size_t q = 0; q < rule.weights.size(); ++q)
      sum += rule.weights[q] *
             element.integrate(collocation_point<double>(surface, {from.chart, from.at(rule.points[q].x)}))
                 .value[0];
    return sum;
  };
  EXPECT_NEAR(both(floor, ceiling), both(ceiling, floor), 1e-14);
}

}  // namespace
}  // namespace radcert
