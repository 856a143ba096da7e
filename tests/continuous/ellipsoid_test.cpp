// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/ellipsoid/ellipsoid_enclosure.h"
#include "radcert/enclosure/gauss_legendre.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "radcert/core/parallel.h"
#include "radcert/core/work_limit.h"
#include "radcert/enclosure/gauss_legendre.h"
#include "radcert/expression/parse.h"
#include "tests/continuous/ellipsoid_judge.h"
#include "tests/continuous/scenes.h"

namespace radcert {
namespace {

using test::Draw;
using Long = long double;
using Complex = std::complex<Long>;
using ComplexTriple = std::array<Complex, 3>;
using Matrix = std::array<ComplexTriple, 3>;
using judge::Triple;

Expression formula(const std::string& text) { return parse_expression(text).value(); }

EllipsoidEnclosure enclosed(const Vector<Rational>& axes, const std::string& rho, const std::string& e,
                            double wanted) {
  return enclose_on_ellipsoid({.half_axes = axes, .reflectivity = formula(rho), .emission = formula(e)},
                              wanted)
      .value();
}

const Vector<Rational>& unequal() {
  static const Vector<Rational> axes{1, Rational(13, 10), Rational(17, 10)};
  return axes;
}

SpherePolynomial along(const std::string& text, const Vector<Rational>& axes) {
  return SpherePolynomial::along(formula(text), axes).value();
}

double value_of(const EllipsoidDensity& w, const Vector<double>& p) {
  const Vector<Pack> at{p.x, p.y, p.z};
  return w({at, at})[1].lane(5);
}
double value_of(const SpherePolynomial& f, const Vector<double>& p) {
  const Vector<Pack> at{p.x, p.y, p.z};
  return f({at, at})[0].lane(3);
}

Vector<double> drawn_direction(Draw& draw) {
  const double z = 2 * draw() - 1;
  const double angle = 2 * std::numbers::pi * draw();
  const double sine = std::sqrt(1 - z * z);
  return {sine * std::cos(angle), sine * std::sin(angle), z};
}

/// Harmonics that fall off by a factor a degree.
std::vector<double> drawn_harmonics(int degree, double factor, Draw& draw) {
  std::vector<double> out;
  for (int l = 0; l <= degree; ++l)
    for (int m = -l; m <= l; ++m) out.push_back((draw() - 0.4) * std::pow(factor, l));
  return out;
}

Triple long_axes(const Vector<Rational>& axes) {
  return {from_rational<Long>(axes.x), from_rational<Long>(axes.y), from_rational<Long>(axes.z)};
}
Triple long_direction(const Vector<double>& p) { return judge::direction(p.x, p.y, p.z); }

/// The rotation by a complex angle about a unit vector.
Matrix rotation(const Triple& n, Complex angle) {
  const Complex c = std::cos(angle);
  const Complex s = std::sin(angle);
  Matrix out;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) out[i][j] = (1.0L - c) * n[i] * n[j] + (i == j ? c : Complex(0));
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    out[j][i] += s * n[k];
    out[i][j] -= s * n[k];
  }
  return out;
}
ComplexTriple rotated(const Matrix& r, const Triple& v) {
  ComplexTriple out;
  for (std::size_t i = 0; i < 3; ++i) out[i] = r[i][0] * v[0] + r[i][1] * v[1] + r[i][2] * v[2];
  return out;
}

TEST(SpherePolynomial, IsTheExpressionOnTheEllipsoid) {
  Draw draw(3);
  const std::string text = "3 - x^3*y^2*z/7 + (x - 2*y)^4/5 - y*(z + x/3)^5*0.3 + z^2";
  const Expression expression = formula(text);
  const SpherePolynomial f = along(text, unequal());
  EXPECT_EQ(f.degree(), 6);
  double worst = 0;
  for (int k = 0; k < 300; ++k) {
    const Vector<double> p = drawn_direction(draw);
    const Triple a = long_axes(unequal());
    const Triple q = long_direction(p);
    const Long exact = expression.evaluate<Long>({a[0] * q[0], a[1] * q[1], a[2] * q[2]});
    worst = std::max(worst, static_cast<double>(std::abs(exact - value_of(f, p))));
  }
  EXPECT_LE(worst, f.rounding());
  EXPECT_LT(f.rounding(), 1e-10);
}

TEST(SpherePolynomial, HasTheHarmonicsThatAreGiven) {
  // sqrt(2l+1) P_l(z) for m = 0, the sectoral harmonics in closed form, and the addition theorem for all.
  Draw draw(4);
  const int degree = 20;
  for (int k = 0; k < 20; ++k) {
    const Vector<double> p = drawn_direction(draw);
    std::vector<double> squares(degree + 1, 0.0);
    for (int l = 0; l <= degree; ++l)
      for (int m = -l; m <= l; ++m) {
        std::vector<double> harmonics(static_cast<std::size_t>((degree + 1) * (degree + 1)), 0.0);
        harmonics[static_cast<std::size_t>(l * l + l + m)] = 1;
        if (k > 1 && (l % 7 != 0)) continue;
        const double value = value_of(SpherePolynomial(degree, harmonics), p);
        squares[static_cast<std::size_t>(l)] += value * value;
        if (m == 0) {
          EXPECT_NEAR(value, std::sqrt(2 * l + 1.0) * std::legendre(static_cast<unsigned>(l), p.z), 1e-9);
        }
        if (m == l && l > 0) {
          Long norm = 2;
          for (int j = 1; j <= l; ++j) norm *= (2.0L * j + 1) / (2.0L * j);
          const std::complex<double> zeta(p.x, p.y);
          EXPECT_NEAR(value, std::sqrt(static_cast<double>(norm)) * std::pow(zeta, l).real(), 1e-9);
        }
      }
    for (int l = 0; l <= degree; ++l)
      if (k <= 1 || l % 7 == 0) {
        EXPECT_NEAR(squares[static_cast<std::size_t>(l)], 2 * l + 1, 1e-8);
      }
  }
}

TEST(SpherePolynomial, IsBoundedAroundTheSphere) {
  // z^2 and x y have closed forms at complex points; a bound is no more than the degree asks for.
  Draw draw(5);
  const SpherePolynomial f = along("x*y + z^3 - z/2", {1, 1, 1});
  for (int k = 0; k < 400; ++k) {
    const double tau = 2 * draw();
    const Matrix r = rotation(long_direction(drawn_direction(draw)), Complex(0, tau));
    const ComplexTriple q = rotated(r, long_direction(drawn_direction(draw)));
    const Complex value = q[0] * q[1] + q[2] * q[2] * q[2] - 0.5L * q[2] - Complex(f.constant());
    EXPECT_LE(std::abs(value), f.variation(tau));
  }
  EXPECT_LE(f.variation(1), 3 * std::exp(3.0));
  // The zonal harmonics are as large as their bound at the pole.
  for (int l = 1; l < 12; ++l) {
    std::vector<double> harmonics(144, 0.0);
    harmonics[static_cast<std::size_t>(l * l + l)] = 1;
    const SpherePolynomial zonal(11, harmonics);
    EXPECT_NEAR(value_of(zonal, {0, 0, 1}), zonal.variation(0), 1e-9);
  }
}

