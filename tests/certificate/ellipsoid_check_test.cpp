// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/ellipsoid/ellipsoid_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "radcert/certificate/certificate.h"
#include "radcert/core/parallel.h"
#include "tests/certificate/ellipsoid_samples.h"
#include "tests/continuous/ellipsoid_judge.h"

namespace radcert::certificate {
namespace {

constexpr std::size_t all = std::numeric_limits<std::size_t>::max();

std::string text_of(const Report& report) {
  return report.refusal ? report.refusal->pointer + ": " + report.refusal->says : "verified";
}

const Vector<Rational> usual_axes{1, Rational(13, 10), Rational(17, 10)};

TEST(SphereCover, HasAPointWithinTheDistance) {
  Draw draw(1);
  for (const double distance : {1.0, 0.3, 0.07}) {
    const SphereCover cover(distance);
    double farthest = 0;
    for (int k = 0; k < 4000; ++k) {
      const Vector<double> p = test::drawn_direction(draw);
      double nearest = 10;
      for (std::size_t row = 0; row < cover.rows(); ++row)
        for (std::size_t place = 0; place < cover.count(row); ++place)
          nearest = std::min(nearest, 2 * std::asin(0.5 * norm(p - cover.point(row, place))));
      farthest = std::max(farthest, nearest);
    }
    EXPECT_LE(farthest, distance);
    EXPECT_GT(farthest, 0.7 * distance);
  }
}

/// cos(L s + phase) has its largest value between points where a step of the grid says so.
TEST(BetweenPoints, HoldsForTrigonometricPolynomials) {
  for (const int degree : {1, 3, 12})
    for (const double part : {0.01, 0.3, 0.9, 1.2}) {
      const BetweenPoints between{.degree = degree, .distance = part / degree, .left = 0, .slope_left = 0};
      const double seen = std::cos(part);
      EXPECT_LE(between.at_points(1), seen);
      EXPECT_GT(between.at_points(1), seen - 0.05 * part * part * part);
    }
  // With something beside it: f = cos(L s) + e, e = -left at p, and as large as it may be at the point.
  const BetweenPoints between{.degree = 4, .distance = 0.1, .left = 0.02, .slope_left = 0.3};
  const double largest = 1 - 0.02;
  const double at_point = std::cos(0.4) - 0.02;
  EXPECT_LE(between.at_points(largest), at_point);
  const BetweenPoints clean{.degree = 4, .distance = 0.1, .left = 0, .slope_left = 0};
  EXPECT_LT(between.at_points(largest), clean.at_points(largest) - 0.07);
}

/// Fourier's coefficients of T w on great circles.
TEST(BetweenPoints, BoundsWhatCirclesLeave) {
  Draw draw(2);
  for (int k = 0; k < 4; ++k) {
    const EllipsoidCertificate c = test::drawn_ellipsoid(draw, 2);
    const EllipsoidStretch stretch(c.half_axes);
    const SphereDensity w(c);
    const RayTransport transport(stretch, w, 1e-11);
    const BetweenPoints between = between_points(stretch, w, 30);
    ASSERT_GT(between.degree, 0);
    EXPECT_LE(between.degree * between.distance, 1.06);
    const Vector<double> one = test::drawn_direction(draw);
    const Vector<double> across = cross(one, test::drawn_direction(draw));
    const Vector<double> other = (1 / norm(across)) * across;
    constexpr int nodes = 128;
    std::vector<double> values;
    for (int j = 0; j < nodes; ++j) {
      const double s = 2 * std::numbers::pi * j / nodes;
      values.push_back(transport(std::cos(s) * one + std::sin(s) * other).value);
    }
    double left = 0;
    double slope = 0;
    for (int n = between.degree + 1; n < nodes / 2; ++n) {
      std::complex<double> sum = 0;
      for (int j = 0; j < nodes; ++j)
        sum += values[static_cast<std::size_t>(j)] *
               std::polar(1.0 / nodes, -2 * std::numbers::pi * n * j / nodes);
      left += 2 * std::abs(sum);
      slope += 2 * n * std::abs(sum);
    }
    EXPECT_LE(left, between.left);
    EXPECT_LE(slope, between.slope_left);
  }
}

/// By hand: B = 1 for all s up to ln 2 would give these; here from the function itself, at one degree more.
TEST(BetweenPoints, FallsAsTheStripIsWide) {
  Draw draw(3);
  const EllipsoidCertificate c = test::drawn_ellipsoid(draw, 2);
  const EllipsoidStretch stretch(c.half_axes);
  const SphereDensity w(c);
  const BetweenPoints coarse = between_points(stretch, w, 1);
  const BetweenPoints fine = between_points(stretch, w, 1e-8);
  EXPECT_LT(coarse.degree, fine.degree);
  // left and slope_left by their series, for the s that is best there.
  double least = std::numeric_limits<double>::infinity();
  for (int k = 1; k < 60; ++k) {
    const double s = stretch.widest() * k / 60;
    const double bound = transported_around(stretch, w, s);
    double left = 0;
    double slope = 0;
    for (int n = fine.degree + 1; n < fine.degree + 4000; ++n) {
      left += 2 * bound * std::exp(-n * s);
      slope += 2 * bound * n * std::exp(-n * s);
    }
    if (std::abs(left - fine.left) < 1e-6 * left) {
      EXPECT_NEAR(slope, fine.slope_left, 1e-6 * slope);
      least = left;
    }
  }
  EXPECT_LT(least, 1e-8);
}

TEST(EllipsoidCheck, VerifiesWhatTheSearchFound) {
  const std::vector<Vector<Rational>> points{{1, 0, 0}, {0, Rational(78, 100), Rational(-136, 100)}};
  for (const auto& [axes, rho, emission] :
       {std::tuple(usual_axes, "1/2", "1 + x"), std::tuple(usual_axes, "1/2 + x/4", "z^2"),
        std::tuple(Vector<Rational>{2, 2, 2}, "1/3 + x*y/9", "1 + z^3"),
        std::tuple(Vector<Rational>{1, Rational(11, 10), 1}, "0", "x*y*z")})
    for (const OnEllipsoid of : {OnEllipsoid::mean, OnEllipsoid::function, OnEllipsoid::values}) {
      const bool own_points = of == OnEllipsoid::values && axes == usual_axes;
      if (of == OnEllipsoid::values && !own_points) continue;
      const EllipsoidCertificate c = test::certified_ellipsoid(
          axes, rho, emission, 1e-4, of, own_points ? points : std::vector<Vector<Rational>>{});
      const Report report = check(c, {.elements = all, .seed = {}});
      EXPECT_FALSE(report.refusal) << rho << " " << emission << " " << text_of(report);
      EXPECT_EQ(report.looked_at.size(), part_count(c));
      EXPECT_LE(c.width, Rational(4, 10000));
      EXPECT_EQ(check(c, {.elements = 3, .seed = "few"}).looked_at.size(),
                std::min<std::size_t>(3, part_count(c)));
    }
}

/// Means and values of one solution agree with the search's own, and with energy: the mean of (1 - rho) u is
/// that of E.
TEST(EllipsoidCheck, EnclosesWhatAConstantReflectivityGives) {
  const EllipsoidCertificate c = test::certified_ellipsoid(usual_axes, "3/5", "z^2", 1e-5, OnEllipsoid::mean);
  const long double truth =
      judge::mean_over({1, 1.3L, 1.7L}, [](const judge::Triple& q) { return q[2] * q[2]; }) / 0.4L;
  EXPECT_LE(std::abs(c.enclosures[0].midpoint.to_double() - static_cast<double>(truth)),
            c.enclosures[0].radius.to_double() + 1e-12);
  // Without the law of energy: the mean of w, within the bound.
  EllipsoidCertificate bent = c;
  bent.reflectivity.push_back({{0, 0, 1}, Rational(1, 1000000000)});
  const Ball by_w = enclosed(bent)[0];
  EXPECT_TRUE(overlaps(by_w, widened(Ball(c.enclosures[0].midpoint), Ball(c.enclosures[0].radius))));
  EXPECT_GT(by_w.radius(), c.bound.to_double() * 0.999);
}

/// t = (1 - rho) d + e Re zeta^m on the sphere, (1 - rho) d on any ellipsoid.
TEST(EllipsoidCheck, IsSharpWhereResidualsAreKnown) {
  const Part whole{.elements = all, .seed = {}};
  for (const OnEllipsoid of : {OnEllipsoid::mean, OnEllipsoid::values, OnEllipsoid::function})
    for (const auto& [axes, e, m] :
         {std::tuple(usual_axes, 0.0, 0), std::tuple(Vector<Rational>{1, 1, 1}, 0.01, 5),
          std::tuple(Vector<Rational>{3, 3, 3}, 0.02, 12)}) {
      const double sup = 0.5 * 0.01 + e;
      const auto claiming = [&](double x) {
        return test::furnace_ellipsoid(axes, Rational(1, 2), 0.01, e, m, x * sup, of);
      };
      const Report above = check(claiming(2.6), whole);
      EXPECT_FALSE(above.refusal) << text_of(above);
      // Between points it could be larger than at them.
      EXPECT_TRUE(check(claiming(1.5), whole).refusal);
      const Report below = check(claiming(0.999), whole);
      ASSERT_TRUE(below.refusal);
      EXPECT_EQ(below.refusal->pointer, "/residual");
      for (const Enclosure& one : claiming(2.6).enclosures)
        EXPECT_LE(abs(one.midpoint - Rational(1)), one.radius);
    }
}

TEST(EllipsoidCheck, RefusesAHundredRandomChanges) {
  const std::vector<Vector<Rational>> points{{1, 0, 0}, {0, Rational(78, 100), Rational(-136, 100)}};
  const EllipsoidCertificate values =
      test::certified_ellipsoid(usual_axes, "1/2 + x/4", "1 + z^2", 1e-5, OnEllipsoid::values, points);
  const EllipsoidCertificate mean =
      test::certified_ellipsoid(usual_axes, "1/2 + x/4", "1 + z^2", 1e-5, OnEllipsoid::mean);
  const EllipsoidCertificate function =
      test::certified_ellipsoid(usual_axes, "1/2 + x/4", "1 + z^2", 1e-5, OnEllipsoid::function);
  ASSERT_FALSE(check(values, {.elements = all, .seed = {}}).refusal);
  ASSERT_FALSE(check(mean, {.elements = all, .seed = {}}).refusal);
  Draw draw(5);
  for (int k = 0; k < 100; ++k) {
    EllipsoidCertificate c = k % 3 == 0 ? values : k % 3 == 1 ? mean : function;
    const auto sign = [&] { return draw.below(2) == 0 ? 1L : -1L; };
    const Rational little(sign(), 2000);
    std::string what;
    switch (draw.below(9)) {
      case 0: {
        std::array<Rational*, 3> axes{&c.half_axes.x, &c.half_axes.y, &c.half_axes.z};
        *axes[draw.below(3)] *= Rational(1) + little;
        what = "half axis";
        break;
      }
      case 1:
        c.reflectivity[draw.below(2)].coefficient += little;
        what = "reflectivity";
        break;
      case 2:
        c.emission[draw.below(2)].coefficient += little;
        what = "emission";
        break;
      case 3: {
        // (1 - s) times what q changes is more than two residuals.
        const std::size_t place = draw.below(c.cosines.size());
        (draw.below(2) == 0 || place <= static_cast<std::size_t>(c.degree) ? c.cosines : c.sines)[place] +=
            static_cast<double>(sign()) * 40 * c.residual;
        what = "coefficient " + std::to_string(place);
        break;
      }
      case 4:
        c.largest_reflectivity *= Rational(99, 100);
        what = "largest reflectivity";
        break;
      case 5:
        c.residual *= 0.5;
        what = "residual";
        break;
      case 6:
        c.bound *= Rational(999, 1000);
        what = "bound";
        break;
      case 7:
        c.width *= Rational(99, 100);
        what = "width";
        break;
      default:
        if (c.of == OnEllipsoid::function) {
          c.residual *= 1.01;
          what = "residual without its bound";
        } else if (draw.below(2) == 0) {
          Enclosure& one = c.enclosures[draw.below(c.enclosures.size())];
          one.midpoint += Rational(sign(), 100) * one.radius;
          what = "midpoint";
        } else {
          c.enclosures[draw.below(c.enclosures.size())].radius *= Rational(99, 100);
          what = "radius";
        }
    }
    EXPECT_TRUE(check(c, {.elements = all, .seed = {}}).refusal) << k << " " << what;
  }
}

TEST(EllipsoidCheck, RefusesWhatIsNoSuchProblem) {
  const EllipsoidCertificate good =
      test::furnace_ellipsoid(usual_axes, Rational(1, 2), 0.01, 0, 0, 0.02, OnEllipsoid::values);
  const auto refused = [&](auto change) {
    EllipsoidCertificate c = good;
    change(c);
    const Report report = check(c, {.elements = all, .seed = {}});
    return report.refusal ? report.refusal->pointer : std::string("verified");
  };
  EXPECT_EQ(refused([](EllipsoidCertificate&) {}), "verified");
  EXPECT_EQ(refused([](EllipsoidCertificate& c) { c.half_axes.y = 0; }), "/problem/half_axes/1");
  EXPECT_EQ(refused([](EllipsoidCertificate& c) { c.largest_reflectivity = 1; }), "/largest_reflectivity");
  EXPECT_EQ(refused([](EllipsoidCertificate& c) { c.reflectivity[0].coefficient = Rational(6, 10); }),
            "/largest_reflectivity");
  EXPECT_EQ(refused([](EllipsoidCertificate& c) {
              c.reflectivity.push_back({{2, 0, 0}, Rational(1, 100)});
            }),
            "/largest_reflectivity");
  EXPECT_EQ(refused([](EllipsoidCertificate& c) { c.points[1].x += Rational(1, 1000000); }),
            "/problem/points/1");
}

/// A reflectivity that reaches what is stated between points of any cover.
TEST(EllipsoidCheck, BoundsReflectivitiesEverywhere) {
  EllipsoidCertificate c =
      test::furnace_ellipsoid({1, 1, 1}, Rational(1, 2), 0.001, 0, 0, 0.02, OnEllipsoid::function);
  c.emission = {{{0, 0, 0}, Rational(1, 2)}};
  // (x^2 - y^2)/4 + 1/2 <= 3/4, reached at (1, 0, 0).
  c.reflectivity = {{{0, 0, 0}, Rational(1, 2)}, {{2, 0, 0}, Rational(1, 4)}, {{0, 2, 0}, Rational(-1, 4)}};
  const auto pointer = [&](const Rational& stated) {
    c.largest_reflectivity = stated;
    c.bound = 100;
    c.width = 1000;
    const Report report = check(c, {.elements = all, .seed = {}});
    return report.refusal ? report.refusal->pointer : std::string();
  };
  EXPECT_EQ(pointer(Rational(7499, 10000)), "/largest_reflectivity");
  EXPECT_NE(pointer(Rational(752, 1000)), "/largest_reflectivity");
}

TEST(EllipsoidCheck, RefusesReflectivitiesThatAreNegative) {
  EllipsoidCertificate c =
      test::furnace_ellipsoid({1, 1, 1}, Rational(1, 2), 0.001, 0, 0, 0.02, OnEllipsoid::function);
  const auto pointer = [&](const std::vector<Monomial>& rho) {
    c.reflectivity = rho;
    c.largest_reflectivity = Rational(9, 10);
    c.bound = 100;
    c.width = 1000;
    const Report report = check(c, {.elements = 1, .seed = {}});
    return report.refusal ? report.refusal->pointer : std::string();
  };
  EXPECT_EQ(pointer({{{0, 0, 0}, Rational(-1, 2)}}), "/problem/reflectivity");
  EXPECT_EQ(pointer({{{0, 0, 0}, Rational(1, 4)}, {{1, 0, 0}, Rational(1, 3)}}), "/problem/reflectivity");
  // 0 at (-1, 0, 0) alone.
  EXPECT_NE(pointer({{{0, 0, 0}, Rational(1, 4)}, {{1, 0, 0}, Rational(1, 4)}}), "/problem/reflectivity");
}

TEST(EllipsoidCheck, IsTheSameForAnyNumberOfThreads) {
  const EllipsoidCertificate c =
      test::furnace_ellipsoid(usual_axes, Rational(1, 2), 0.01, 0, 0, 0.004, OnEllipsoid::mean);
  std::string one;
  {
    const ThreadLimit limit(1);
    one = text_of(check(c, {.elements = all, .seed = {}}));
  }
  EXPECT_EQ(text_of(check(c, {.elements = all, .seed = {}})), one);
}

}  // namespace
}  // namespace radcert::certificate
