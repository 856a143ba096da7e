// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/kernel/geometric_kernel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"

namespace radcert {
namespace {

using Exact = Vector<Rational>;
using Long = long double;

class Stream {
public:
  explicit Stream(unsigned seed) : bits_(seed) {}
  double uniform() { return static_cast<double>(bits_() >> 11U) * 0x1p-53; }
  ParameterPoint<double> in_triangle() {
    const double s = uniform();
    return {s, uniform() * (1 - s)};
  }
  std::size_t index(std::size_t count) { return bits_() % count; }

private:
  std::mt19937_64 bits_;
};

TEST(GeometricKernel, IsExactWhereItCanBe) {
  // Faces of a right angle: P at height 2 on x = 0, Q at distance 3 on z = 0: G = (3 * 2) / 13^2
  EXPECT_EQ(geometric_kernel<Rational>({0, 0, 2}, {1, 0, 0}, {3, 0, 0}, {0, 0, 1}), Rational(6, 169));
  // Parallel faces at distance 2
  EXPECT_EQ(geometric_kernel<Rational>({0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, -1}), Rational(1, 4));
  // One plane
  EXPECT_EQ(geometric_kernel<Rational>({0, 0, 0}, {0, 0, 1}, {5, 1, 0}, {0, 0, 1}), Rational(0));
}

TEST(GeometricKernel, IsSymmetricAndScalesWithTheInverseSquare) {
  const Exact p{Rational(1, 2), -3, 4};
  const Exact n_p{1, Rational(2, 3), -1};
  const Exact q{7, Rational(1, 5), Rational(-2, 9)};
  const Exact n_q{Rational(-1, 4), 2, 5};
  const Rational g = geometric_kernel(p, n_p, q, n_q);
  EXPECT_NE(g, Rational(0));
  EXPECT_EQ(geometric_kernel(q, n_q, p, n_p), g);
  const Rational c(-7, 3);
  EXPECT_EQ(geometric_kernel(c * p, n_p, c * q, n_q) * c * c, g);
  EXPECT_EQ(geometric_kernel(p, c * n_p, q, n_q), c * g);
  EXPECT_EQ(geometric_kernel(p, n_p, q, c * n_q), c * g);
  const Exact shift{1, 2, 3};
  EXPECT_EQ(geometric_kernel(p + shift, n_p, q + shift, n_q), g);
}

TEST(GeometricKernel, IsAQuarterOnTheUnitSphere) {
  const Surface surface = sphere();
  Stream stream(3);
  for (int k = 0; k < 500; ++k) {
    const Frame<double> p = surface.charts[stream.index(8)].in<double>().frame(stream.in_triangle());
    const Frame<double> q = surface.charts[stream.index(8)].in<double>().frame(stream.in_triangle());
    const double distance = norm(p.point - q.point);
    if (distance < 1e-2) continue;
    EXPECT_NEAR(geometric_kernel(p.point, unit_normal(p), q.point, unit_normal(q)), 0.25,
                1e-15 / (distance * distance));
  }
}

TEST(ChordKernel, IsAQuarterOnTheUnitSphereAtAnyDistance) {
  const Surface surface = sphere();
  Stream stream(4);
  for (int k = 0; k < 500; ++k) {
    const ChartIn<double>& chart = surface.charts[stream.index(8)].in<double>();
    const ParameterPoint<double> p = stream.in_triangle();
    const ParameterPoint<double> w = std::pow(10, -100 * stream.uniform()) * (stream.in_triangle() - p);
    const double g =
        chord_kernel(chart.chord(p, w), unit_normal(chart.frame(p)), unit_normal(chart.frame(p + w)));
    EXPECT_NEAR(g, 0.25, 4e-15) << "at " << p.s << " " << p.t << " step " << w.s << " " << w.t;
  }
}

TEST(ChordKernel, AgreesWithTheGeometricKernelInLongDouble) {
  const ChartOf<Long, EllipsoidOctant<Long>> ellipsoid_formula(EllipsoidOctant<Long>(1, 2, 5, {-1, 1, 1}),
                                                               Orientation::along_the_cross_product);
  const ChartOf<Long, PowerRoof<Long>> roof_formula(PowerRoof<Long>{Rational(3, 2)},
                                                    Orientation::against_the_cross_product);
  const std::array<Chart, 2> charts{ellipsoid(1, 2, 5).charts[1], two_piece(Rational(3, 2)).charts[1]};
  const std::array<const ChartIn<Long>*, 2> formulas{&ellipsoid_formula, &roof_formula};
  Stream stream(5);
  for (int k = 0; k < 1000; ++k) {
    const std::size_t which = stream.index(2);
    const ChartIn<double>& chart = charts[which].in<double>();
    const ParameterPoint<double> p = stream.in_triangle();
    const ParameterPoint<double> w = std::pow(10, -5 * stream.uniform()) * (stream.in_triangle() - p);
    const Frame<Long> here = formulas[which]->frame({p.s, p.t});
    const Frame<Long> there =
        formulas[which]->frame({static_cast<Long>(p.s) + w.s, static_cast<Long>(p.t) + w.t});
    const Vector<Long> n_p = unit_normal(here);
    const Vector<Long> n_q = unit_normal(there);
    const Long truth = geometric_kernel(here.point, n_p, there.point, n_q);
    const Long distance = norm(there.point - here.point);
    // What the header promises of the geometric kernel, in long double.
    const Long depth =
        std::abs(dot(there.point - here.point, n_p)) + std::abs(dot(there.point - here.point, n_q));
    const Long lost = 4e-19L * (1 + norm(here.point)) * (depth + 4e-19L) / std::pow(distance, 4.0L);
    const double g =
        chord_kernel(chart.chord(p, w), unit_normal(chart.frame(p)), unit_normal(chart.frame(p + w)));
    EXPECT_NEAR(g, static_cast<double>(truth), static_cast<double>(2e-13L * std::abs(truth) + lost))
        << "at " << p.s << " " << p.t << " step " << w.s << " " << w.t;
    if (distance > 1e-2L) {
      const Frame<double> a = chart.frame(p);
      const Frame<double> b = chart.frame(p + w);
      EXPECT_NEAR(geometric_kernel(a.point, unit_normal(a), b.point, unit_normal(b)), g,
                  1e-10 * std::abs(g) + 1e-10);
    }
  }
}

TEST(ChordKernel, IsLinearInTheNormals) {
  const Surface surface = two_piece(2);
  const ChartIn<double>& chart = surface.charts[1].in<double>();
  const Frame<double> p = chart.frame({0.25, 0.5});
  const Frame<double> q = chart.frame({0.75, 0.25});
  const Chord<double> chord = chart.chord({0.25, 0.5}, {0.5, -0.25});
  EXPECT_DOUBLE_EQ(chord_kernel(chord, unit_normal(p), q.area_normal),
                   area_element(q) * chord_kernel(chord, unit_normal(p), unit_normal(q)));
}

TEST(ChordKernel, VanishesOnAFlatChart) {
  const Surface surface = cube();
  const ChartIn<double>& chart = surface.charts[2].in<double>();
  const Frame<double> frame = chart.frame({0.5, 0.5});
  EXPECT_EQ(chord_kernel(chart.chord({0.5, 0.5}, {0.1, -0.3}), unit_normal(frame), unit_normal(frame)), 0);
}

}  // namespace
}  // namespace radcert