TEST(SpherePolynomial, RoundingCoversDisplacedPoints) {
  // T_n(z) at a pole and Re zeta^n on the equator are 1, and change the fastest there: T_2n = 2 T_n^2 - 1,
  // Re zeta^(2n) = 2 (Re zeta^n)^2 - (x^2 + y^2)^n.
  const double displacement = 46 * unit_roundoff<double>();
  std::string chebyshev = "z";
  std::string real = "x";
  double closest_at_pole = 0;
  double closest_on_equator = 0;
  for (int n = 1; n <= 32; n *= 2) {
    const SpherePolynomial zonal = along(chebyshev, {1, 1, 1});
    const SpherePolynomial sectoral = along(real, {1, 1, 1});
    ASSERT_EQ(zonal.degree(), n);
    ASSERT_EQ(sectoral.degree(), n);
    const double at_pole = std::abs(value_of(zonal, {0, 0, 1 - displacement}) - 1);
    EXPECT_LE(at_pole, zonal.rounding()) << n;
    closest_at_pole = std::max(closest_at_pole, at_pole / zonal.rounding());
    for (const double x : {1 - displacement, 1 + displacement}) {
      const double on_equator = std::abs(value_of(sectoral, {x, 0, 0}) - 1);
      EXPECT_LE(on_equator, sectoral.rounding()) << n;
      closest_on_equator = std::max(closest_on_equator, on_equator / sectoral.rounding());
    }
    chebyshev = "(2*" + chebyshev + "^2 - 1)";
    real = "(2*" + real + "^2 - (x^2 + y^2)^" + std::to_string(n) + ")";
  }
  EXPECT_GT(closest_at_pole, 0.8);
  EXPECT_GT(closest_on_equator, 0.8);
}

TEST(SpherePolynomial, HasBoundsThatScaleWithTheHarmonics) {
  // Squares of these coefficients are below the range of double.
  Draw draw(17);
  const std::vector<double> harmonics = drawn_harmonics(7, 0.8, draw);
  const SpherePolynomial f(7, harmonics);
  for (const double scale : {1e-100, 1e-165, 1e-200}) {
    std::vector<double> scaled = harmonics;
    for (double& c : scaled) c *= scale;
    const SpherePolynomial g(7, scaled);
    EXPECT_NEAR(g.variation(0) / scale, f.variation(0), 1e-9 * f.variation(0)) << scale;
    EXPECT_NEAR(g.variation(1) / scale, f.variation(1), 1e-9 * f.variation(1)) << scale;
    EXPECT_NEAR(g.largest() / scale, f.largest(), 1e-9 * f.largest()) << scale;
    EXPECT_NEAR(g.rounding() / scale, f.rounding(), 1e-3 * f.rounding()) << scale;
  }
}

TEST(SpherePolynomial, RefusesWhatIsNoPolynomial) {
  for (const std::string text :
       {"sqrt(x)", "1/x", "x^y", "x^(1/2)", "exp(z)", "x^40*y^40", "abs(x)", "x/0", "1e390*x"})
    EXPECT_FALSE(SpherePolynomial::along(formula(text), unequal()).has_value()) << text;
  EXPECT_TRUE(SpherePolynomial::along(formula("-(x/2)^3"), unequal()).has_value());
}

TEST(EllipsoidShape, BoundsTheDenominatorAtComplexPoints) {
  Draw draw(6);
  for (const Vector<Rational>& axes : {unequal(), Vector<Rational>{3, 1, Rational(5, 2)}}) {
    const EllipsoidShape shape(axes);
    const Triple a = long_axes(axes);
    const Long largest = std::max({a[0], a[1], a[2]});
    Long nearest = 10;
    for (int k = 0; k < 4000; ++k) {
      const double tau = draw() * shape.widest();
      const Triple n = long_direction(k % 4 == 0 ? Vector<double>{0, 1, 0} : drawn_direction(draw));
      const Triple d = long_direction(k % 4 == 0 ? Vector<double>{0, 0, 1} : drawn_direction(draw));
      const Long along_n = n[0] * d[0] + n[1] * d[1] + n[2] * d[2];
      const ComplexTriple turned = rotated(rotation(n, Complex(0, tau)), d);
      Complex squared = 0;
      Complex stretch = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        squared += turned[i] * turned[i] * (a[i] / largest) * (a[i] / largest);
        stretch += turned[i] * turned[i] / ((a[i] / largest) * (a[i] / largest));
      }
      const double across = static_cast<double>(1 - along_n * along_n);
      EXPECT_GE(squared.real(), shape.margin(tau, across));
      EXPECT_GE(stretch.real(), shape.margin(tau) / (shape.smallest() * shape.smallest()) * (1 - 1e-12));
      nearest = std::min(nearest, squared.real() - shape.margin(tau, across));
    }
    EXPECT_LT(nearest, 1e-2);
    EXPECT_GT(shape.margin(0.999 * shape.widest()), 0);
    EXPECT_LT(shape.margin(0.999 * shape.widest()), 0.01);
    EXPECT_EQ(shape.margin(1.001 * shape.widest()), 0);
  }
}

