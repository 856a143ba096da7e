// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/catalogue.h"
#include "radcert/surface/chart_pieces.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/scalar/mpfr_real.h"
#include "radcert/surface/catalogue/box.h"
#include "tests/surface/sample_surfaces.h"

namespace radcert {
namespace {

using testing::sample_points;
using testing::sample_surfaces;
using testing::SampleSurface;

std::string title(const SampleSurface& sample) {
  std::string text = sample.entry;
  for (const Rational& value : sample.values) text += " " + value.to_text();
  return text;
}

struct Visit {
  const Chart* chart;
  Frame<double> frame;
};

std::vector<Visit> visits(const Surface& surface) {
  std::vector<Visit> all;
  for (const Chart& chart : surface.charts)
    for (const ParameterPoint<double>& at : sample_points(chart.facts().domain))
      all.push_back({&chart, chart.in<double>().frame(at)});
  return all;
}

TEST(Catalogue, HasEachNameOnce) {
  std::set<std::string> known;
  for (const SurfaceDescription& entry : surface_catalogue()) known.insert(entry.name);
  EXPECT_EQ(known.size(), surface_catalogue().size());
}

TEST(Catalogue, MakesWhatItDescribes) {
  for (const SurfaceDescription& entry : surface_catalogue()) {
    std::vector<Rational> values;
    for (const ParameterDescription& parameter : entry.parameters) {
      const Outcome<Rational> value = Rational::parse(parameter.default_text);
      ASSERT_TRUE(value) << entry.name << " " << parameter.name;
      EXPECT_TRUE(parameter.admits(*value)) << entry.name << " " << parameter.name;
      EXPECT_FALSE(parameter.requirement.empty());
      values.push_back(*value);
    }
    const Surface surface = entry.make(values);
    EXPECT_EQ(surface.name, entry.name);
    EXPECT_EQ(surface.unoccluded, entry.unoccluded);
    EXPECT_EQ(surface.piece_names(), entry.pieces);
    ASSERT_EQ(surface.parameters.size(), entry.parameters.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      EXPECT_EQ(surface.parameters[i].name, entry.parameters[i].name);
      EXPECT_EQ(surface.parameters[i].value, values[i]);
    }
    EXPECT_EQ(find_surface(entry.name), &entry);
  }
  EXPECT_EQ(find_surface("no such surface"), nullptr);
}

TEST(Catalogue, RefusesExactlyWhatItDoesNotAdmit) {
  for (const SurfaceDescription& entry : surface_catalogue())
    for (std::size_t i = 0; i < entry.parameters.size(); ++i)
      for (const Rational& candidate :
           {Rational(-1), Rational(0), Rational(1, 2), Rational(1), Rational(9, 2)}) {
        std::vector<Rational> values;
        for (const ParameterDescription& parameter : entry.parameters)
          values.push_back(*Rational::parse(parameter.default_text));
        values[i] = candidate;
        if (entry.parameters[i].admits(candidate)) {
          EXPECT_NO_THROW(entry.make(values)) << entry.name << " " << candidate.to_text();
        } else {
          EXPECT_THROW(entry.make(values), ContractViolation) << entry.name << " " << candidate.to_text();
        }
      }
}

TEST(Catalogue, HasADiagonalAChartAndChartsOfDistinctNames) {
  for (const SampleSurface& sample : sample_surfaces()) {
    const Surface surface = sample.make();
    EXPECT_EQ(surface.diagonals.size(), surface.chart_count()) << title(sample);
    std::set<std::string> names;
    for (std::size_t chart = 0; chart < surface.chart_count(); ++chart) {
      names.insert(surface.charts[chart].facts().name);
      EXPECT_EQ(surface.piece_names().at(surface.piece_of(chart)), surface.charts[chart].facts().piece)
          << title(sample);
    }
    EXPECT_EQ(names.size(), surface.chart_count()) << title(sample);
    const std::vector<std::size_t> pieces = chart_pieces(surface);
    ASSERT_EQ(pieces.size(), surface.chart_count());
    for (std::size_t k = 0; k < pieces.size(); ++k) EXPECT_EQ(pieces[k], surface.piece_of(k));
    EXPECT_THROW(static_cast<void>(surface.piece_of(surface.chart_count())), ContractViolation);
  }
}

TEST(Catalogue, LiesInTheBoundaryOfAConvexBodyWithInnerNormals) {
  for (const SampleSurface& sample : sample_surfaces()) {
    const Surface surface = sample.make();
    if (!surface.unoccluded) continue;
    const std::vector<Visit> all = visits(surface);
    for (const Visit& p : all) {
      const Vector<double> normal = unit_normal(p.frame);
      double deepest = 0;
      for (const Visit& q : all) {
        const double depth = dot(q.frame.point - p.frame.point, normal);
        EXPECT_GE(depth, -4e-15 * (1 + norm(q.frame.point))) << title(sample) << " " << p.chart->facts().name;
        deepest = std::max(deepest, depth);
      }
      EXPECT_GT(deepest, 0.05) << title(sample) << " " << p.chart->facts().name;
    }
  }
}

/// The parameter points and weights of a rule that is exact enough for areas: Simpson's in each direction,
/// graded to s = 0.
template <class Function>
double integral_over_domain(ChartDomain domain, const Function& f) {
  constexpr int n = 64;
  const auto weight = [](int i) { return (i == 0 || i == n ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) / (3.0 * n); };
  double sum = 0;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double z = static_cast<double>(i) / n;
      const double s = z * z * z * z;
      const double t = static_cast<double>(j) / n;
      const double height = domain == ChartDomain::unit_square ? 1 : 1 - s;
      sum += weight(i) * weight(j) * 4 * z * z * z * height * f(ParameterPoint<double>{s, t * height});
    }
  return sum;
}

TEST(Catalogue, HasTheAreaItShould) {
  int checked = 0;
  for (const SampleSurface& sample : sample_surfaces()) {
    if (!sample.area) continue;
    ++checked;
    double area = 0;
    for (const Chart& chart : sample.make().charts)
      area += integral_over_domain(chart.facts().domain, [&chart](const ParameterPoint<double>& at) {
        return area_element(chart.in<double>().frame(at));
      });
    EXPECT_NEAR(area, *sample.area, 2e-5 * *sample.area) << title(sample);
  }
  EXPECT_GE(checked, 7);
}

TEST(Catalogue, EnclosesTheVolumeItShouldIfClosed) {
  for (const SampleSurface& sample : sample_surfaces()) {
    const Surface surface = sample.make();
    EXPECT_TRUE(surface.closed || !sample.volume) << title(sample);
    if (!surface.closed) continue;
    // Gauss: 3 volume = - Int P . n dS, n the inner normal
    double volume = 0;
    for (const Chart& chart : surface.charts)
      volume -= integral_over_domain(chart.facts().domain,
                                     [&chart](const ParameterPoint<double>& at) {
                                       const Frame<double> frame = chart.in<double>().frame(at);
                                       return dot(frame.point, frame.area_normal);
                                     }) /
                3;
    EXPECT_GT(volume, 0) << title(sample);
    const double known = sample.volume.value_or(volume);
    EXPECT_NEAR(volume, known, 2e-5 * known) << title(sample);
  }
}

/// The sides of a chart's image with n + 1 points each, in the direction that has the surface on its left as
/// seen from inside.
std::vector<std::vector<Vector<double>>> sides(const Chart& chart) {
  constexpr int n = 8;
  std::vector<ParameterPoint<double>> corners{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  if (chart.facts().domain == ChartDomain::unit_triangle) corners = {{0, 0}, {1, 0}, {0, 1}};
  std::vector<std::vector<Vector<double>>> all;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ParameterPoint<double>& a = corners[i];
    const ParameterPoint<double>& b = corners[(i + 1) % corners.size()];
    std::vector<Vector<double>> side;
    for (int k = 0; k <= n; ++k) {
      const double l = static_cast<double>(k) / n;
      side.push_back(chart.in<double>().frame((1 - l) * a + l * b).point);
    }
    if (chart.facts().orientation == Orientation::against_the_cross_product)
      side = {side.rbegin(), side.rend()};
    all.push_back(side);
  }
  return all;
}

TEST(Catalogue, HasNoBoundaryIfClosed) {
  // Each side of each chart is a side of exactly one other, point by point, run through the other way.
  for (const SampleSurface& sample : sample_surfaces()) {
    const Surface surface = sample.make();
    std::vector<std::vector<Vector<double>>> all;
    for (const Chart& chart : surface.charts)
      for (const std::vector<Vector<double>>& side : sides(chart)) all.push_back(side);
    std::size_t matched = 0;
    for (const std::vector<Vector<double>>& side : all) {
      int partners = 0;
      for (const std::vector<Vector<double>>& other : all) {
        double distance = 0;
        for (std::size_t k = 0; k < side.size(); ++k)
          distance = std::max(distance, norm(side[k] - other[side.size() - 1 - k]));
        partners += distance < 4e-16 * (1 + norm(side.front())) ? 1 : 0;
      }
      EXPECT_LE(partners, 1) << title(sample);
      matched += static_cast<std::size_t>(partners);
    }
    EXPECT_EQ(matched == all.size(), surface.closed) << title(sample);
  }
}

TEST(Catalogue, JoinsThePiecesSmoothlyInsideAndAtAnAngleWhereItSaysSo) {
  for (const SampleSurface& sample : sample_surfaces()) {
    const Surface surface = sample.make();
    bool angle = false;
    const std::vector<Visit> all = visits(surface);
    for (const Visit& p : all)
      for (const Visit& q : all) {
        if (p.chart == q.chart || norm(p.frame.point - q.frame.point) > 1e-14) continue;
        const double jump = norm(unit_normal(p.frame) - unit_normal(q.frame));
        if (p.chart->facts().piece == q.chart->facts().piece) {
          EXPECT_LT(jump, 1e-12) << title(sample);
        } else {
          angle = angle || jump > 0.1;
        }
      }
    EXPECT_EQ(angle, surface.pieces_meet_at_angle) << title(sample);
  }
}

TEST(Catalogue, KnowsThePlaneOfExactlyTheFlatChartsAndWhichAreAffine) {
  for (const SampleSurface& sample : sample_surfaces()) {
    const Surface surface = sample.make();
    for (std::size_t j = 0; j < surface.chart_count(); ++j) {
      const Chart& chart = surface.charts[j];
      const std::string where = title(sample) + " " + chart.facts().name;
      const ChartIn<Mpfr<50>>& formula = chart.in<Mpfr<50>>();
      Mpfr<50> bend;
      Mpfr<50> rise;  // of the chart's image above its tangent planes
      for (const ParameterPoint<double>& at : sample_points(chart.facts().domain)) {
        const ParameterPoint<Mpfr<50>> p{Mpfr<50>(at.s), Mpfr<50>(at.t)};
        const ParameterPoint<Mpfr<50>> w{Mpfr<50>(0.3) - p.s, Mpfr<50>(0.2) - p.t};
        const Vector<Mpfr<50>> bend_p = formula.chord(p, w).bend_p;
        bend = max(bend, norm(bend_p));
        rise = max(rise, abs(dot(bend_p, formula.frame(p).area_normal)));
        if (!chart.facts().flat_in()) continue;
        const Vector<Rational>& n = chart.facts().flat_in()->normal();
        const Vector<double> point = chart.in<double>().frame(at).point;
        const Vector<double> normal{n.x.to_double(), n.y.to_double(), n.z.to_double()};
        EXPECT_NEAR(dot(normal, point), chart.facts().flat_in()->offset().to_double(), 1e-14 * norm(normal))
            << where;
        EXPECT_LT(norm(cross(normal, chart.in<double>().frame(at).area_normal)), 1e-14 * norm(normal))
            << where;
      }
      EXPECT_EQ(chart.facts().plane.has_value(), bend == Mpfr<50>()) << where;
      EXPECT_EQ(chart.facts().flat_in().has_value(), rise == Mpfr<50>()) << where;
      EXPECT_FALSE(chart.facts().plane && chart.facts().plane_of_disk) << where;
      EXPECT_EQ(in_one_plane(chart, chart), chart.facts().flat_in().has_value()) << where;
    }
  }
}

TEST(Catalogue, HasTheChartsOfADiskInOnePlaneAndTheDisksOfACylinderInTwo) {
  const Surface surface = find_surface("cylinder")->make(std::vector<Rational>{2, 3});
  for (std::size_t a = 0; a < surface.chart_count(); ++a)
    for (std::size_t b = 0; b < surface.chart_count(); ++b)
      EXPECT_EQ(in_one_plane(surface.charts[a], surface.charts[b]),
                surface.charts[a].facts().piece == surface.charts[b].facts().piece &&
                    surface.charts[a].facts().piece != "mantle");
}

TEST(Catalogue, HasAnAreaElementOfTheSphericalCapThatIsThatOfTheDiskTimesFourF) {
  for (const Rational& fraction : {Rational(1, 4), Rational(9, 10)})
    for (const Chart& chart : find_surface("spherical_cap")->make(std::vector<Rational>{fraction}).charts)
      for (const ParameterPoint<double>& at : sample_points(chart.facts().domain)) {
        const double of_disk = 1 / ((1 - 2 * at.s * at.t) * (1 - 2 * at.s * at.t));
        EXPECT_NEAR(area_element(chart.in<double>().frame(at)), 4 * fraction.to_double() * of_disk, 2e-14);
      }
}

TEST(Catalogue, HasPointsThatFulfilTheEquationsOfTheSurfaces) {
  const auto expect_zero = [](const Surface& surface, const std::string& piece, const auto& equation) {
    int points = 0;
    for (const Visit& visit : visits(surface)) {
      if (visit.chart->facts().piece != piece) continue;
      const Vector<double>& p = visit.frame.point;
      EXPECT_NEAR(equation(p, p.x * p.x + p.y * p.y), 0, 4e-15) << surface.name << " " << piece;
      ++points;
    }
    EXPECT_GT(points, 0) << surface.name << " " << piece;
  };
  using V = Vector<double>;
  const auto make = [](const char* name, const std::vector<Rational>& values) {
    return find_surface(name)->make(values);
  };
  expect_zero(make("spherical_cap", {Rational(2, 3)}), "cap", [](const V& p, double r2) {
    return std::max(std::abs(r2 + p.z * p.z - 1), -1.0 / 3 - p.z > 1e-15 ? 1.0 : 0.0);
  });
  const Surface frustum = make("cone", {2, Rational(1, 2), 3});
  expect_zero(frustum, "floor", [](const V& p, double r2) { return std::max(p.z, r2 - 4 - 1e-15); });
  expect_zero(frustum, "ceiling",
              [](const V& p, double r2) { return std::max(std::abs(p.z - 3), r2 - 0.25 - 1e-15); });
  expect_zero(frustum, "mantle", [](const V& p, double r2) { return std::sqrt(r2) - (2 - p.z / 2); });
  expect_zero(make("cylinder", {1, 2}), "mantle", [](const V&, double r2) { return r2 - 1; });
  expect_zero(make("paraboloid_cap", {}), "cap", [](const V& p, double r2) { return p.z - (1 - r2); });
  expect_zero(make("octahedron", {}), "face_mpm", [](const V& p, double) { return -p.x + p.y - p.z - 1; });
  expect_zero(make("tetrahedron", {}), "face_mpp", [](const V& p, double) { return -p.x + p.y + p.z - 1; });
  expect_zero(make("torus", {1, Rational(1, 3)}), "torus", [](const V& p, double r2) {
    const double distance = std::sqrt(r2) - 1;
    return distance * distance + p.z * p.z - 1.0 / 9;
  });
}

TEST(Catalogue, HasOppositeFacesInDifferentPlanes) {
  const Surface surface = cube();
  for (std::size_t a = 0; a < 6; ++a)
    for (std::size_t b = 0; b < 6; ++b) EXPECT_EQ(in_one_plane(surface.charts[a], surface.charts[b]), a == b);
}

/// What a quadric says of the normals: the gradient of q.
Vector<double> gradient_of(const Quadric& quadric, const Vector<double>& at) {
  const auto number = [](const Rational& x) { return x.to_double(); };
  const auto in_doubles = [&number](const Vector<Rational>& v) {
    return Vector<double>{number(v.x), number(v.y), number(v.z)};
  };
  const Vector<double> squares = in_doubles(quadric.squares);
  Vector<double> gradient = Vector<double>{2 * squares.x * at.x, 2 * squares.y * at.y, 2 * squares.z * at.z} +
                            in_doubles(quadric.linear.gradient);
  if (quadric.nappe) gradient = gradient - 2 * quadric.nappe->value(at) * in_doubles(quadric.nappe->gradient);
  return gradient;
}

TEST(ChartStructure, HasTheChartsOnTheirQuadricsAndTheSurfaceInside) {
  int quadrics = 0;
  for (const SampleSurface& sample : sample_surfaces()) {
    const Surface surface = sample.make();
    const std::vector<Visit> all = visits(surface);
    for (const Chart& chart : surface.charts) {
      const std::optional<Quadric>& quadric = chart.facts().structure.quadric;
      if (!quadric) continue;
      ++quadrics;
      const std::string where = title(sample) + " " + chart.facts().name;
      EXPECT_TRUE(quadric->has_convex_inside()) << where;
      for (const Visit& p : all) {
        const Vector<double> gradient = gradient_of(*quadric, p.frame.point);
        const double rounding = 4e-15 * norm(gradient) * (1 + norm(p.frame.point));
        EXPECT_LE(quadric->value(p.frame.point), rounding) << where;
        if (quadric->nappe) {
          EXPECT_GT(quadric->nappe->value(p.frame.point), 0) << where;
        }
        if (p.chart != &chart) continue;
        EXPECT_GE(quadric->value(p.frame.point), -rounding) << where;
        EXPECT_LE(norm(gradient + norm(gradient) * unit_normal(p.frame)), 1e-14 * norm(gradient)) << where;
      }
    }
  }
  EXPECT_GT(quadrics, 0);
}

TEST(ChartStructure, HasRulingsAndAxesThatTheChartsFollow) {
  const auto in_doubles = [](const Vector<Rational>& v) {
    return Vector<double>{v.x.to_double(), v.y.to_double(), v.z.to_double()};
  };
  int ruled = 0;
  int revolved = 0;
  for (const SampleSurface& sample : sample_surfaces()) {
    const Surface surface = sample.make();
    for (const Visit& p : visits(surface)) {
      const ChartStructure& structure = p.chart->facts().structure;
      const std::string where = title(sample) + " " + p.chart->facts().name;
      if (structure.ruling) {
        ++ruled;
        EXPECT_LE(norm(p.frame.tangent_t - in_doubles(*structure.ruling)), 4e-16 * norm(p.frame.tangent_t))
            << where;
      }
      if (structure.revolution) {
        ++revolved;
        const Vector<double> out = p.frame.point - in_doubles(structure.revolution->point);
        const Vector<double> axis = in_doubles(structure.revolution->direction);
        EXPECT_NEAR(dot(cross(axis, out), unit_normal(p.frame)), 0, 1e-15 * norm(axis) * (1 + norm(out)))
            << where;
      }
    }
  }
  EXPECT_GT(ruled, 0);
  EXPECT_GT(revolved, 0);
}

TEST(ChartStructure, SaysOfEveryUnoccludedChartWhyItIsConvex) {
  for (const SampleSurface& sample : sample_surfaces()) {
    const Surface surface = sample.make();
    for (const Chart& chart : surface.charts) {
      const ChartFacts& facts = chart.facts();
      EXPECT_EQ(facts.flat_in() || facts.structure.quadric || facts.structure.ruling, surface.unoccluded)
          << title(sample) << " " << facts.name;
    }
  }
}

TEST(ChartStructure, TellsConvexQuadricsFromOthers) {
  const AffineForm none{{0, 0, 0}, -1};
  const AffineForm height{{0, 0, 1}, 0};
  EXPECT_TRUE((Quadric{.squares = {1, 2, 3}, .linear = none}).has_convex_inside());
  EXPECT_TRUE((Quadric{.squares = {1, 0, 0}, .linear = height}).has_convex_inside());
  EXPECT_FALSE((Quadric{.squares = {1, 1, -1}, .linear = none}).has_convex_inside()) << "one sheet";
  EXPECT_FALSE((Quadric{.squares = {-1, -1, 0}, .linear = height}).has_convex_inside());
  EXPECT_TRUE((Quadric{.squares = {1, 1, 0}, .linear = {{0, 0, 0}, 1}, .nappe = height}).has_convex_inside())
      << "two sheets, one of them";
  EXPECT_FALSE((Quadric{.squares = {1, 1, 0}, .linear = none, .nappe = height}).has_convex_inside())
      << "x^2 + y^2 - 1 <= z^2 is one sheet again";
  EXPECT_FALSE((Quadric{.squares = {1, 1, 0}, .linear = height, .nappe = height}).has_convex_inside())
      << "sqrt(x^2 + y^2 + z) is not convex";
  EXPECT_FALSE(
      (Quadric{.squares = {1, -1, 0}, .linear = {{0, 0, 0}, 0}, .nappe = height}).has_convex_inside());
}

}  // namespace
}  // namespace radcert
