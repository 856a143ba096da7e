// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/interpolated_chart.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "radcert/scalar/pack.h"
#include "radcert/scalar/rational.h"
#include "radcert/surface/catalogue/cone.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"

namespace radcert {
namespace {

using Exact = LatticePolynomial<Rational>;
using Corners = std::array<ParameterPoint<double>, 3>;

/// A polynomial map of the plane into space with small whole coefficients.
class RandomPolynomial {
public:
  RandomPolynomial(int degree, std::mt19937_64& stream) {
    for (int i = 0; i <= degree; ++i)
      for (int j = 0; i + j <= degree; ++j) {
        const auto coefficient = [&] { return Rational(static_cast<long>(stream() % 19) - 9); };
        terms_.push_back({i, j, {coefficient(), coefficient(), coefficient()}});
      }
  }
  Vector<Rational> operator()(const Rational& s, const Rational& t) const {
    Vector<Rational> sum{};
    for (const Term& term : terms_) sum = sum + power(s, term.i) * power(t, term.j) * term.coefficient;
    return sum;
  }

private:
  struct Term {
    int i;
    int j;
    Vector<Rational> coefficient;
  };
  static Rational power(const Rational& x, int k) {
    Rational product = 1;
    for (int i = 0; i < k; ++i) product *= x;
    return product;
  }
  std::vector<Term> terms_;
};

std::vector<ParameterPoint<Rational>> lattice(int degree) {
  std::vector<ParameterPoint<Rational>> points;
  for (int a = 0; a <= degree; ++a)
    for (int b = 0; a + b <= degree; ++b) points.push_back({Rational(a, degree), Rational(b, degree)});
  return points;
}

template <class Map>
Exact interpolant(int degree, const Map& map) {
  std::vector<Vector<Rational>> from_corner;
  const Vector<Rational> corner = map(Rational(0), Rational(0));
  for (const ParameterPoint<Rational>& at : lattice(degree)) from_corner.push_back(map(at.s, at.t) - corner);
  return {degree, corner, from_corner};
}

TEST(LatticePolynomial, TakesTheGivenValuesOnItsLatticeExactly) {
  std::mt19937_64 stream(1);
  for (int degree = 1; degree <= 6; ++degree) {
    const RandomPolynomial map(degree + 3, stream);
    const Exact f = interpolant(degree, map);
    for (const ParameterPoint<Rational>& at : lattice(degree))
      EXPECT_EQ(f(at.s, at.t), map(at.s, at.t)) << degree << ": " << at.s.to_text() << " " << at.t.to_text();
    EXPECT_NE(f(Rational(1, 7), Rational(2, 11)), map(Rational(1, 7), Rational(2, 11))) << degree;
  }
}

TEST(LatticePolynomial, ReproducesPolynomialsOfItsDegreeExactly) {
  std::mt19937_64 stream(2);
  for (int degree = 1; degree <= 6; ++degree)
    for (int lower = 0; lower <= degree; ++lower) {
      const RandomPolynomial map(lower, stream);
      const Exact f = interpolant(degree, map);
      for (const auto& [s, t] : {ParameterPoint<Rational>{Rational(1, 7), Rational(2, 11)},
                                 {Rational(5, 13), Rational(8, 13)},
                                 {Rational(-3), Rational(4)}})
        EXPECT_EQ(f(s, t), map(s, t)) << degree << " " << lower;
    }
}

TEST(LatticePolynomial, HasBendsThatAreWhatTheTangentLeavesOfTheDifference) {
  // Exactly: Q - P = DF(p) w + bend_p = DF(q) w - bend_q.
  using D = DividedDifference<Rational>;
  using Derivative = Dual<Rational>;
  std::mt19937_64 stream(3);
  for (int degree = 1; degree <= 6; ++degree) {
    const Exact f = interpolant(degree, RandomPolynomial(degree, stream));
    const ParameterPoint<Rational> p{Rational(1, 7), Rational(2, 11)};
    const ParameterPoint<Rational> w{Rational(3, 5), Rational(-1, 9)};
    const ParameterPoint<Rational> q = p + w;
    const auto along_w = [&](const ParameterPoint<Rational>& at) {
      const Vector<Derivative> g =
          f(Derivative(at.s, Rational(1), Rational(0)), Derivative(at.t, Rational(0), Rational(1)));
      return Vector<Rational>{w.s * g.x.by_s + w.t * g.x.by_t, w.s * g.y.by_s + w.t * g.y.by_t,
                              w.s * g.z.by_s + w.t * g.z.by_t};
    };
    const Vector<D> chord = f(D::variable(p.s, w.s, Rational(1)), D::variable(p.t, w.t, Rational(1)));
    const Vector<Rational> difference = f(q.s, q.t) - f(p.s, p.t);
    EXPECT_EQ((Vector<Rational>{chord.x.first, chord.y.first, chord.z.first}), difference);
    EXPECT_EQ((Vector<Rational>{chord.x.second_p, chord.y.second_p, chord.z.second_p}),
              difference - along_w(p));
    EXPECT_EQ((Vector<Rational>{chord.x.second_q, chord.y.second_q, chord.z.second_q}),
              along_w(q) - difference);
  }
}

TEST(LatticePolynomial, RefusesDegreesOutOfRangeAndOtherNumbersOfValues) {
  const Vector<Rational> corner{};
  for (const int degree : {-1, 0, 7, 100})
    EXPECT_THROW(Exact(degree, corner, std::vector<Vector<Rational>>(3)), ContractViolation) << degree;
  EXPECT_THROW(Exact(2, corner, std::vector<Vector<Rational>>(5)), ContractViolation);
  EXPECT_THROW(Exact(2, corner, std::vector<Vector<Rational>>(7)), ContractViolation);
  for (const int degree : {0, 7})
    EXPECT_THROW(interpolated_chart(two_piece(3).charts[1], {{{0, 0}, {1, 0}, {0, 1}}}, degree, "k"),
                 ContractViolation);
}

TEST(InterpolatedChart, BelongsToThePieceOfItsChartAndFacesItsWay) {
  const Corners vertices{{{0.25, 0.25}, {0.5, 0.25}, {0.5, 0.5}}};
  for (const Surface& surface : {two_piece(3), ellipsoid(1, 2, 5)})
    for (const Chart& chart : surface.charts)
      for (int degree = 1; degree <= 6; ++degree) {
        const Chart element = interpolated_chart(chart, vertices, degree, "element 7");
        EXPECT_EQ(element.facts().name, "element 7");
        EXPECT_EQ(element.facts().piece, chart.facts().piece);
        EXPECT_EQ(element.facts().domain, ChartDomain::unit_triangle);
        EXPECT_EQ(element.facts().singular, SingularLine::none);
        EXPECT_EQ(element.facts().plane.has_value(), degree == 1);
        const Vector<double> mine = unit_normal(element.in<double>().frame({0.25, 0.25}));
        const ParameterPoint<double> centre =
            vertices[0] + 0.25 * (vertices[1] - vertices[0]) + 0.25 * (vertices[2] - vertices[0]);
        EXPECT_GT(dot(mine, unit_normal(chart.in<double>().frame(centre))), 0.9) << chart.facts().name;
      }
}

TEST(InterpolatedChart, OfDegreeOneLiesInItsPlaneExactly) {
  const Chart roof = two_piece(3).charts[1];
  const Corners vertices{{{0.25, 0.125}, {0.5, 0.125}, {0.5, 0.375}}};
  const Chart flat = interpolated_chart(roof, vertices, 1, "flat");
  const Plane& plane = flat.facts().plane.value();
  for (const ParameterPoint<double>& vertex : vertices) {
    const Vector<double> corner = roof.in<double>().frame(vertex).point;  // dyadic, no rounding
    EXPECT_EQ(dot(plane.normal(),
                  {Rational::exactly(corner.x), Rational::exactly(corner.y), Rational::exactly(corner.z)}),
              plane.offset());
  }
  const Chord<double> chord = flat.in<double>().chord({0.2, 0.3}, {0.4, 0.05});
  EXPECT_EQ(norm(chord.bend_p), 0);
  EXPECT_EQ(norm(chord.bend_q), 0);
  EXPECT_TRUE(
      in_one_plane(flat, interpolated_chart(roof, {{{0.5, 0.375}, {0.25, 0.375}, {0.25, 0.125}}}, 1, "b")));
  EXPECT_FALSE(in_one_plane(flat, interpolated_chart(roof, {{{0.5, 0}, {0.75, 0}, {0.75, 0.25}}}, 1, "c")));
}

TEST(InterpolatedChart, OfADiskIsFlat) {
  const Corners vertices{{{0.25, 0.125}, {0.5, 0.125}, {0.5, 0.375}}};
  const Corners rim{{{0.5, 0.5}, {0.25, 0.75}, {0.25, 0.5}}};
  const Surface surface = cone(1, Rational(1, 3), Rational(1, 7));
  for (int degree = 1; degree <= 6; ++degree) {
    std::vector<Chart> elements;
    for (const std::size_t chart : {4UL, 6UL})  // two quadrants of the ceiling
      for (const Corners& corners : {vertices, rim})
        elements.push_back(interpolated_chart(surface.charts[chart], corners, degree, "element"));
    for (const Chart& element : elements) {
      EXPECT_EQ(element.facts().plane.has_value(), degree == 1);
      EXPECT_TRUE(in_one_plane(element, elements.front()));
    }
    EXPECT_FALSE(in_one_plane(elements.front(), interpolated_chart(surface.charts[0], rim, degree, "floor")));
    EXPECT_EQ(interpolated_chart(surface.charts[8], rim, degree, "mantle").facts().flat_in().has_value(),
              degree == 1);
  }
}

TEST(InterpolatedChart, HasInPacksTheBitsOfDouble) {
  const Chart element = interpolated_chart(ellipsoid(1, 2, 5).charts[3],
                                           {{{0.25, 0.125}, {0.375, 0.125}, {0.25, 0.25}}}, 5, "e");
  const ParameterPoint<double> p{0.3, 0.25};
  const ParameterPoint<double> w{-0.15, 0.4};
  const auto all = [](double x) { return Pack(x); };
  const Frame<double> frame = element.in<double>().frame(p);
  const Frame<Pack> frames = element.in<Pack>().frame({all(p.s), all(p.t)});
  EXPECT_EQ(frames.point.z.lane(3), frame.point.z);
  EXPECT_EQ(frames.area_normal.x.lane(7), frame.area_normal.x);
  const Chord<double> chord = element.in<double>().chord(p, w);
  const Chord<Pack> chords = element.in<Pack>().chord({all(p.s), all(p.t)}, {all(w.s), all(w.t)});
  EXPECT_EQ(chords.difference.y.lane(0), chord.difference.y);
  EXPECT_EQ(chords.bend_p.x.lane(1), chord.bend_p.x);
  EXPECT_EQ(chords.bend_q.z.lane(5), chord.bend_q.z);
}

TEST(InterpolatedChart, KeepsTheDigitsOfBendsOnASmallElement) {
  // On S(2) degree 2 is exact: with a width h of the element in s the bend of z is -(h w_s)^2, wherever p is.
  const Chart roof = two_piece(2).charts[1];
  for (const double size : {1.0 / 16, 1.0 / 1024, 1.0 / 65536})
    for (const double s : {0.1, 0.3, 0.37, 0.611, 0.9}) {
      const ParameterPoint<double> corner{s, 0.3};
      const Corners vertices{
          {corner, corner + ParameterPoint<double>{size, 0}, corner + ParameterPoint<double>{0, size}}};
      const double h = vertices[1].s - vertices[0].s;
      const Chart element = interpolated_chart(roof, vertices, 2, "e");
      const Chord<double> chord = element.in<double>().chord({0.125, 0.25}, {0.5, 0.25});
      EXPECT_NEAR(chord.bend_p.z, -h * h * 0.25, 4e-16 * h) << s << " " << size;
      EXPECT_NEAR(chord.bend_q.z, -h * h * 0.25, 4e-16 * h) << s << " " << size;
    }
}

}  // namespace
}  // namespace radcert