TEST(SphereRule, BoundsWhatItMisses) {
  // 1/(3/2 - cos(phi)) has the mean 1/sqrt(5/4), 1/(3/2 - cos(psi)) the mean log(5)/2; their poles are where
  // cosh(tau) = 3/2.
  const double strip = std::acosh(1.5);
  const auto with_pole = [](double tau) { return 1 / (1.5 - std::cosh(tau)); };
  const auto everywhere = [](double, double) { return 6.0; };
  for (const double tolerance : {1.0, 1e-1, 1e-2, 1e-4, 1e-6, 1e-9, 1e-12}) {
    const SphereRule around = sphere_rule({.meridian_strip = 6,
                                           .meridian = [](double) { return 0; },
                                           .row_strip = [&](double, double) { return strip; },
                                           .row = [&](double tau, double, double) { return with_pole(tau); }},
                                          tolerance);
    const SphereRule across = sphere_rule({.meridian_strip = strip,
                                           .meridian = with_pole,
                                           .row_strip = everywhere,
                                           .row = [](double, double, double) { return 0; }},
                                          tolerance);
    double of_phi = 0;
    double of_psi = 0;
    for (std::size_t k = 0; k < around.weights.size(); ++k)
      of_phi += around.weights[k] / (1.5 - around.cos_phi[k]);
    for (std::size_t k = 0; k < across.weights.size(); ++k)
      of_psi += across.weights[k] / (1.5 - across.cos_psi[k]);
    EXPECT_NEAR(of_phi, 1 / std::sqrt(1.25), around.error + 1e-14);
    EXPECT_NEAR(of_psi, 0.5 * std::log(5.0), across.error + 1e-14);
    for (const SphereRule& rule : {around, across}) {
      EXPECT_GT(rule.error, 0);
      EXPECT_LE(rule.error, tolerance);
      EXPECT_LT(rule.nodes, 1500U);
      for (std::size_t k = 0; k < rule.nodes; ++k) {
        EXPECT_NEAR(std::hypot(rule.cos_psi[k], rule.sin_psi[k]), 1, 1e-15);
        EXPECT_NEAR(2 * rule.sin_half[k] * rule.cos_half[k], rule.sin_psi[k], 1e-15);
      }
    }
  }
}

TEST(SphereRule, BoundsWhatRowsMissNarrowly) {
  // cos(m phi) is as large as cosh(m tau); its mean is 0, and 1 by m nodes.
  double closest = 0;
  for (int m = 2; m <= 24; ++m)
    for (double tolerance = 0.2; tolerance <= 20; tolerance *= 1.04) {
      const SphereRule rule =
          sphere_rule({.meridian_strip = 6,
                       .meridian = [](double) { return 0; },
                       .row_strip = [](double, double) { return 6.0; },
                       .row = [&](double tau, double, double) { return std::cosh(m * tau); }},
                      tolerance);
      ASSERT_TRUE(rule.exists());
      double sum = 0;
      for (std::size_t k = 0; k < rule.weights.size(); ++k)
        sum += rule.weights[k] * std::pow(std::complex(rule.cos_phi[k], rule.sin_phi[k]), m).real();
      EXPECT_LE(std::abs(sum), rule.error + 1e-14) << m << " " << tolerance;
      closest = std::max(closest, std::abs(sum) / rule.error);
    }
  EXPECT_GT(closest, 0.9);
}

TEST(SphereRule, BoundsWhatMeridiansMissNarrowly) {
  // T_2m(cos(psi)) = cos(2m psi) is as large as cosh(2m tau), and has the mean -1/(4m^2 - 1).
  double closest = 0;
  for (int m = 2; m <= 24; ++m)
    for (double tolerance = 0.02; tolerance <= 20; tolerance *= 1.1) {
      const SphereRule rule = sphere_rule({.meridian_strip = 6,
                                           .meridian = [&](double tau) { return std::cosh(2 * m * tau); },
                                           .row_strip = [](double, double) { return 6.0; },
                                           .row = [](double, double, double) { return 0; }},
                                          tolerance);
      ASSERT_TRUE(rule.exists());
      double sum = 0;
      for (std::size_t k = 0; k < rule.weights.size(); ++k)
        sum += rule.weights[k] * std::pow(std::complex(rule.cos_psi[k], rule.sin_psi[k]), 2 * m).real();
      const double off = std::abs(sum + 1 / (4.0 * m * m - 1));
      EXPECT_LE(off, rule.error + 1e-14) << m << " " << tolerance;
      closest = std::max(closest, off / rule.error);
    }
  EXPECT_GT(closest, 0.2);
}

TEST(EllipsoidTransport, IsTheIntegralOfTheKernel) {
  Draw draw(7);
  struct Instance {
    Vector<Rational> axes;
    std::string w;
  };
  for (const Instance& instance :
       {Instance{unequal(), "1 + x - y*z + z^3/3"}, Instance{{2, Rational(4, 5), 1}, "x^2 - 2*z + x*y*z"},
        Instance{{1, 1, Rational(2, 5)}, "x^2 + z"}, Instance{{1, 1, 1}, "40*x^5*y - 30*x*y*z^4"},
        Instance{{1, Rational(1001, 1000), Rational(999, 1000)}, "y^3 - x"}}) {
    const EllipsoidShape shape(instance.axes);
    const EllipsoidDensity w{
        .emission = along(instance.w, instance.axes), .reflectivity = {}, .reflected = {}};
    const Expression expression = formula(instance.w);
    const auto in_space = [&](const Triple& q) { return expression.evaluate<Long>({q[0], q[1], q[2]}); };
    const EllipsoidTransport fine(shape, w, 1e-13);
    for (int k = 0; k < 3; ++k) {
      const Vector<double> p = k == 0 ? Vector<double>{0, 0, 1} : drawn_direction(draw);
      const Long exact = judge::transported(long_axes(instance.axes), long_direction(p), in_space, 24, 300);
      const Approximation value = fine(p);
      EXPECT_NEAR(value.value, static_cast<double>(exact), value.radius + 1e-13) << instance.w;
      EXPECT_LT(value.radius, 3e-12);
      // Where the rule is all but exact, a density that is off by its rounding everywhere is off by as much.
      const Approximation rounded = EllipsoidTransport(shape, w, 1e-17)(p);
      EXPECT_NEAR(rounded.value, static_cast<double>(exact), rounded.radius) << instance.w;
      EXPECT_GE(rounded.radius, w.rounding()) << instance.w;
      double before = value.radius;
      for (const double tolerance : {1e-9, 1e-5, 1e-1}) {
        const Approximation coarse = EllipsoidTransport(shape, w, tolerance)(p);
        EXPECT_LE(std::abs(coarse.value - value.value), coarse.radius + value.radius);
        EXPECT_GE(coarse.radius, before);
        EXPECT_LE(coarse.radius, 2 * tolerance);
        before = coarse.radius;
      }
    }
  }
}

