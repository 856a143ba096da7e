// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/catalogue.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "radcert/core/contract.h"
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

TEST(Catalogue, IsCoveredByTheSamples) {
  // An entry without a sample here is an entry whose laws nobody checks.
  std::set<std::string> sampled;
  for (const SampleSurface& sample : sample_surfaces()) sampled.insert(sample.entry);
  std::set<std::string> known;
  for (const SurfaceDescription& entry : surface_catalogue()) known.insert(entry.name);
  EXPECT_EQ(sampled, known);
  EXPECT_EQ(known.size(), surface_catalogue().size()) << "a name twice";
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

/// The parameter points and weights of a rule that is exact enough for areas: Simpson's in each direction, graded to s = 0.
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
    EXPECT_EQ(surface.closed, sample.volume.has_value()) << title(sample);
    if (!sample.volume) continue;
    // Gauss: 3 volume = - Int P . n dS, n the inner normal
    double volume = 0;
    for (const Chart& chart : surface.charts)
      volume -= integral_over_domain(chart.facts().domain,
                                     [&chart](const ParameterPoint<double>& at) {
                                       const Frame<double> frame = chart.in<double>().frame(at);
                                       return dot(frame.point, frame.area_normal);
                                     }) /
                3;
    EXPECT_NEAR(volume, *sample.volume, 2e-5 * *sample.volume) << title(sample);
  }
}

/// The sides of a chart's image with n + 1 points each, in the direction that has the surface on its left as seen from inside.
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

TEST(Catalogue, KnowsThePlaneOfExactlyTheFlatCharts) {
  for (const SampleSurface& sample : sample_surfaces()) {
    const Surface surface = sample.make();
    for (std::size_t j = 0; j < surface.chart_count(); ++j) {
      const Chart& chart = surface.charts[j];
      long double bend = 0;
      for (const ParameterPoint<double>& at : sample_points(chart.facts().domain)) {
        const ParameterPoint<long double> p{at.s, at.t};
        const ParameterPoint<long double> w{0.3L - p.s, 0.2L - p.t};
        bend = std::max(bend, norm(sample.charts[j]->chord(p, w).bend_p));
        if (!chart.facts().plane) continue;
        const Vector<Rational>& n = chart.facts().plane->normal();
        const Vector<double> point = chart.in<double>().frame(at).point;
        const Vector<double> normal{n.x.to_double(), n.y.to_double(), n.z.to_double()};
        EXPECT_NEAR(dot(normal, point), chart.facts().plane->offset().to_double(), 1e-14 * norm(normal))
            << title(sample);
        EXPECT_LT(norm(cross(normal, chart.in<double>().frame(at).area_normal)), 1e-14 * norm(normal))
            << title(sample);
      }
      EXPECT_EQ(chart.facts().plane.has_value(), bend == 0) << title(sample) << " " << chart.facts().name;
      EXPECT_EQ(in_one_plane(chart, chart), chart.facts().plane.has_value()) << title(sample);
    }
  }
}

TEST(Catalogue, HasOppositeFacesInDifferentPlanes) {
  const Surface surface = cube();
  for (std::size_t a = 0; a < 6; ++a)
    for (std::size_t b = 0; b < 6; ++b) EXPECT_EQ(in_one_plane(surface.charts[a], surface.charts[b]), a == b);
}

}  // namespace
}  // namespace radcert
