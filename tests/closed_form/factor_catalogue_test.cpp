// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/closed_form/factor_catalogue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "radcert/closed_form/polygon_to_polygon.h"
#include "tests/closed_form/gauss_legendre.h"
#include "tests/closed_form/known_digits.h"

namespace radcert {
namespace {

using std::numbers::pi;
using Point = Vector<Rational>;

constexpr double narrow = 1e-30;

const std::vector<Rational>& lengths() {
  static const std::vector<Rational> list{1, 2, Rational(1, 3), Rational(7, 5), 20, Rational(1, 50)};
  return list;
}

PlanePolygon polygon(const std::vector<Point>& corners) { return plane_polygon(corners).value(); }

// Rectangles with the edge from 0 to `edge` on the y-axis in common; the second in the direction (cosine, 0,
// sine).
Ball rectangles_by_polygons(const Rational& edge, const Rational& from, const Rational& to,
                            const Rational& cosine, const Rational& sine) {
  return polygon_to_polygon(
      polygon({{0, 0, 0}, {from, 0, 0}, {from, edge, 0}, {0, edge, 0}}),
      polygon({{0, 0, 0}, {0, edge, 0}, {to * cosine, edge, to * sine}, {to * cosine, 0, to * sine}}));
}

TEST(FactorCatalogue, HasTheKnownValues) {
  EXPECT_TRUE(has_digits(opposed_rectangles(1, 1, 1), "0.19982489569838738304"));
  EXPECT_TRUE(has_digits(opposed_rectangles(1, 1, Rational(1, 2)), "0.41525328357714673537"));
  EXPECT_TRUE(has_digits(opposed_rectangles(1, 1, 2), "0.06858958881855244779"));
  EXPECT_TRUE(has_digits(perpendicular_rectangles(1, 1, 1), "0.20004377607540315424"));
  EXPECT_TRUE(has_digits(inclined_rectangles(1, 1, 1, Rational(1, 2)), "0.3709053211500514359"));
  EXPECT_TRUE(has_digits(inclined_rectangles(1, 1, 1, Rational(-1, 2)), "0.08661500111827605883"));
  EXPECT_TRUE(same_number(regular_tetrahedron(), Ball(Rational(1, 3)), narrow));
  EXPECT_TRUE(same_number(corner_tetrahedron(), (3 - sqrt(Ball(3))) / 6, narrow));
  EXPECT_TRUE(same_number(coaxial_disks(1, 1, 1), (3 - sqrt(Ball(5))) / 2, narrow));
  EXPECT_TRUE(has_digits(sphere_to_coaxial_disk(1, Rational(1, 2)), "0.27639320225002103036"));
  EXPECT_TRUE(same_number(outer_sphere_to_inner(1, 2), Ball(Rational(1, 4)), narrow));
  EXPECT_TRUE(same_number(inclined_strips(3, 3, 0), 1 - sqrt(Ball(2)) / 2, narrow));
}

TEST(OpposedRectangles, AgreeWithPolygons) {
  for (const Rational& a : lengths())
    for (const Rational& b : lengths())
      for (const Rational& h : {Rational(1), Rational(1, 9), Rational(13)})
        EXPECT_TRUE(same_number(opposed_rectangles(a, b, h),
                                polygon_to_polygon(polygon({{0, 0, 0}, {a, 0, 0}, {a, b, 0}, {0, b, 0}}),
                                                   polygon({{0, 0, h}, {0, b, h}, {a, b, h}, {a, 0, h}})),
                                1e-24))
            << a.to_text() << " " << b.to_text() << " " << h.to_text();
}

TEST(InclinedRectangles, AgreeWithPolygons) {
  for (const Rational& a : lengths())
    for (const Rational& b : lengths()) {
      EXPECT_TRUE(same_number(perpendicular_rectangles(Rational(3, 2), a, b),
                              rectangles_by_polygons(Rational(3, 2), a, b, 0, 1), 1e-27))
          << a.to_text() << " " << b.to_text();
      for (const auto& [cosine, sine] :
           {std::pair<Rational, Rational>{{3, 5}, {4, 5}}, {{-4, 5}, {3, 5}}, {{12, 13}, {5, 13}}, {0, 1}})
        EXPECT_TRUE(same_number(inclined_rectangles(Rational(3, 2), a, b, cosine),
                                rectangles_by_polygons(Rational(3, 2), a, b, cosine, sine), 1e-24))
            << a.to_text() << " " << b.to_text() << " cosine " << cosine.to_text();
    }
}

TEST(InclinedRectangles, AreOneAtEqualAngles) {
  for (const Rational& a : lengths()) {
    const Rational b(5, 4);
    EXPECT_TRUE(same_number(inclined_rectangles_at_angle(1, a, b, Rational(1, 2)),
                            perpendicular_rectangles(1, a, b), 1e-27));
    EXPECT_TRUE(same_number(inclined_rectangles_at_angle(1, a, b, Rational(1, 3)),
                            inclined_rectangles(1, a, b, Rational(1, 2)), 1e-27));
    EXPECT_TRUE(same_number(inclined_rectangles_at_angle(1, a, b, Rational(2, 3)),
                            inclined_rectangles(1, a, b, Rational(-1, 2)), 1e-27));
  }
}

TEST(FactorCatalogue, IsReciprocal) {
  for (const Rational& a : lengths())
    for (const Rational& b : lengths()) {
      EXPECT_TRUE(same_number(Ball(a) * perpendicular_rectangles(3, a, b),
                              Ball(b) * perpendicular_rectangles(3, b, a), 1e-25));
      EXPECT_TRUE(same_number(Ball(a) * inclined_rectangles_at_angle(3, a, b, Rational(1, 7)),
                              Ball(b) * inclined_rectangles_at_angle(3, b, a, Rational(1, 7)), 1e-24));
      EXPECT_TRUE(
          same_number(Ball(a * a) * coaxial_disks(a, b, 2), Ball(b * b) * coaxial_disks(b, a, 2), 1e-30));
      EXPECT_TRUE(same_number(Ball(a) * inclined_strips(a, b, Rational(1, 4)),
                              Ball(b) * inclined_strips(b, a, Rational(1, 4)), 1e-30));
    }
}

// The mean over `from` of what arrives, by the double integral itself.

double disks_by_quadrature(double from, double to, double distance) {
  const auto rule = gauss_legendre(24);
  const double sum = integral(rule, 0, from, [&](double r) {
    return integral(rule, 0, to, [&](double s) {
      return integral(rule, 0, pi, [&](double phi) {
        const double squared = distance * distance + r * r + s * s - 2 * r * s * std::cos(phi);
        return r * s * distance * distance / (squared * squared);
      });
    });
  });
  return 2 * pi * 2 * sum / (pi * pi * from * from);
}

// From the cylinder of radius R and this length to that of radius r about the same axis, which is seen up to
// the angle phi_end. The height enters by the difference of the heights alone; it is scaled so that the
// integrand stays smooth at phi = 0, z = 0.
double cylinders_by_quadrature(double from, double to, double length, double phi_end) {
  const auto rule = gauss_legendre(40);
  const double sum = integral(rule, 0, phi_end, [&](double phi) {
    const double squared = from * from + to * to - 2 * from * to * std::cos(phi);
    const double flat = std::sqrt(squared);
    const double away = from - to * std::cos(phi);
    const double toward = from * std::cos(phi) - to;  // to the outer side, where radii differ
    const double facing = from == to ? away * away : away * toward;
    // z = flat tan(angle)
    return to * facing * integral(rule, 0, std::atan(length / flat), [&](double angle) {
             const double z = flat * std::tan(angle);
             const double cosine = std::cos(angle);
             return (length - z) * cosine * cosine / (squared * flat);
           });
  });
  return 4 * sum / (pi * length);
}

TEST(CoaxialDisks, AreTheDoubleIntegral) {
  for (const auto& [a, b, h] :
       {std::array{1, 1, 1}, std::array{1, 3, 2}, std::array{2, 1, 2}, std::array{1, 2, 5}})
    EXPECT_NEAR(coaxial_disks(a, b, h).to_double(), disks_by_quadrature(a, b, h), 1e-9)
        << a << " " << b << " " << h;
}

TEST(CoaxialCylinders, AreTheDoubleIntegral) {
  for (const auto& [inner, outer, length] : {std::array{1, 2, 1}, std::array{1, 2, 5}, std::array{2, 3, 1},
                                             std::array{3, 4, 20}, std::array{1, 9, 4}}) {
    const double turn = std::acos(static_cast<double>(inner) / outer);
    EXPECT_NEAR(outer_cylinder_to_inner(inner, outer, length).to_double(),
                cylinders_by_quadrature(outer, inner, length, turn), 1e-8)
        << inner << " " << outer << " " << length;
    EXPECT_NEAR(outer_cylinder_to_itself(inner, outer, length).to_double(),
                cylinders_by_quadrature(outer, outer, length, 2 * turn), 1e-8)
        << inner << " " << outer << " " << length;
    EXPECT_NEAR(cylinder_to_itself(outer, length).to_double(),
                cylinders_by_quadrature(outer, outer, length, pi), 1e-8)
        << outer << " " << length;
  }
}

TEST(CoaxialCylinders, HaveTheirLimits) {
  // A thin inner cylinder takes nothing away; long ones lose nothing through the rings.
  const Rational thin(1, 1000000);
  EXPECT_NEAR(outer_cylinder_to_itself(thin, 2, 3).to_double(), cylinder_to_itself(2, 3).to_double(), 2e-6);
  const Rational length(1000000);
  const double inwards = outer_cylinder_to_inner(2, 3, length).to_double();
  EXPECT_NEAR(inwards + outer_cylinder_to_itself(2, 3, length).to_double(), 1, 5e-6);
  EXPECT_NEAR(inwards, 2.0 / 3, 5e-6);
}

TEST(CylinderToItself, ClosesWithTheDisks) {
  for (const Rational& r : lengths())
    for (const Rational& h : lengths())
      // From the inside, of area 2 pi r h, to either disk: (1 - F)/2; back: (1 - coaxial_disks).
      EXPECT_TRUE(same_number(Ball(h) * (1 - cylinder_to_itself(r, h)),
                              Ball(r) * (1 - coaxial_disks(r, r, h)), 1e-33));
}

TEST(SphereToCoaxialDisk, IsTheIntegralOverTheDisk) {
  const auto rule = gauss_legendre(30);
  for (const auto& [radius, distance] : {std::pair{1, 1}, {1, 4}, {3, 2}}) {
    const double h = distance;
    // An element of the disk sees a sphere of radius r under (r/d)^2 (h/d); the sphere has the area 4 pi r^2.
    const double sum =
        integral(rule, 0, radius, [&](double s) { return s * h / std::pow(s * s + h * h, 1.5); });
    EXPECT_NEAR(sphere_to_coaxial_disk(radius, distance).to_double(), sum / 2, 1e-13);
  }
}

TEST(Strips, AreTheMeanOverTheFirst) {
  const auto rule = gauss_legendre(40);
  for (const auto& [w, h] : {std::pair{1, 1}, {2, 1}, {1, 3}}) {
    const double width = w;
    const double distance = h;
    const double mean =
        integral(rule, 0, width,
                 [&](double s) {
                   return (s / std::hypot(s, distance) + (width - s) / std::hypot(width - s, distance)) / 2;
                 }) /
        width;
    EXPECT_NEAR(opposed_strips(w, h).to_double(), mean, 1e-12);
  }
  for (const auto& [a, b, cosine] : {std::tuple{1, 1, 0.5}, {2, 1, -0.5}, {1, 3, 0.25}}) {
    const double from = a;
    const double to = b;
    const double turn = cosine;
    const double mean =
        integral(rule, 0, from,
                 [&](double s) {
                   return (1 + (to * turn - s) / std::sqrt(s * s + to * to - 2 * s * to * turn)) / 2;
                 }) /
        from;
    EXPECT_NEAR(inclined_strips(a, b, Rational::exactly(cosine)).to_double(), mean, 1e-10);
  }
}

TEST(Strips, AreTheLimitOfLongRectangles) {
  const Rational edge(100000);
  EXPECT_NEAR(opposed_rectangles(edge, 2, 3).to_double(), opposed_strips(2, 3).to_double(), 2e-5);
  EXPECT_NEAR(inclined_rectangles(edge, 2, 3, Rational(1, 3)).to_double(),
              inclined_strips(2, 3, Rational(1, 3)).to_double(), 2e-5);
}

TEST(Elements, AreTheIntegralOverTheTarget) {
  const auto rule = gauss_legendre(40);
  for (const auto& [p, h] : {std::pair{1, 1}, {2, 3}, {1, 2}}) {
    const double c = h;
    const double disk =
        integral(rule, 0, p, [&](double s) { return 2 * s * c * c / std::pow(s * s + c * c, 2); });
    EXPECT_NEAR(element_to_parallel_disk(p, h).to_double(), disk, 1e-12);
    // A sphere fills the cone around it.
    const double half_angle = std::asin(static_cast<double>(p) / (p + h));
    const double sphere =
        integral(rule, 0, half_angle, [](double t) { return 2 * std::sin(t) * std::cos(t); });
    EXPECT_NEAR(element_to_sphere(p, p + h).to_double(), sphere, 1e-12);
  }
}

class Stream {
public:
  explicit Stream(unsigned seed) : bits_(seed) {}
  std::size_t below(std::size_t count) { return bits_() % count; }
  double uniform() { return static_cast<double>(bits_() >> 11U) * 0x1p-53; }
  // From 1e-12 to 1e12, and now and then 1.
  Rational length() {
    return below(4) == 0 ? Rational(1) : Rational::exactly(std::pow(10, 24 * uniform() - 12));
  }
  Rational between(const Rational& low, const Rational& high) {
    const Rational part = Rational::exactly(below(3) == 0 ? std::pow(10, -8 * uniform()) : uniform());
    return low + (below(2) == 0 ? part : 1 - part) * (high - low);
  }

private:
  std::mt19937_64 bits_;
};

enum class Takes { length, length_above_first, length_from_first, cosine, half_turns };

struct Factor {
  std::string name;
  std::vector<Takes> takes;
  std::function<Ball(const std::vector<Rational>&)> value;
};

template <class... Parameters>
Factor factor(const std::string& name, Ball (*function)(Parameters...), std::vector<Takes> takes = {}) {
  takes.resize(sizeof...(Parameters), Takes::length);
  return {name, std::move(takes), [function](const std::vector<Rational>& values) {
            return [&]<std::size_t... place>(std::index_sequence<place...>) {
              return function(values[place]...);
            }
            (std::index_sequence_for<Parameters...>{});
          }};
}

std::vector<Factor> all_factors() {
  using enum Takes;
  return {factor("opposed_rectangles", opposed_rectangles),
          factor("perpendicular_rectangles", perpendicular_rectangles),
          factor("inclined_rectangles", inclined_rectangles, {length, length, length, cosine}),
          factor("inclined_rectangles_at_angle", inclined_rectangles_at_angle,
                 {length, length, length, half_turns}),
          factor("coaxial_disks", coaxial_disks),
          factor("cylinder_to_itself", cylinder_to_itself),
          factor("outer_cylinder_to_inner", outer_cylinder_to_inner, {length, length_above_first}),
          factor("outer_cylinder_to_itself", outer_cylinder_to_itself, {length, length_above_first}),
          factor("sphere_to_coaxial_disk", sphere_to_coaxial_disk),
          factor("outer_sphere_to_inner", outer_sphere_to_inner, {length, length_above_first}),
          factor("opposed_strips", opposed_strips),
          factor("inclined_strips", inclined_strips, {length, length, cosine}),
          factor("element_to_parallel_disk", element_to_parallel_disk),
          factor("element_to_sphere", element_to_sphere, {length, length_from_first})};
}

std::vector<Rational> random_values(const Factor& of, Stream& stream) {
  std::vector<Rational> values;
  for (const Takes takes : of.takes) switch (takes) {
      case Takes::length: values.push_back(stream.length()); break;
      case Takes::length_above_first: values.push_back(values.front() + stream.length()); break;
      case Takes::length_from_first:
        values.push_back(values.front() + (stream.below(4) == 0 ? Rational(0) : stream.length()));
        break;
      case Takes::cosine: values.push_back(stream.between(-1, 1)); break;
      case Takes::half_turns: values.push_back(stream.between(0, 1)); break;
    }
  return values;
}

std::string text(const Factor& of, const std::vector<Rational>& values) {
  std::string all = of.name;
  for (const Rational& value : values) all += " " + shortest(value.to_double());
  return all;
}

TEST(FactorCatalogue, StaysBetweenZeroAndOne) {
  Stream stream(4);
  const BallPrecision scope(1024);
  for (const Factor& of : all_factors())
    for (int k = 0; k < 20; ++k) {
      const std::vector<Rational> values = random_values(of, stream);
      const Ball value = of.value(values);
      EXPECT_TRUE(certainly_positive(value)) << text(of, values) << ": " << value.to_text();
      EXPECT_TRUE(certainly_at_most(value, Ball(1))) << text(of, values) << ": " << value.to_text();
      // Lengths alone: another unit changes nothing.
      std::vector<Rational> scaled = values;
      for (std::size_t n = 0; n < scaled.size(); ++n)
        if (of.takes[n] != Takes::cosine && of.takes[n] != Takes::half_turns) scaled[n] *= Rational(22, 7);
      EXPECT_TRUE(overlaps(of.value(scaled), value)) << text(of, values);
    }
}

TEST(FactorCatalogue, RefusesWhatItDoesNotAdmit) {
  Stream stream(5);
  for (const Factor& of : all_factors()) {
    const std::vector<Rational> values = random_values(of, stream);
    for (std::size_t k = 0; k < values.size(); ++k) {
      const Takes takes = of.takes[k];
      const Rational border = takes == Takes::length_above_first  ? values[0]
                              : takes == Takes::length_from_first ? values[0] / 2
                              : takes == Takes::cosine            ? Rational(1)
                                                                  : Rational(0);
      for (const Rational& wrong : {Rational(-1), border}) {
        std::vector<Rational> changed = values;
        changed[k] = wrong;
        EXPECT_THROW((void)of.value(changed), ContractViolation) << text(of, changed);
      }
    }
  }
}

}  // namespace
}  // namespace radcert