TEST(EllipsoidTransport, BoundsWhatCoarseRulesMiss) {
  // Rough densities and coarse rules: the error is looked at where it is not far below its bound.
  Draw draw(8);
  double closest = 0;
  for (int k = 0; k < 60; ++k) {
    const Vector<Rational> axes{1, Rational(1 + static_cast<long>(draw.below(30)), 10), Rational(7, 5)};
    const EllipsoidShape shape(axes);
    const int degree = 2 + static_cast<int>(draw.below(12));
    const EllipsoidDensity w{.emission = SpherePolynomial(degree, drawn_harmonics(degree, 0.9, draw)),
                             .reflectivity = along("1/4 + x/8", axes),
                             .reflected = SpherePolynomial(degree, drawn_harmonics(degree, 0.7, draw))};
    const Vector<double> p = drawn_direction(draw);
    const Approximation exact = EllipsoidTransport(shape, w, 1e-12)(p);
    for (const double tolerance : {1.0, 1e-1, 1e-2, 1e-4, 1e-6, 1e-8}) {
      const Approximation value = EllipsoidTransport(shape, w, tolerance)(p);
      ASSERT_LE(std::abs(value.value - exact.value), value.radius + exact.radius) << degree;
      closest = std::max(closest, std::abs(value.value - exact.value) / value.radius);
    }
  }
  EXPECT_GT(closest, 1e-3);
}

TEST(EllipsoidTransport, IsBoundedAtComplexPoints) {
  // The integral at R p for complex rotations R: det A mean_q kernel(R p, R q) w(R q) / |A^-1 R p|.
  Draw draw(10);
  const Vector<Rational> axes = unequal();
  const EllipsoidShape shape(axes);
  const Triple a = long_axes(axes);
  const EllipsoidDensity w{.emission = along("x - y*z + z", axes), .reflectivity = {}, .reflected = {}};
  double closest = 0;
  for (int k = 0; k < 14; ++k) {
    // At last the longest axis is turned towards the shortest, where |A^-1 R p| comes to 0.
    const bool is_worst = k >= 12;
    const double tau = (is_worst ? 0.999 : 0.2 + 0.75 * draw()) * shape.widest();
    const Matrix r =
        rotation(long_direction(is_worst ? Vector<double>{0, 1, 0} : drawn_direction(draw)), Complex(0, tau));
    const Triple p = long_direction(is_worst ? Vector<double>{0, 0, 1} : drawn_direction(draw));
    Complex sum = 0;
    judge::over_the_sphere(p, 20, 200, [&](const Triple& q, Long weight) {
      const ComplexTriple at = rotated(r, q);
      const ComplexTriple chord = rotated(r, {p[0] - q[0], p[1] - q[1], p[2] - q[2]});
      Complex square = 0;
      Complex seen = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        square += chord[i] * chord[i];
        seen += a[i] * a[i] * chord[i] * chord[i];
      }
      sum += weight / (4 * judge::pi_long) * (square * square) / (seen * seen) *
             (a[0] * at[0] - a[1] * a[2] * at[1] * at[2] + a[2] * at[2]);
    });
    const ComplexTriple moved = rotated(r, p);
    Complex stretch = 0;
    for (std::size_t i = 0; i < 3; ++i) stretch += moved[i] * moved[i] / (a[i] * a[i]);
    const auto size = static_cast<double>(std::abs(sum * a[0] * a[1] * a[2] / std::sqrt(stretch)));
    EXPECT_LE(size, bound_around(shape, w, tau));
    closest = std::max(closest, size / w.variation(tau));
  }
  EXPECT_GT(closest, 1);
  EXPECT_EQ(bound_around(shape, w, 1.001 * shape.widest()), std::numeric_limits<double>::infinity());
}

TEST(BoundAround, IsPutTogetherAsItIsStated) {
  Draw draw(18);
  for (int k = 0; k < 40; ++k) {
    const Vector<Rational> axes{1, Rational(1 + static_cast<long>(draw.below(30)), 10), Rational(7, 5)};
    const EllipsoidShape shape(axes);
    const EllipsoidDensity w{.emission = along("x - y*z + z", axes), .reflectivity = {}, .reflected = {}};
    const double tau = 0.95 * draw() * shape.widest();
    const Triple a = long_axes(axes);
    const double largest = static_cast<double>(std::max({a[0], a[1], a[2]}));
    const double smallest = static_cast<double>(std::min({a[0], a[1], a[2]})) / largest;
    const double determinant = static_cast<double>(a[0] * a[1] * a[2]) / (largest * largest * largest);
    const double stated = determinant * smallest * w.variation(tau) / std::pow(shape.margin(tau), 2.5);
    EXPECT_GE(bound_around(shape, w, tau), stated);
    EXPECT_LE(bound_around(shape, w, tau), 1.01 * stated);
  }
}

TEST(HarmonicTail, BoundsWhatIsBeyondADegree) {
  // At the pole z = 1 the part of degree l is (2l+1) mean_q P_l(z_q) T w(q).
  const Vector<Rational> axes{1, 1, Rational(13, 10)};
  const EllipsoidShape shape(axes);
  const EllipsoidDensity w{.emission = along("z^2", axes), .reflectivity = {}, .reflected = {}};
  const EllipsoidTransport transport(shape, w, 1e-14);
  constexpr int most = 30;
  std::array<double, most + 1> parts{};
  static const judge::TenPoints rule;
  for (int panel = 0; panel < 8; ++panel)
    for (std::size_t i = 0; i < 10; ++i) {
      const auto z = static_cast<double>(-1 + (panel + 0.5L * (1 + rule.nodes[i])) / 4);
      const double value = transport({std::sqrt(1 - z * z), 0, z}).value;
      for (int l = 0; l <= most; ++l)
        parts[static_cast<std::size_t>(l)] += (2 * l + 1) * 0.5 * static_cast<double>(rule.weights[i] / 8) *
                                              std::legendre(static_cast<unsigned>(l), z) * value;
    }
  double before = 1e300;
  for (int degree = 2; degree < 14; ++degree) {
    double beyond = 0;
    for (int l = degree + 1; l <= most; ++l) beyond += parts[static_cast<std::size_t>(l)];
    const double bound = harmonic_tail(shape, w, degree);
    EXPECT_LE(std::abs(beyond), bound + 1e-12) << degree;
    EXPECT_LT(bound, before);
    before = bound;
  }
  const EllipsoidDensity none{.emission = along("3", axes), .reflectivity = {}, .reflected = {}};
  EXPECT_LT(harmonic_tail(shape, none, 4), 1e-13);
}

TEST(HarmonicTail, IsNotFarAboveWhatIsBeyondADegree) {
  // T z on a spheroid, without its mean: at the pole it is all that is beyond the degree 0.
  const Vector<Rational> axes{1, 1, Rational(13, 10)};
  const EllipsoidShape shape(axes);
  const EllipsoidDensity w{.emission = along("z", axes), .reflectivity = {}, .reflected = {}};
  const Approximation beyond = EllipsoidTransport(shape, w, 1e-12)({0, 0, 1});
  EXPECT_LE(std::abs(beyond.value), harmonic_tail(shape, w, 0) + beyond.radius);
  EXPECT_GT(std::abs(beyond.value), 1e-3 * harmonic_tail(shape, w, 0));
}

