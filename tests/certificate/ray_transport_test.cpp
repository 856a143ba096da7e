// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/ellipsoid/ray_transport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "radcert/scalar/ball.h"
#include "tests/certificate/ellipsoid_samples.h"
#include "tests/continuous/ellipsoid_judge.h"

namespace radcert::certificate {
namespace {

using test::ComplexPoint;
using test::TurnedPoint;

/// Points of the sphere with rational coordinates, by the stereographic projection.
Vector<Rational> rational_point(Draw& draw) {
  const Rational s(static_cast<long>(draw.below(400)) - 200, 100);
  const Rational t(static_cast<long>(draw.below(400)) - 200, 100);
  const Rational n = Rational(1) + s * s + t * t;
  return {Rational(2) * s / n, Rational(2) * t / n, (n - Rational(2)) / n};
}

Vector<double> rounded(const Vector<Rational>& p) {
  return {p.x.to_double(), p.y.to_double(), p.z.to_double()};
}

TEST(SphereDensity, IsWithinItsErrorOfExactValues) {
  Draw draw(1);
  for (int k = 0; k < 60; ++k) {
    const EllipsoidCertificate c = test::drawn_ellipsoid(draw, static_cast<int>(draw.below(30)));
    const SphereDensity w(c);
    const Vector<Rational> p = rational_point(draw);
    const Vector<Rational> at{c.half_axes.x * p.x, c.half_axes.y * p.y, c.half_axes.z * p.z};
    const Ball exact = Ball(value_of(c.emission, at)) + Ball(value_of(c.reflectivity, at)) * w.q.at(p);
    const Vector<double> near = rounded(p);
    // Moved on purpose, by 1e-9.
    for (const double moved : {0.0, 1e-9}) {
      const Vector<double> q = near + moved * test::drawn_direction(draw);
      const double value = w({q.x, q.y, q.z}).lane(3);
      const double off = abs(exact - Ball(value)).upper_double();
      const double error = w.error(moved + 0x1p-53);
      EXPECT_LE(off, error);
      EXPECT_LT(error, moved > 0 ? 1e-6 : 1e-12);
    }
    const std::complex<double> other = test::w_at(c, {near.x, near.y, near.z});
    EXPECT_NEAR(other.real(), exact.to_double(), 1e-11);
  }
}

TEST(SphereDensity, IsBoundedAroundTheSphere) {
  Draw draw(10);
  for (int k = 0; k < 300; ++k) {
    EllipsoidCertificate c = test::drawn_ellipsoid(draw, static_cast<int>(draw.below(4)));
    if (k % 3 == 0) c.emission.clear();
    if (k % 3 == 1) std::fill(c.cosines.begin() + 1, c.cosines.end(), 0);
    if (k % 2 == 0) c.cosines[0] = 0.01;
    const SphereDensity w(c);
    const double s = 2 * draw.unit();
    const std::complex<double> value = test::w_at(c, test::drawn_turned(draw).at(s));
    EXPECT_LE(std::abs(value - w.constant()), w.rest(s) * (1 + 1e-12));
  }
}

/// T_k falls from 1 at the pole with the slope k^2, zeta^m along a meridian of the equator with the slope m.
TEST(TurnedPolynomial, MovesAsFastAsItsErrorSays) {
  for (const int n : {5, 20, 40}) {
    const double d = 1e-7;
    std::vector<double> of_z(EllipsoidCertificate::count(n), 0);
    std::vector<double> of_zeta = of_z;
    const std::vector<double> none = of_z;
    of_z[static_cast<std::size_t>(n)] = 1;
    of_zeta.back() = 1;
    const TurnedPolynomial one(n, of_z, none);
    const TurnedPolynomial other(n, of_zeta, none);
    EXPECT_LE(std::abs(one({0, 0, 1 - d}).lane(0) - 1), one.error(d));
    EXPECT_GT(std::abs(one({0, 0, 1 - d}).lane(0) - 1), 0.9 * one.error(d));
    EXPECT_LE(std::abs(other({1 - d, 0, 0}).lane(0) - 1), other.error(d));
    EXPECT_GT(std::abs(other({1 - d, 0, 0}).lane(0) - 1), 0.9 * other.error(d));
  }
}

/// Terms of one kind, whose bounds are nearly reached where they are largest.
TEST(TurnedPolynomial, IsBoundedByItsSizes) {
  Draw draw(2);
  for (int k = 0; k < 200; ++k) {
    EllipsoidCertificate c = test::drawn_ellipsoid(draw, 1 + static_cast<int>(draw.below(8)));
    const TurnedPolynomial q(c.degree, c.cosines, c.sines);
    const double s = 2 * draw.unit();
    const std::complex<double> value = test::q_at(c, test::drawn_turned(draw).at(s));
    EXPECT_LE(std::abs(value - c.cosines[0]), q.sizes().rest(s) * (1 + 1e-12));
    EXPECT_LE(std::abs(value), q.sizes().all(s) * (1 + 1e-12));
  }
  for (int m = 0; m <= 6; ++m)
    for (int k = 0; k <= 6; ++k) {
      if (m + k == 0) continue;
      EllipsoidCertificate c;
      c.degree = m + k;
      c.cosines.assign(EllipsoidCertificate::count(c.degree), 0);
      c.sines = c.cosines;
      std::size_t place = 0;
      for (int row = 0; row < m; ++row) place += static_cast<std::size_t>(c.degree - row + 1);
      c.cosines[place + static_cast<std::size_t>(k)] = 0.6;
      c.sines[place + static_cast<std::size_t>(k)] = m > 0 ? 0.8 : 0;
      const TurnedPolynomial q(c.degree, c.cosines, c.sines);
      const double s = 1.5;
      double most = 0;
      // Across each other in the plane of x and y, or with z.
      for (const TurnedPoint& p : {TurnedPoint{{1, 0, 0}, {0, 1, 0}}, TurnedPoint{{0, 0, 1}, {0.6, 0.8, 0}},
                                   TurnedPoint{{0.6, 0.8, 0}, {0, 0, 1}}})
        most = std::max(most, std::abs(test::q_at(c, p.at(s))));
      EXPECT_LE(most, q.sizes().rest(s));
      if (m == 0 || k == 0) {
        EXPECT_GT(most, 0.25 * q.sizes().rest(s)) << m << " " << k;
      }
    }
}

TEST(StretchedPolynomial, IsBoundedByItsSizes) {
  Draw draw(3);
  for (int k = 0; k < 200; ++k) {
    const EllipsoidCertificate c = test::drawn_ellipsoid(draw, 0);
    const StretchedPolynomial f(c.emission, c.half_axes);
    const double s = 2 * draw.unit();
    const std::complex<double> value =
        test::polynomial_at(c.emission, c.half_axes, test::drawn_turned(draw).at(s));
    EXPECT_LE(std::abs(value - f.sizes().constant), f.sizes().rest(s) * (1 + 1e-12));
  }
  const StretchedPolynomial one({{{0, 0, 3}, Rational(2)}}, {1, 1, 2});
  const std::complex<double> z = std::cosh(1.2);
  EXPECT_LE(16 * std::abs(z * z * z), one.sizes().rest(1.2));
}

/// Reached where the real part lies along the longest axis and the imaginary one along the shortest.
TEST(EllipsoidStretch, TurnsNoFurther) {
  Draw draw(4);
  const auto divided = [](const ComplexPoint& e, const Vector<double>& inverse) {
    return ComplexPoint{inverse.x * e[0], inverse.y * e[1], inverse.z * e[2]};
  };
  const auto turned = [](ComplexPoint d) {
    const std::complex<double> size = std::sqrt(test::dot_of(d, d));
    for (std::complex<double>& x : d) x /= size;
    return d;
  };
  for (int k = 0; k < 3000; ++k) {
    const EllipsoidStretch stretch(test::drawn_ellipsoid(draw, 0).half_axes);
    const double s = draw.unit() * stretch.widest();
    const double most = stretch.turned(s);
    if (!(most < 5)) continue;
    const ComplexPoint d = turned(divided(test::drawn_turned(draw).at(s), stretch.inverse()));
    EXPECT_LE(test::angle_of(d), most + 1e-7);
    const Vector<double> p = test::drawn_direction(draw);
    const ComplexPoint real{p.x, p.y, p.z};
    const std::complex<double> along = test::dot_of(real, d);
    const ComplexPoint q{p.x - 2.0 * along * d[0], p.y - 2.0 * along * d[1], p.z - 2.0 * along * d[2]};
    EXPECT_LE(test::angle_of(q), 2 * most + 1e-6);
  }
  const EllipsoidStretch stretch({1, Rational(3, 2), 2});
  for (const double s : {0.1, 0.3, 0.5}) {
    const ComplexPoint d = turned(divided(TurnedPoint{{0, 0, 1}, {1, 0, 0}}.at(s), stretch.inverse()));
    EXPECT_NEAR(test::angle_of(d), stretch.turned(s), 1e-8);
    const std::complex<double> along = 0.6 * d[0] + 0.8 * d[2];
    const ComplexPoint q{0.6 - 2.0 * along * d[0], -2.0 * along * d[1], 0.8 - 2.0 * along * d[2]};
    EXPECT_NEAR(test::angle_of(q), 2 * stretch.turned(s), 1e-7);
    // |A^-1 p|^2 there, and what the margin says of it.
    const ComplexPoint m = divided(TurnedPoint{{0, 0, 1}, {1, 0, 0}}.at(s), stretch.inverse());
    EXPECT_NEAR(std::abs(test::dot_of(m, m)), stretch.margin(s), 1e-9);
  }
}

double by_rule(const PolarRule& rule, const std::function<double(const Vector<double>&)>& f) {
  double sum = 0;
  for (std::size_t k = 0; k < rule.points.size(); ++k) sum += rule.weights[k] * f(rule.points[k]);
  return sum;
}

/// Re zeta^n and T_n(z), which the rules with too few nodes take for constants.
TEST(PolarRule, MissesNoMoreThanItSays) {
  for (int n = 1; n <= 24; ++n)
    for (const double tolerance : {2.0, 0.3, 1e-6}) {
      const auto bound = [n](double s) { return std::exp(n * s); };
      const PolarBounds bounds{.meridian_strip = 4,
                               .meridian = bound,
                               .row_strip = [](double) { return 4; },
                               .row = [&](double s, double) { return bound(s); }};
      const PolarRule rule = polar_rule(bounds, tolerance, false);
      ASSERT_GT(rule.nodes, 0U);
      EXPECT_LE(rule.error, tolerance);
      const double of_zeta = by_rule(
          rule, [n](const Vector<double>& p) { return std::pow(std::complex<double>(p.x, p.y), n).real(); });
      EXPECT_LE(std::abs(of_zeta), rule.error + 1e-12) << n;
      // The same for all longitudes, for which one node is enough.
      const PolarRule along = polar_rule({.meridian_strip = 4,
                                          .meridian = bound,
                                          .row_strip = [](double) { return 4; },
                                          .row = [](double, double) { return 0; }},
                                         tolerance, false);
      const double of_z =
          by_rule(along, [n](const Vector<double>& p) { return test::chebyshev(n, p.z).real(); });
      const double mean = n % 2 == 0 ? -1.0 / (n * n - 1) : 0.0;
      EXPECT_LE(std::abs(of_z - mean), along.error + 1e-12) << n;
    }
}

/// (1/2) log((a+1)/(a-1)) is the mean of 1/(a - z).
TEST(PolarRule, IntegratesWhatHasAPole) {
  for (const double a : {1.01, 1.2, 3.0}) {
    const auto bound = [a](double s) { return 1 / (a - std::cosh(s)); };
    for (const double tolerance : {1e-3, 1e-10}) {
      const PolarRule rule = polar_rule({.meridian_strip = std::acosh(a),
                                         .meridian = bound,
                                         .row_strip = [&](double) { return std::acosh(a); },
                                         .row = [&](double s, double) { return bound(s); }},
                                        tolerance, false);
      ASSERT_GT(rule.nodes, 0U);
      const double truth = 0.5 * std::log((a + 1) / (a - 1));
      const double of_z = by_rule(rule, [a](const Vector<double>& p) { return 1 / (a - p.z); });
      const double of_x = by_rule(rule, [a](const Vector<double>& p) { return 1 / (a - p.x); });
      EXPECT_NEAR(of_z, truth, rule.error + 1e-12);
      EXPECT_NEAR(of_x, truth, rule.error + 1e-12);
    }
  }
}

judge::Triple triple(const Vector<Rational>& v) {
  return {v.x.to_double(), v.y.to_double(), v.z.to_double()};
}

/// Against the kernel as it is in space, integrated by brute force.
TEST(RayTransport, IsTheIntegralOfTheKernel) {
  Draw draw(5);
  for (int k = 0; k < 12; ++k) {
    const EllipsoidCertificate c = test::drawn_ellipsoid(draw, static_cast<int>(draw.below(6)));
    const EllipsoidStretch stretch(c.half_axes);
    const SphereDensity w(c);
    const double tolerance = std::pow(10.0, -3.0 - 8 * draw.unit());
    const RayTransport transport(stretch, w, tolerance);
    const Vector<double> p = test::drawn_direction(draw);
    const judge::Triple a = triple(c.half_axes);
    const long double truth =
        judge::transported(a, judge::direction(p.x, p.y, p.z), [&](const judge::Triple& q) {
          const auto on_sphere = [&](std::size_t i) { return static_cast<double>(q[i] / a[i]); };
          return static_cast<long double>(test::w_at(c, {on_sphere(0), on_sphere(1), on_sphere(2)}).real());
        });
    const Approximation found = transport(p);
    EXPECT_NEAR(found.value, static_cast<double>(truth), found.radius + 1e-11);
    EXPECT_LE(found.radius, tolerance + 1e-11);
  }
}

/// Crude rules, whose bounds are not far from what they miss.
TEST(RayTransport, HoldsWhatCrudeRulesMiss) {
  Draw draw(6);
  for (int k = 0; k < 40; ++k) {
    const EllipsoidCertificate c = test::drawn_ellipsoid(draw, static_cast<int>(draw.below(12)));
    const EllipsoidStretch stretch(c.half_axes);
    const SphereDensity w(c);
    const RayTransport fine(stretch, w, 1e-10);
    const RayTransport crude(stretch, w, std::pow(10.0, 0.5 - 2 * draw.unit()));
    const Vector<double> p = test::drawn_direction(draw);
    const Approximation one = fine(p);
    const Approximation other = crude(p);
    EXPECT_LE(std::abs(one.value - other.value), one.radius + other.radius);
  }
}

/// T is the mean on the sphere, and 1 stays 1.
TEST(RayTransport, TakesMeansOnSpheres) {
  Draw draw(7);
  EllipsoidCertificate c = test::drawn_ellipsoid(draw, 7);
  c.half_axes = {3, 3, 3};
  c.reflectivity = {{{0, 0, 0}, Rational(1)}};
  c.emission = {{{0, 0, 2}, Rational(1)}, {{1, 0, 0}, Rational(5)}};
  const EllipsoidStretch stretch(c.half_axes);
  // Means of z^2 over the sphere of radius 3, and of T_k(z), zeta^m with m > 0 having none.
  double mean = 3 + c.cosines[0];
  for (int k = 2; k <= 7; k += 2) mean -= c.cosines[static_cast<std::size_t>(k)] / (k * k - 1);
  const SphereDensity w(c);
  const RayTransport transport(stretch, w, 1e-9);
  for (int k = 0; k < 20; ++k) {
    const Approximation found = transport(test::drawn_direction(draw));
    EXPECT_NEAR(found.value, mean, found.radius);
  }
}

/// By theorem E with everything complex.
TEST(TransportedAround, BoundsWhatIsContinued) {
  Draw draw(8);
  for (int k = 0; k < 25; ++k) {
    const EllipsoidCertificate c = test::drawn_ellipsoid(draw, static_cast<int>(draw.below(5)));
    const EllipsoidStretch stretch(c.half_axes);
    const SphereDensity w(c);
    const double s = 0.8 * draw.unit() * stretch.widest();
    const TurnedPoint turned = test::drawn_turned(draw);
    const Vector<double> axis = cross(turned.real, turned.imaginary);
    // A rotation by i s about the axis, of real points.
    const auto rotated = [&](const Vector<double>& v) {
      const double along = dot(v, turned.real);
      const double across = dot(v, turned.imaginary);
      const double left = dot(v, axis);
      const std::complex<double> i(0, 1);
      const std::complex<double> one = std::cosh(s) * along - i * std::sinh(s) * across;
      const std::complex<double> other = i * std::sinh(s) * along + std::cosh(s) * across;
      const auto part = [&](double x, double y, double z) { return one * x + other * y + left * z; };
      return ComplexPoint{part(turned.real.x, turned.imaginary.x, axis.x),
                          part(turned.real.y, turned.imaginary.y, axis.y),
                          part(turned.real.z, turned.imaginary.z, axis.z)};
    };
    const std::array<double, 3> a{c.half_axes.x.to_double(), c.half_axes.y.to_double(),
                                  c.half_axes.z.to_double()};
    const ComplexPoint p = rotated(turned.real);
    EXPECT_NEAR(test::angle_of(p), s, 1e-7);
    std::complex<double> sum = 0;
    judge::over_the_sphere({turned.real.x, turned.real.y, turned.real.z}, 8, 60,
                           [&](const judge::Triple& q, long double weight) {
                             const Vector<double> real{static_cast<double>(q[0]), static_cast<double>(q[1]),
                                                       static_cast<double>(q[2])};
                             const Vector<double> chord = turned.real - real;
                             const ComplexPoint d = rotated((1 / norm(chord)) * chord);
                             std::complex<double> squared = 0;
                             for (std::size_t j = 0; j < 3; ++j) squared += a[j] * a[j] * d[j] * d[j];
                             sum += static_cast<double>(weight) / (4 * std::numbers::pi) /
                                    (squared * squared) * (test::w_at(c, rotated(real)) - w.constant());
                           });
    std::complex<double> normal = 0;
    for (std::size_t j = 0; j < 3; ++j) normal += p[j] * p[j] / (a[j] * a[j]);
    const double size = a[0] * a[1] * a[2] * std::abs(sum / std::sqrt(normal));
    EXPECT_LE(size, transported_around(stretch, w, s));
    // Not by far, for ellipsoids that are nearly round.
    EXPECT_LT(transported_around(stretch, w, 0.1), 1e4 * (w.rest(0.1) + 1e-3));
  }
}

/// By hand: half axes 1/2, 1/2, 1, so that the kernel is at most 16 and the determinant is 1/4.
TEST(TransportedAround, IsTheBoundOfTheKernel) {
  Draw draw(11);
  EllipsoidCertificate c = test::drawn_ellipsoid(draw, 3);
  c.half_axes = {3, 3, 6};
  const EllipsoidStretch stretch(c.half_axes);
  const SphereDensity w(c);
  for (const double s : {0.0, 0.2, 0.5}) {
    const double margin = 1 - 3 * std::sinh(s) * std::sinh(s);
    const double expected = 4 * w.rest(s) / std::pow(margin, 2.5);
    EXPECT_NEAR(transported_around(stretch, w, s), expected, 0.01 * expected);
  }
  EXPECT_FALSE(std::isfinite(transported_around(stretch, w, 0.55)));
}

TEST(MeanOverSurface, IsTheMean) {
  Draw draw(9);
  for (int k = 0; k < 8; ++k) {
    const EllipsoidCertificate c = test::drawn_ellipsoid(draw, static_cast<int>(draw.below(6)));
    const EllipsoidStretch stretch(c.half_axes);
    const SphereDensity w(c);
    const judge::Triple a = triple(c.half_axes);
    const long double truth = judge::mean_over(a, [&](const judge::Triple& q) {
      const auto on_sphere = [&](std::size_t i) { return static_cast<double>(q[i] / a[i]); };
      return static_cast<long double>(test::w_at(c, {on_sphere(0), on_sphere(1), on_sphere(2)}).real());
    });
    for (const double tolerance : {1e-2, 1e-9}) {
      const Approximation found = mean_over_surface(stretch, w, tolerance);
      EXPECT_NEAR(found.value, static_cast<double>(truth), found.radius + 1e-12);
      EXPECT_LT(found.radius, 8 * tolerance);
    }
  }
}

}  // namespace
}  // namespace radcert::certificate
