// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/own_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "radcert/core/errors.h"
#include "radcert/scalar/functions/divided_difference.h"
#include "tests/laws/surface_laws.h"

namespace radcert {
namespace {

using Parameters = ParameterPoint<double>;

template <class Function>
OwnMap map_of(const Function& f) {
  return {.points = [f](std::span<const Parameters> at, OwnMap::Points points) {
    for (std::size_t i = 0; i < at.size(); ++i) points[i] = f(at[i].s, at[i].t);
  }};
}

template <class Function>
OwnChart chart_of(const std::string& name, const Function& f) {
  return interpolated_map(name, name, map_of(f));
}

std::string refusal(const auto& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

/// A polynomial of degree (5, 3) in whole numbers, and the same as a template.
template <class T>
Vector<T> polynomial(const T& s, const T& t) {
  return {s + s * s * s * s * s - t * t, t + s * t * t * t, s * s * t - t * t * t + s};
}

constexpr double height = 0.5;
Vector<double> vault(double s, double t) { return {s, t, 4 * height * s * (1 - s)}; }
Vector<double> ground(double s, double t) { return {s, t, 0}; }

/// The sphere about the origin by the faces of the cube [-1, 1]^3.
std::vector<OwnChart> sphere_of_cube() {
  std::vector<OwnChart> charts;
  for (const int axis : {0, 1, 2})
    for (const double side : {-1.0, 1.0}) {
      const auto face = [axis, side](double s, double t) {
        const double a = side * (2 * s - 1);  // so that sides run against each other too
        const double b = 2 * t - 1;
        const double r = std::sqrt(1 + a * a + b * b);
        if (axis == 0) return Vector<double>{side / r, a / r, b / r};
        if (axis == 1) return Vector<double>{b / r, side / r, a / r};
        return Vector<double>{a / r, b / r, side / r};
      };
      charts.push_back(interpolated_map("face_" + std::to_string(charts.size()), "sphere", map_of(face)));
    }
  return charts;
}

double distance(const Vector<double>& a, const Vector<double>& b) { return norm(a - b); }

TEST(OwnSurface, ReproducesPolynomials) {
  const OwnChart chart = chart_of("p", [](double s, double t) { return polynomial(s, t); });
  EXPECT_EQ(chart.degrees(), (std::array<int, 2>{5, 3}));
  EXPECT_LT(chart.residual, 1e-15);
  const ChartOf<double, ChebyshevMap<double>> found(ChebyshevMap<double>(chart.rows),
                                                    Orientation::along_the_cross_product);
  using D = DividedDifference<double>;
  for (const Parameters& at : laws::points_of_the_domain(ChartDomain::unit_square)) {
    const Vector<Dual<double>> f = polynomial(Dual<double>{at.s, 1, 0}, Dual<double>{at.t, 0, 1});
    const Frame<double> frame = found.frame(at);
    EXPECT_LT(distance(frame.point, {f.x.value, f.y.value, f.z.value}), 4e-15);
    EXPECT_LT(distance(frame.tangent_s, {f.x.by_s, f.y.by_s, f.z.by_s}), 4e-14);
    EXPECT_LT(distance(frame.tangent_t, {f.x.by_t, f.y.by_t, f.z.by_t}), 4e-14);
    for (const double step : {1e-9, 0.125}) {
      const Vector<D> g = polynomial(D::variable(at.s, step, 1), D::variable(at.t, -step / 2, 1));
      const Chord<double> chord = found.chord(at, {step, -step / 2});
      EXPECT_LT(distance(chord.bend_p, {g.x.second_p, g.y.second_p, g.z.second_p}), 1e-12 * step * step);
      EXPECT_LT(distance(chord.bend_q, {g.x.second_q, g.y.second_q, g.z.second_q}), 1e-12 * step * step);
    }
  }
}

TEST(OwnSurface, OfAPieceOfASphereObeysTheLawsAndIsClosed) {
  const std::vector<OwnChart> charts = sphere_of_cube();
  for (const OwnChart& chart : charts) EXPECT_LT(chart.residual, 1e-13);
  const Surface sphere = own_surface("sphere of a cube", charts);
  EXPECT_TRUE(sphere.closed);
  EXPECT_TRUE(sphere.unoccluded);
  EXPECT_FALSE(sphere.pieces_meet_at_angle);
  EXPECT_FALSE(is_known_in_balls(sphere));
  EXPECT_EQ(sphere.piece_names(), std::vector<std::string>{"sphere"});
  EXPECT_TRUE(laws::has_normals_across_its_tangents(sphere, 4e-16));
  EXPECT_TRUE(laws::has_tangents_that_are_derivatives(sphere, 1e-5, 1e-9));
  EXPECT_TRUE(laws::has_the_same_bits_in_packs(sphere));
  EXPECT_TRUE(laws::lies_inside_its_tangent_planes(sphere, 1e-13));
  EXPECT_TRUE(laws::has_a_vanishing_integral_of_its_normal(sphere, 64, 1e-3));
  for (const Chart& chart : sphere.charts)
    for (const Parameters& at : laws::points_of_the_domain(ChartDomain::unit_square)) {
      const Frame<double> frame = chart.in<double>().frame(at);
      EXPECT_NEAR(norm(frame.point), 1, 1e-13);
      EXPECT_LT(distance(unit_normal(frame), -1 * frame.point), 1e-10) << "not inwards";
    }
}

TEST(OwnSurface, TurnsNormalsToTheLightAndSeesWhatIsOpen) {
  const std::vector<OwnChart> charts{chart_of("floor", ground), chart_of("vault", vault)};
  const Surface hall = own_surface("hall", charts);
  EXPECT_TRUE(laws::obeys_the_surface_laws(hall));
  EXPECT_FALSE(hall.closed);
  EXPECT_TRUE(hall.pieces_meet_at_angle);
  EXPECT_TRUE(hall.charts[0].facts().plane.has_value());
  EXPECT_FALSE(hall.charts[1].facts().plane.has_value());
  EXPECT_EQ(hall.charts[0].facts().orientation, Orientation::along_the_cross_product);
  EXPECT_EQ(hall.charts[1].facts().orientation, Orientation::against_the_cross_product);
}

TEST(OwnSurface, IsRefusedWhereItIsNone) {
  const auto hat = [](double s, double t) { return Vector<double>{s, t, std::abs(s - 0.3)}; };
  EXPECT_NE(refusal([&] { chart_of("c", hat); }).find("/map: is not smooth enough"), std::string::npos);
  const auto hole = [](double s, double t) {
    return Vector<double>{s, t, s == 1 && t == 0 ? std::numeric_limits<double>::quiet_NaN() : 0};
  };
  EXPECT_NE(refusal([&] { chart_of("c", hole); }).find("/map: is not finite at (s, t) = (1, 0)"),
            std::string::npos);
  EXPECT_NE(refusal([&] {
              chart_of("c", [](double, double) { return Vector<double>{1, 2, 3}; });
            }).find("has one value"),
            std::string::npos);
  const auto refused = [](const std::vector<OwnChart>& charts) {
    return refusal([&] { static_cast<void>(own_surface("s", charts)); });
  };
  EXPECT_NE(refused({}).find("1 to 256 charts"), std::string::npos);
  EXPECT_NE(refused({chart_of("a", ground), chart_of("a", vault)}).find("is the name of two charts"),
            std::string::npos);
  const auto fan = [](double s, double t) { return Vector<double>{s * t, s * (1 - t), 0}; };
  EXPECT_NE(refused({chart_of("fan", fan)}).find("has no normal at (s, t) = (0, 0)"), std::string::npos);
  const auto wave = [](double s, double t) { return Vector<double>{s, t, s * s * s}; };
  EXPECT_EQ(refused({chart_of("bent", wave)}), "");
  const auto saddle = [](double s, double t) { return Vector<double>{s, t, (s - 0.5) * (t - 0.5)}; };
  EXPECT_NE(refused({chart_of("saddle", saddle)}).find("on both sides of its tangent plane"),
            std::string::npos);
  const auto slope = [](double s, double t) { return Vector<double>{1 + s, t, s}; };
  EXPECT_EQ(refused({chart_of("floor", ground), chart_of("slope", slope)}), "");
  EXPECT_NE(refused({interpolated_map("floor", "one", map_of(ground)),
                     interpolated_map("slope", "one", map_of(slope))})
                .find("meets floor at an angle"),
            std::string::npos);
}

TEST(OwnSurface, HoldsTangentsAgainstTheMap) {
  OwnMap map = map_of(vault);
  map.tangents = [](std::span<const Parameters> at, OwnMap::Tangents tangents) {
    for (std::size_t i = 0; i < at.size(); ++i)
      tangents[i] = {{{1, 0, 4 * height * (1 - 2 * at[i].s)}, {0, 1, 0}}};
  };
  EXPECT_LT(interpolated_map("vault", "vault", map).tangent_residual.value(), 1e-14);
  map.tangents = [](std::span<const Parameters> at, OwnMap::Tangents tangents) {
    for (std::size_t i = 0; i < at.size(); ++i)
      tangents[i] = {{{1, 0, 4 * height * (1 - 2 * at[i].s) + 1e-5}, {0, 1, 0}}};
  };
  EXPECT_NE(refusal([&] {
              static_cast<void>(interpolated_map("vault", "vault", map));
            }).find("/jacobian: is no derivative of the map"),
            std::string::npos);
}

}  // namespace
}  // namespace radcert