TEST(HarmonicTail, IsTheSumOfTheBoundsOfAllParts) {
  // |a_l| <= (2l+1)^(1/2) 2 B e^(1-l) / (e-1), e = exp(tau), summed term by term for the best tau.
  for (const Vector<Rational>& axes : {unequal(), Vector<Rational>{1, 1, Rational(11, 10)}}) {
    const EllipsoidShape shape(axes);
    const EllipsoidDensity w{.emission = along("x - y*z + z^3", axes), .reflectivity = {}, .reflected = {}};
    for (const int degree : {0, 2, 5, 11, 30}) {
      double least = std::numeric_limits<double>::infinity();
      for (int k = 1; k < 400; ++k) {
        const double tau = shape.widest() * k / 400;
        double sum = 0;
        for (int l = degree + 1; l < degree + 300; ++l)
          sum += std::sqrt(2 * l + 1) * 2 * std::exp((1 - l) * tau) / std::expm1(tau);
        least = std::min(least, sum * bound_around(shape, w, tau));
      }
      EXPECT_GE(harmonic_tail(shape, w, degree), 0.999 * least) << degree;
      EXPECT_LE(harmonic_tail(shape, w, degree), 2 * least) << degree;
    }
  }
}

TEST(SphereCover, ReachesEveryPoint) {
  Draw draw(11);
  for (const double distance : {1.0, 0.6, 0.13, 0.05}) {
    const std::vector<Vector<double>> points = sphere_cover(distance);
    double worst = 0;
    for (int k = 0; k < 1000; ++k) {
      Vector<double> p = drawn_direction(draw);
      if (k % 3 == 0) p = {1e-3 * draw(), 1e-3 * draw(), k % 2 == 0 ? 1.0 : -1.0};
      double largest = -1;
      for (const Vector<double>& q : points) largest = std::max(largest, dot(p, q) / norm(p));
      worst = std::max(worst, std::acos(std::min(1.0, largest)));
    }
    EXPECT_LE(worst, distance);
    EXPECT_GT(worst, 0.8 * distance);
    EXPECT_LT(static_cast<double>(points.size()), 12 / (distance * distance) + 12);
  }
}

TEST(BoundBetween, HoldsForPolynomialsBetweenThePoints) {
  // Re zeta^n has the largest modulus 1, and so has it in turned coordinates.
  Draw draw(16);
  for (const double angle : {1.4, 1.2, 0.5}) {
    const int degree = 2 + static_cast<int>(draw.below(12));
    const std::vector<Vector<double>> points = sphere_cover(std::min(1.0, angle / degree));
    double worst = 1;
    for (int k = 0; k < 50; ++k) {
      const Vector<double> axis = drawn_direction(draw);
      const Matrix r = rotation(long_direction(axis), Complex(3 * draw()));
      double largest = 0;
      for (const Vector<double>& p : points) {
        const ComplexTriple q = rotated(r, long_direction(p));
        const std::complex<double> zeta(static_cast<double>(q[0].real()), static_cast<double>(q[1].real()));
        largest = std::max(largest, std::abs(std::pow(zeta, degree).real()));
      }
      const double bound = bound_between(largest, degree, std::min(1.0, angle / degree));
      EXPECT_GE(bound, 1);
      EXPECT_LE(bound, 1.01 / std::cos(angle));
      worst = std::min(worst, largest);
    }
    EXPECT_LT(worst, 0.999);
  }
}

TEST(BoundBetween, IsAttainedOnAGreatCircle) {
  // cos(n phi) on the equator, seen at the distance d from where it is 1.
  for (const int degree : {1, 2, 7, 30})
    for (const double part : {0.01, 0.3, 0.9, 1.4}) {
      const double distance = part / degree;
      const double bound = bound_between(std::cos(degree * distance), degree, distance);
      EXPECT_GE(bound, 1 - 1e-15) << degree << " " << part;
      EXPECT_LE(bound, 1 + 1e-9) << degree << " " << part;
    }
}

TEST(EllipsoidTransport, CountsWhatDirectionsAreOffBy) {
  // |A d|^-4 changes by 4/a of itself where d is moved across the shortest half axis a, and its mean is that
  // of T 1 = 1: directions that are off by the displacement move T w by 4/a of it times max |w - c|.
  for (const Rational& a : {Rational(1), Rational(1, 2), Rational(1, 4)}) {
    const Vector<Rational> axes{1, 1, a};
    const EllipsoidShape shape(axes);
    const EllipsoidDensity w{.emission = along("x", axes), .reflectivity = {}, .reflected = {}};
    const EllipsoidTransport transport(shape, w, 1e-15);
    ASSERT_TRUE(transport.exists());
    const double moved = 4 * sphere_displacement / a.to_double() * w.variation(0);
    for (const Vector<double>& p : {Vector<double>{1, 0, 0}, {0, 0, 1}, {0.6, 0, 0.8}}) {
      const double radius = transport(p).radius;
      EXPECT_GE(radius, moved) << a.to_double();
      EXPECT_LE(radius, 2 * moved) << a.to_double();
    }
  }
}

TEST(SphereRule, MissesNoLessThanGaussRuleMayMiss) {
  // Of functions that are bounded by 1 on meridians, and constant on rows.
  for (const double strip : {0.5, 1.0, 3.0})
    for (const double tolerance : {1e-1, 1e-2, 1e-3}) {
      const SphereRule rule = sphere_rule({.meridian_strip = strip,
                                           .meridian = [](double) { return 1.0; },
                                           .row_strip = [](double, double) { return 1.0; },
                                           .row = [](double, double, double) { return 0.0; }},
                                          tolerance);
      ASSERT_TRUE(rule.exists());
      std::vector<double> heights = rule.cos_psi;
      std::sort(heights.begin(), heights.end());
      const auto nodes = static_cast<int>(std::unique(heights.begin(), heights.end()) - heights.begin());
      // The mean is half the integral. The widest ellipse of all is not taken.
      EXPECT_GE(rule.error, 0.5 * gauss_error_factor(nodes, std::exp(strip)).lower_double())
          << strip << " " << nodes;
      EXPECT_LE(rule.error, 0.5 * tolerance * (1 + 1e-9));
    }
}

