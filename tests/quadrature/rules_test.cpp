// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "brute_force.h"
#include "radcert/quadrature/bernstein.h"
#include "radcert/quadrature/chart_inverse.h"
#include "radcert/quadrature/kernel_sums.h"
#include "radcert/quadrature/tolerance.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "random_entries.h"

namespace radcert {
namespace {

/// Area by the lengths of the sampled normals; also checks the padding.
double sampled_area(const Chart& chart, const ParameterTriangle& triangle, int order) {
  Samples<double> samples;
  take_samples(chart, whole_element<double>(triangle), InsetBasis<double>(2, 0.1), order, samples);
  EXPECT_EQ(samples.x.size() % Samples<double>::lanes, 0U);
  EXPECT_EQ(samples.basis.size(), samples.x.size() * samples.functions);
  double area = 0;
  for (std::size_t q = 0; q < samples.x.size(); ++q) {
    const double part = norm(Vector<double>{samples.normal_x[q], samples.normal_y[q], samples.normal_z[q]});
    if (q < samples.count) {
      EXPECT_GT(part, 0);
    } else {
      EXPECT_EQ(part, 0);
    }
    area += part;
  }
  return area;
}

double sampled_area(const Surface& surface, std::size_t chart, int level, int order) {
  double area = 0;
  for (const ParameterTriangle& triangle : triangulate(surface, level).triangles)
    if (triangle.chart == chart) area += sampled_area(surface.charts[chart], triangle, order);
  return area;
}

TEST(Samples, HaveTheAreaOfAFaceInEveryOrder) {
  const Surface surface = box(1, 2, 5);
  for (int order = ConicalRules<double>::smallest_order; order <= ConicalRules<double>::largest_order;
       ++order) {
    EXPECT_NEAR(sampled_area(surface, 0, 0, order), 10, 1e-13) << order;
    EXPECT_NEAR(sampled_area(surface, 3, 1, order), 5, 1e-13) << order;
  }
}

TEST(Samples, HaveTheAreaOfTheSphere) {
  const Surface surface = sphere();
  for (std::size_t chart = 0; chart < 8; ++chart)
    for (const int order : {14, 19, 24})
      EXPECT_NEAR(sampled_area(surface, chart, 2, order), pi<double>() / 2, 1e-14) << chart << " " << order;
}

TEST(Samples, HaveTheAreaOfARoofThatIsNotAnalytic) {
  // Int_0^1 sqrt(1 + 9 s / 4) ds = (13 sqrt(13) - 8) / 27, graded towards apex and base.
  const Surface surface = two_piece(Rational(3, 2));
  for (const int order : {14, 19, 24})
    EXPECT_NEAR(sampled_area(surface, 1, 1, order), (13 * std::sqrt(13.0) - 8) / 27, 1e-13) << order;
}

TEST(KernelSums, AgreeWithChordSumsAwayFromTheDiagonal) {
  Stream stream(11);
  for (const Surface& surface : {sphere(), ellipsoid(1, 2, 5), two_piece(3), two_piece(Rational(3, 2))}) {
    const std::size_t chart = surface.charts.size() - 1;
    const InsetBasis<double> basis(3, 0.1);
    const ParameterTriangle triangle{chart, {{{0, 0}, {0.25, 0}, {0, 0.25}}}};
    Samples<double> samples;
    take_samples(surface.charts[chart], whole_element<double>(triangle), basis, 12, samples);
    for (int k = 0; k < 20; ++k) {
      const double s = 0.5 + 0.25 * stream.uniform();
      const CollocationPoint<double> p =
          collocation_point<double>(surface, {chart, {s, (1 - s) * stream.uniform()}});
      const KernelSums<double> plain = kernel_sums(p, samples, 5.0);
      const KernelSums<double> chords = chord_sums(p, surface.charts[chart], samples);
      EXPECT_EQ(plain.points, chords.points);
      for (std::size_t j = 0; j < basis.size(); ++j) {
        EXPECT_NEAR(plain.value[j], chords.value[j], rounding(plain, j) + rounding(chords, j))
            << surface.name;
        EXPECT_NEAR(plain.size[j], chords.size[j], rounding(plain, j) + rounding(chords, j)) << surface.name;
        EXPECT_LE(rounding(plain, j), 1e-12 * plain.size[j]) << surface.name;
      }
    }
  }
}

TEST(KernelSums, OfChordsKeepTheirDigitsOnASmallCellBesideTheObserver) {
  // G varies with the direction of Q - P: a rounding of Q by u would change it by u / size.
  const Surface surface = two_piece(3);
  const BruteForce truth(surface);
  for (const double size : {1e-3, 1e-6}) {
    const double s = 0.7 + 2 * size;
    const ParameterTriangle triangle{1, {{{s, 0.3}, {s + size, 0.3}, {s, 0.3 + size}}}};
    Samples<double> samples;
    take_samples(surface.charts[1], whole_element<double>(triangle), InsetBasis<double>(1, 0.1), 20, samples);
    const SurfacePoint<double> at{1, {0.7, 0.3}};
    const KernelSums<double> sums =
        chord_sums(collocation_point<double>(surface, at), surface.charts[1], samples);
    const BruteForce::Integral exact = truth.integrate(at, triangle, InsetBasis<Long>(1, 0.1));
    for (std::size_t j = 0; j < 3; ++j)
      EXPECT_LE(std::abs(static_cast<double>(static_cast<Long>(sums.value[j]) - exact.value[j])),
                rounding(sums, j))
          << size << " " << j;
  }
}

TEST(KernelSums, AreTheKernelTimesTheAreaOnTheSphere) {
  // G = 1/4: the sums for the constant are a quarter of the area of the samples.
  const Surface surface = sphere();
  const ParameterTriangle triangle{0, {{{0, 0}, {0.5, 0}, {0, 0.5}}}};
  Samples<double> samples;
  take_samples(surface.charts[0], whole_element<double>(triangle), InsetBasis<double>(0, 0), 20, samples);
  const double quarter = sampled_area(surface.charts[0], triangle, 20) / 4;
  EXPECT_NEAR(kernel_sums(collocation_point<double>(surface, {7, {0.25, 0.25}}), samples, 1.0).value[0],
              quarter, 1e-14);
  EXPECT_NEAR(
      chord_sums(collocation_point<double>(surface, {0, {0.25, 0.75}}), surface.charts[0], samples).value[0],
      quarter, 1e-14);
}

TEST(KernelSums, OfSumsAddWhateverRoundingsAreBoundedWith) {
  KernelSums<double> a(3);
  KernelSums<double> b(3);
  for (std::size_t j = 0; j < 3; ++j) {
    const auto of_j = static_cast<double>(j);
    a.value[j] = 1 + of_j;
    b.value[j] = -8 - of_j;
    a.size[j] = 16 + of_j;
    b.size[j] = 32 + of_j;
    a.tilt[j] = 64 + of_j;
    b.tilt[j] = 128 + of_j;
  }
  a.total = 256;
  b.total = -512;
  a.total_size = 1024;
  b.total_size = 2048;
  a.points = 5;
  b.points = 7;
  a += b;
  for (std::size_t j = 0; j < 3; ++j) {
    const auto of_j = static_cast<double>(j);
    EXPECT_EQ(a.value[j], -7) << j;
    EXPECT_EQ(a.size[j], 48 + 2 * of_j) << j;
    EXPECT_EQ(a.tilt[j], 192 + 2 * of_j) << j;
  }
  EXPECT_EQ(a.total, -256);
  EXPECT_EQ(a.total_size, 3072);
  EXPECT_EQ(a.points, 8U);  // the sum is one addition more than the longer of the two
}

TEST(BernsteinRadius, InvertsTheJoukowskyMap) {
  for (const double rho : {1.0, 1.25, 2.0, 3.0, 17.0})
    for (const double angle : {0.0, 0.5, pi<double>() / 2, 2.0, pi<double>()}) {
      const std::complex<double> w = std::polar(rho, angle);
      // At rho = 1 the square root halves the digits.
      EXPECT_NEAR(bernstein_radius((w + 1.0 / w) / 2.0), rho, rho == 1 ? 1e-7 : 1e-14 * rho)
          << rho << " " << angle;
    }
  EXPECT_EQ(bernstein_radius(1.25), 2);
  EXPECT_EQ(bernstein_radius({0, 0.75}), 2);
}

TEST(PointsFor, ReachTheIntendedTruncationAndNoMore) {
  const double intended_truncation = Tolerance().intended_truncation();
  for (const double rho : {1.5, 2.0, 3.0, 10.0}) {
    const int points = points_for(rho, 0, intended_truncation);
    EXPECT_LE(std::pow(rho, -2.0 * points), intended_truncation) << rho;
    EXPECT_GT(std::pow(rho, -2.0 * (points - 1)), intended_truncation) << rho;
    EXPECT_EQ(points_for(rho, 3, intended_truncation), points + 2) << rho;
  }
}

TEST(ChartInverse, FindsPointsOfASeamOnAndBesideCellsAndRefusesOthers) {
  const Surface surface = ellipsoid(1, 2, 5);
  const auto cell = [](const ParameterPoint<double>& a, const ParameterPoint<double>& b,
                       const ParameterPoint<double>& c) {
    return whole_element<double>({1, {a, b, c}});
  };
  const ElementPart<double> whole = cell({0, 0}, {1, 0}, {0, 1});
  Stream stream(12);
  for (int k = 0; k < 100; ++k) {
    // The octants 0 and 1 meet at u = 0, the side s + t = 1 of both.
    const double s = k == 0 ? 0 : k == 1 ? 1 : stream.uniform();
    const Vector<double> seam = surface.charts[0].in<double>().frame({s, 1 - s}).point;
    const auto at = parameters_on(surface.charts[1], whole, seam, 5.0);
    ASSERT_TRUE(at.has_value()) << s;
    EXPECT_NEAR(at->s, s, 1e-13);
    EXPECT_NEAR(at->t, 1 - s, 1e-13);
    const Vector<double> inside = surface.charts[0].in<double>().frame({s / 2, (1 - s) / 2}).point;
    EXPECT_FALSE(parameters_on(surface.charts[1], whole, inside, 5.0).has_value()) << s;
    const Vector<double> above = 1.001 * seam;
    EXPECT_FALSE(parameters_on(surface.charts[1], whole, above, 5.0).has_value()) << s;
    const ElementPart<double> half = cell({0.5, 0.5}, {0.5, 0}, {1, 0});
    const auto beside = parameters_on(surface.charts[1], half, seam, 5.0);
    ASSERT_TRUE(beside.has_value()) << s;
    EXPECT_NEAR(beside->s, s, 1e-13);
    EXPECT_NEAR(beside->t, 1 - s, 1e-13);
    if (std::abs(s - 0.5) > 1e-3) {
      EXPECT_EQ(contains(half, *beside), s > 0.5) << s;
    }
  }
}

TEST(ChartInverse, ContainsItsVerticesAndSidesAndNothingElse) {
  const ElementPart<double> cell = whole_element<double>({0, {{{0, 0}, {0.5, 0}, {0.25, 0.75}}}});
  for (const ParameterPoint<double>& inside : {ParameterPoint<double>{0, 0},
                                               {0.5, 0},
                                               {0.25, 0.75},
                                               {0.25, 0},
                                               {0.125, 0.375},
                                               {0.25, 0.25},
                                               {0.25, -1e-14}})
    EXPECT_TRUE(contains(cell, inside)) << inside.s << " " << inside.t;
  for (const ParameterPoint<double>& outside :
       {ParameterPoint<double>{0.25, -1e-9}, {0.25, 0.75 + 1e-9}, {0.125 - 1e-9, 0.375}, {0.75, 0}, {-1, -1}})
    EXPECT_FALSE(contains(cell, outside)) << outside.s << " " << outside.t;
}

}  // namespace
}  // namespace radcert