TEST(SurfaceMean, IsTheMeanOverTheSurface) {
  const std::string text = "2 + x^2 - y^4 + z";
  const Expression expression = formula(text);
  for (const Vector<Rational>& axes : {unequal(), Vector<Rational>{1, 2, 1}, Vector<Rational>{1, 1, 1}}) {
    const EllipsoidDensity w{.emission = along(text, axes), .reflectivity = {}, .reflected = {}};
    const auto exact = static_cast<double>(judge::mean_over(long_axes(axes), [&](const Triple& q) {
      return expression.evaluate<Long>({q[0], q[1], q[2]});
    }));
    for (const double tolerance : {1e-12, 1e-8, 1e-3}) {
      const Approximation mean = surface_mean(EllipsoidShape(axes), w, tolerance);
      EXPECT_TRUE(mean.guaranteed);
      EXPECT_NEAR(mean.value, exact, mean.radius);
      EXPECT_LT(mean.radius, 10 * tolerance + 1e-12);
    }
  }
}

TEST(SurfaceMean, CountsWhatTheAreaIsOffBy) {
  // The harmonics of degree 2 that are even and odd in y have the same bounds around the sphere, hence the
  // same rule, which misses e of the integral of either and e/V of the area, V the bound on the sphere. The
  // odd one has the mean 0, and the other part = mean - c: an area that is off by e/V moves it by part e/V.
  const EllipsoidShape shape({1, 1, 4});
  const auto mean_of = [&](std::size_t place, double tolerance) {
    std::vector<double> harmonics(9, 0.0);
    harmonics[place] = 1;
    const EllipsoidDensity w{.emission = SpherePolynomial(2, harmonics), .reflectivity = {}, .reflected = {}};
    EXPECT_NEAR(w.variation(0), std::sqrt(5.0), 1e-11);
    EXPECT_EQ(w.constant(), 0);
    return surface_mean(shape, w, tolerance);
  };
  for (const double tolerance : {1e-2, 1e-3, 1e-5}) {
    const Approximation even = mean_of(6, tolerance);
    const Approximation odd = mean_of(4, tolerance);
    EXPECT_GT(std::abs(even.value), 0.2);
    EXPECT_LT(std::abs(odd.value), 1e-14);
    EXPECT_GE(even.radius, odd.radius * (1 + 0.999 * std::abs(even.value) / std::sqrt(5.0))) << tolerance;
  }
}

TEST(SurfaceMean, CountsItsRoundings) {
  // Harmonics have the mean 0 on a sphere. A rule that misses nothing worth naming leaves their roundings, of
  // which the mean itself is too small to tell.
  int rounded = 0;
  for (std::size_t place = 1; place < 49; ++place) {
    std::vector<double> harmonics(49, 0.0);
    harmonics[place] = 1;
    const EllipsoidDensity w{.emission = SpherePolynomial(6, harmonics), .reflectivity = {}, .reflected = {}};
    const Approximation mean = surface_mean(EllipsoidShape({1, 1, 1}), w, 1e-25);
    ASSERT_LT(mean.radius, 1e-11);
    EXPECT_LE(std::abs(mean.value), mean.radius) << place;
    rounded += std::abs(mean.value) > 1e-20 ? 1 : 0;
  }
  EXPECT_GT(rounded, 10);
}

TEST(SurfaceMean, BoundsWhatCoarseRulesMiss) {
  // Sectoral harmonics have small means, known to no better than the rule bounds them.
  const EllipsoidShape shape({1, 4, Rational(3, 2)});
  for (int m = 1; m <= 14; ++m) {
    std::vector<double> harmonics(225, 0.0);
    harmonics[static_cast<std::size_t>(m * m + 2 * m)] = 1;
    const EllipsoidDensity w{
        .emission = SpherePolynomial(14, harmonics), .reflectivity = {}, .reflected = {}};
    const Approximation fine = surface_mean(shape, w, 1e-13);
    for (const double tolerance : {0.3, 0.1, 0.01, 1e-4}) {
      const Approximation coarse = surface_mean(shape, w, tolerance);
      EXPECT_LE(std::abs(coarse.value - fine.value), coarse.radius + fine.radius);
      EXPECT_LE(coarse.radius, 2 * tolerance);
      EXPECT_GE(coarse.radius, 0.02 * tolerance);
    }
  }
}

TEST(EllipsoidEnclosure, IsTheClosedFormOnASphere) {
  // T f is the mean of f: u = E + rho mean(E) / (1 - rho); mean x^2 = R^2/3, mean x^2 y^2 = R^4/15.
  Draw draw(12);
  const EllipsoidEnclosure found = enclosed({2, 2, 2}, "0.7", "x^2 + 3*x^2*y^2 - z", 1e-10);
  const double mean = 4.0 / 3 + 3 * 16.0 / 15;
  EXPECT_LE(found.bound, 1e-10);
  EXPECT_TRUE(found.hindrance.empty());
  EXPECT_NEAR(found.mean.value, mean / 0.3, found.mean.radius + 4e-15);
  EXPECT_LT(found.mean.radius, 1e-11);
  for (int k = 0; k < 100; ++k) {
    const Vector<double> p = drawn_direction(draw);
    const Triple q = long_direction(p);
    const Long exact =
        4 * q[0] * q[0] + 48 * q[0] * q[0] * q[1] * q[1] - 2 * q[2] + 0.7L / 0.3L * (4.0L / 3 + 16.0L / 5);
    const Approximation u = found.at(p);
    EXPECT_TRUE(u.guaranteed);
    EXPECT_LE(std::abs(static_cast<double>(exact - u.value)), u.radius);
  }
}

TEST(EllipsoidEnclosure, IsConstantInAFurnace) {
  for (const Vector<Rational>& axes :
       {unequal(), Vector<Rational>{4, 1, 1}, Vector<Rational>{Rational(1, 4), Rational(1, 3), 1}}) {
    const EllipsoidEnclosure found = enclosed(axes, "9/10", "1", 1e-9);
    EXPECT_LE(found.bound, 1e-9) << found.hindrance;
    EXPECT_LE(std::abs(found.mean.value - 10), found.mean.radius);
    EXPECT_LE(std::abs(found.at({0.6, 0, 0.8}).value - 10), found.at({0.6, 0, 0.8}).radius);
  }
  // E = 1 - rho with a rho that varies: u = 1, which no part of the search knows.
  const EllipsoidEnclosure varied = enclosed(unequal(), "1/2 + x*y/5 + z/10", "1/2 - x*y/5 - z/10", 1e-9);
  EXPECT_LE(varied.bound, 1e-9) << varied.hindrance;
  EXPECT_LE(std::abs(varied.mean.value - 1), varied.mean.radius);
  EXPECT_LE(std::abs(varied.at({0.3, -0.9, 0.1}).value - 1), varied.at({0.3, -0.9, 0.1}).radius);
}

TEST(EllipsoidEnclosure, SolvesTheEquation) {
  // v in place of u, brute force for T v: v - E - rho T v is at most (1 + rho) times the bound.
  Draw draw(13);
  for (const std::string rho : {"3/5", "(2 + x + y*z)/6"}) {
    const std::string e = "1 + x/2 - z^2*y/4 + x^2*y^2/3";
    const EllipsoidEnclosure found = enclosed(unequal(), rho, e, 1e-9);
    EXPECT_LE(found.bound, 1e-9) << found.hindrance;
    const Triple a = long_axes(unequal());
    const Expression reflectivity = formula(rho);
    const Expression emission = formula(e);
    for (int k = 0; k < 2; ++k) {
      const Vector<double> p = drawn_direction(draw);
      const Long of_v = judge::transported(
          a, long_direction(p),
          [&](const Triple& q) {
            return static_cast<Long>(
                value_of(found.v, {static_cast<double>(q[0] / a[0]), static_cast<double>(q[1] / a[1]),
                                   static_cast<double>(q[2] / a[2])}));
          },
          6, 80);
      const Triple q = long_direction(p);
      const Variables<Long> at{a[0] * q[0], a[1] * q[1], a[2] * q[2]};
      const Long expected = emission.evaluate<Long>(at) + reflectivity.evaluate<Long>(at) * of_v;
      EXPECT_LE(std::abs(static_cast<double>(expected - found.at(p).value)), 2 * found.bound + 1e-11);
    }
  }
}

TEST(EllipsoidEnclosure, ContainsFinerEnclosures) {
  Draw draw(14);
  const std::string e = "x^2 - y/2 + x*y*z";
  for (const Vector<Rational>& axes : {unequal(), Vector<Rational>{1, 2, Rational(3, 2)}}) {
    const EllipsoidEnclosure fine = enclosed(axes, "1/2", e, 1e-7);
    EXPECT_LE(fine.bound, 1e-7) << fine.hindrance;
    for (const double wanted : {1e-4, 1e-2}) {
      const EllipsoidEnclosure coarse = enclosed(axes, "1/2", e, wanted);
      EXPECT_LE(coarse.bound, wanted) << coarse.hindrance;
      EXPECT_LT(coarse.last.degree, fine.last.degree);
      double worst = 0;
      for (int k = 0; k < 300; ++k) {
        const Vector<double> p = drawn_direction(draw);
        worst = std::max(worst, std::abs(coarse.at(p).value - fine.at(p).value));
      }
      EXPECT_LE(worst, coarse.bound + fine.bound);
      EXPECT_GE(worst, 0.01 * coarse.bound);
      EXPECT_LE(std::abs(coarse.mean.value - fine.mean.value), coarse.mean.radius + fine.mean.radius);
      // The same v, its mean within the bound of that of u.
      const Approximation of_v = surface_mean(EllipsoidShape(axes), coarse.v, 1e-11);
      EXPECT_LE(std::abs(of_v.value - fine.mean.value), coarse.bound + of_v.radius + fine.mean.radius);
    }
  }
}

TEST(EllipsoidEnclosure, HoldsForASpoiledTrialFunction) {
  // |u - v| <= s sup|t| / (1 - s) = sup|t| for any q, s = 1/2; and sup|t| is not much more than what is seen.
  Draw draw(15);
  const EllipsoidShape shape(unequal());
  const EllipsoidEnclosure fine = enclosed(unequal(), "1/2", "x^2 - y/2 + x*y*z", 1e-9);
  double before = fine.bound;
  for (const double factor : {0.5, 0.8, 1.2}) {
    EllipsoidDensity v = fine.v;
    v.reflected = SpherePolynomial(5, drawn_harmonics(5, factor, draw));
    const Outcome<ErrorBound> bound = bound_of_error(shape, v, {.largest = 0.5, .gap = 0.5}, 1e-3);
    ASSERT_TRUE(bound.has_value());
    double off = 0;
    double seen = 0;
    const EllipsoidTransport transport(shape, v, 1e-10);
    for (int k = 0; k < 500; ++k) {
      const Vector<double> p = drawn_direction(draw);
      off = std::max(off, std::abs(value_of(v, p) - fine.at(p).value));
      seen = std::max(seen, std::abs(transport(p).value - value_of(v.reflected, p)));
    }
    EXPECT_LE(off, bound->bound + fine.bound);
    EXPECT_LE(seen, bound->bound);
    EXPECT_LT(bound->bound, 4 * seen);
    EXPECT_GT(bound->bound, before);
    before = bound->bound;
  }
}

TEST(EllipsoidEnclosure, HoldsForAConstantError) {
  // E = 1 - rho, u = 1, q = 1 + d: u - v = -rho d, t = -(1 - rho) d.
  const EllipsoidShape shape(unequal());
  for (const auto& [rho, spoiled] :
       {std::pair(Rational(9, 10), Rational(5, 4)), std::pair(Rational(1, 4), Rational(1001, 1000))}) {
    const EllipsoidDensity v{.emission = SpherePolynomial(Rational(1) - rho),
                             .reflectivity = SpherePolynomial(rho),
                             .reflected = SpherePolynomial(spoiled)};
    const double exact = (rho * (spoiled - Rational(1))).to_double();
    const Outcome<ErrorBound> bound = bound_of_error(
        shape, v,
        {.largest = rho.to_double() * (1 + 1e-15), .gap = (Rational(1) - rho).to_double() * (1 - 1e-15)},
        1e-3 * exact);
    ASSERT_TRUE(bound.has_value());
    EXPECT_GE(bound->bound, exact);
    EXPECT_LE(bound->bound, 3 * exact);
  }
}

TEST(EllipsoidEnclosure, HoldsWhatIsBeyondTheDegreeOfItsPoints) {
  // A target of which the tail is all that may be missed: the points are those for the degree of q, and the
  // tail of that degree is in the bound, at the points and between them.
  const EllipsoidShape shape(unequal());
  Draw draw(18);
  const EllipsoidDensity v{.emission = along("x - y*z", unequal()),
                           .reflectivity = SpherePolynomial(Rational(1, 2)),
                           .reflected = SpherePolynomial(3, drawn_harmonics(3, 0.1, draw))};
  const double tail = harmonic_tail(shape, v, 3);
  const Outcome<ErrorBound> bound =
      bound_of_error(shape, v, {.largest = 0.5, .gap = 0.5}, 1.01 * tail / 0.02);
  ASSERT_TRUE(bound.has_value());
  const std::vector<Vector<double>> points = sphere_cover(0.4);
  ASSERT_NEAR(static_cast<double>(bound->samples), static_cast<double>(points.size()), 8);
  const EllipsoidTransport transport(shape, v, 1e-10);
  double seen = 0;
  for (const Vector<double>& p : points)
    seen = std::max(seen, std::abs(transport(p).value - value_of(v.reflected, p)));
  const double expected = bound_between(seen + tail, 3, 0.4) + tail;
  EXPECT_GE(bound->bound, 0.999 * expected);
  EXPECT_LE(bound->bound, 2 * expected);
  EXPECT_GT(tail, 0.1 * seen);
}

TEST(EllipsoidEnclosure, BoundsTheMeanUnderAVaryingReflectivity) {
  // With polynomials of degree 2 alone v is coarse, and its mean is known far better than that of u.
  const Vector<Rational> axes{1, Rational(1, 2), Rational(1, 2)};
  const std::string rho = "1/2 + x*y/5 + z/10";
  const EllipsoidEnclosure fine = enclosed(axes, rho, "x^8", 1e-3);
  const EllipsoidEnclosure coarse = [&] {
    const std::vector<const WorkLimit*> limits = work_limits();
    const auto degree =
        std::ranges::find(limits, "continuous/ellipsoid_enclosure: degree of harmonics", &WorkLimit::name);
    const LoweredWorkLimit lowered(**degree, 2);
    return enclosed(axes, rho, "x^8", 1e-6);
  }();
  EXPECT_FALSE(coarse.hindrance.empty());
  const double off = std::abs(coarse.mean.value - fine.mean.value);
  EXPECT_LE(off, coarse.mean.radius + fine.mean.radius);
  EXPECT_GT(off - fine.mean.radius, 0.03 * coarse.mean.radius);
  EXPECT_GT(off - fine.mean.radius, 1e4 * surface_mean(EllipsoidShape(axes), coarse.v, 1e-8).radius);
}

TEST(EllipsoidEnclosure, CountsTheRoundingOfValues) {
  // Where nothing reflects u is E, and rounding is all that a value is off by.
  const Vector<Rational>& axes = unequal();
  const std::string text = "x/3 + x*y^2*z^4 - 2*y^5 + z^9/7";
  const Expression expression = formula(text);
  const EllipsoidEnclosure found = enclosed(axes, "0", text, 1e-9);
  EXPECT_EQ(found.bound, 0);
  Draw draw(19);
  int rounded = 0;
  for (int k = 0; k < 200; ++k) {
    const Vector<double> p = drawn_direction(draw);
    const Triple q = long_direction(p);
    const Triple a = long_axes(axes);
    const Long exact = expression.evaluate<Long>({a[0] * q[0], a[1] * q[1], a[2] * q[2]});
    const Approximation u = found.at(p);
    EXPECT_LE(std::abs(static_cast<double>(exact - u.value)), u.radius);
    EXPECT_LT(u.radius, 1e-9);
    rounded += std::abs(exact - u.value) > 1e-17L ? 1 : 0;
  }
  EXPECT_GT(rounded, 100);
}

TEST(EllipsoidEnclosure, CountsWhatAFurnaceMakesOfTheMeanOfE) {
  // E has the mean 0 on a sphere, exactly, and u that over 1 - rho: what the sum is off by becomes 1e8 times
  // as much.
  int rounded = 0;
  for (const std::string text : {"x^2 - y^2", "x^4 - z^4", "x^2*y^2 - y^2*z^2", "x^3 + x^2 - y^2"}) {
    const EllipsoidEnclosure found = enclosed({1, 1, 1}, "0.99999999", text, 1e-2);
    EXPECT_LE(std::abs(found.mean.value), found.mean.radius) << text;
    EXPECT_LT(found.mean.radius, 1e-3) << text;
    rounded += std::abs(found.mean.value) > 1e-11 ? 1 : 0;
  }
  EXPECT_GT(rounded, 0);
}

TEST(EllipsoidEnclosure, SaysWhatStoodInTheWay) {
  const EllipsoidEnclosure thin = enclosed({1, 1, Rational(1, 1000)}, "1/2", "x", 1e-8);
  EXPECT_FALSE(thin.hindrance.empty());
  EXPECT_GT(thin.bound, 1e-8);
  const EllipsoidEnclosure exact = enclosed({1, Rational(11, 10), 1}, "1/2", "x", 1e-30);
  EXPECT_EQ(exact.hindrance, "the rounding of double");
  EXPECT_LT(exact.bound, 1e-11);
  const EllipsoidEnclosure dark = enclosed(unequal(), "0", "x", 1e-30);
  EXPECT_EQ(dark.bound, 0);
  const EllipsoidEnclosure nothing = enclosed(unequal(), "1/2", "0", 1e-12);
  EXPECT_LE(nothing.bound, 1e-12);
  EXPECT_EQ(nothing.at({1, 0, 0}).value, 0);
  // The tests of the range of double: refused, or with a bound that holds, with the degrees that it takes
  // to see that.
  const std::vector<const WorkLimit*> limits = work_limits();
  const auto degree =
      std::ranges::find(limits, "continuous/ellipsoid_enclosure: degree of harmonics", &WorkLimit::name);
  const LoweredWorkLimit lowered(**degree, 12);
  for (const std::string e : {"1e300*x", "1e-300*x", "1e160*x*y - 1e160"}) {
    const EllipsoidEnclosure extreme = enclosed(unequal(), "1/2", e, 1e-3);
    EXPECT_TRUE(extreme.bound <= 1e-3 || !extreme.hindrance.empty()) << e;
  }
  for (const std::string rho :
       {"1", "x^17/1000000", "-1/10", "x", "1/2 + z/3", "3/4 + z/6", "3/4 + 2501*z/17000", "sqrt(x)"})
    EXPECT_FALSE(enclose_on_ellipsoid(
                     {.half_axes = unequal(), .reflectivity = formula(rho), .emission = formula("1")}, 1e-3)
                     .has_value())
        << rho;
  EXPECT_FALSE(enclose_on_ellipsoid({.half_axes = {1, 0, 1}, .reflectivity = {}, .emission = {}}, 1e-3));
}

TEST(EllipsoidEnclosure, HasTheSameBitsForAnyNumberOfThreads) {
  const auto run = [] { return enclosed(unequal(), "1/2", "x^2 - y/2 + x*y*z", 1e-5); };
  const EllipsoidEnclosure all = run();
  const ThreadLimit one(1);
  const EllipsoidEnclosure single = run();
  EXPECT_EQ(all.bound, single.bound);
  EXPECT_EQ(all.mean.value, single.mean.value);
  EXPECT_EQ(all.at({0, 0.6, 0.8}).value, single.at({0, 0.6, 0.8}).value);
}

}  // namespace
}  // namespace radcert
