// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/chart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "tests/surface/sample_surfaces.h"

namespace radcert {
namespace {

using testing::sample_points;
using testing::sample_surfaces;
using testing::SampleSurface;
using Long = long double;

Vector<Long> widened(const Vector<double>& x) { return {x.x, x.y, x.z}; }

/// Calls the visitor with each chart in both arithmetics and each of its sample points.
void for_each_point(
    const std::function<void(const Chart&, const ChartIn<Long>&, const ParameterPoint<double>&,
                             const std::string& where)>& visit) {
  for (const SampleSurface& sample : sample_surfaces()) {
    const Surface surface = sample.make();
    ASSERT_EQ(surface.chart_count(), sample.charts.size()) << sample.entry;
    for (std::size_t j = 0; j < surface.chart_count(); ++j)
      for (const ParameterPoint<double>& at : sample_points(surface.charts[j].facts().domain))
        visit(surface.charts[j], *sample.charts[j], at,
              sample.entry + " " + surface.charts[j].facts().name + " " + std::to_string(at.s) + " " +
                  std::to_string(at.t));
  }
}

TEST(Chart, FrameAgreesWithLongDouble) {
  for_each_point([](const Chart& chart, const ChartIn<Long>& formula, const ParameterPoint<double>& at,
                    const std::string& where) {
    const Frame<double> frame = chart.in<double>().frame(at);
    const Frame<Long> truth = formula.frame({at.s, at.t});
    EXPECT_LE(norm(widened(frame.point) - truth.point), 4e-16L * (1 + norm(truth.point))) << where;
    EXPECT_LE(norm(widened(frame.tangent_s) - truth.tangent_s), 1e-15L * (1 + norm(truth.tangent_s)))
        << where;
    EXPECT_LE(norm(widened(frame.tangent_t) - truth.tangent_t), 1e-15L * (1 + norm(truth.tangent_t)))
        << where;
    EXPECT_LE(norm(widened(frame.area_normal) - truth.area_normal),
              2e-15L * (1 + norm(truth.tangent_s) * norm(truth.tangent_t)))
        << where;
  });
}

TEST(Chart, TangentsAreDerivatives) {
  for_each_point([](const Chart& chart, const ChartIn<Long>& formula, const ParameterPoint<double>& at,
                    const std::string& where) {
    constexpr Long h = 1e-6L;
    if (chart.facts().singular == SingularLine::s_zero && at.s < 0.1) return;
    // Formulas go on a little beyond their domain, except at a singular line.
    const Frame<Long> frame = formula.frame({at.s, at.t});
    const auto point = [&](Long s, Long t) { return formula.frame({at.s + s, at.t + t}).point; };
    const Vector<Long> by_s = (1 / (2 * h)) * (point(h, 0) - point(-h, 0));
    const Vector<Long> by_t = (1 / (2 * h)) * (point(0, h) - point(0, -h));
    EXPECT_LE(norm(by_s - frame.tangent_s), 2e-9L * (1 + norm(by_s))) << where;
    EXPECT_LE(norm(by_t - frame.tangent_t), 2e-9L * (1 + norm(by_t))) << where;
  });
}

TEST(Chart, AreaNormalIsOrthogonalToTheTangentsAndAsLongAsTheirParallelogram) {
  for_each_point([](const Chart& chart, const ChartIn<Long>&, const ParameterPoint<double>& at,
                    const std::string& where) {
    const Frame<double> frame = chart.in<double>().frame(at);
    const double scale = norm(frame.tangent_s) * norm(frame.tangent_t);
    EXPECT_LE(std::abs(dot(frame.area_normal, frame.tangent_s)), 4e-16 * scale * norm(frame.tangent_s))
        << where;
    EXPECT_LE(std::abs(dot(frame.area_normal, frame.tangent_t)), 4e-16 * scale * norm(frame.tangent_t))
        << where;
    const double inner = dot(frame.tangent_s, frame.tangent_t);
    const double squared =
        dot(frame.tangent_s, frame.tangent_s) * dot(frame.tangent_t, frame.tangent_t) - inner * inner;
    EXPECT_NEAR(area_element(frame) * area_element(frame), squared, 4e-15 * scale * scale) << where;
    EXPECT_NEAR(norm(unit_normal(frame)), 1, 4e-16) << where;
  });
}

/// Steps from a point that stay in the domain: towards four others, whole and ever smaller.
std::vector<ParameterPoint<double>> steps_from(const ParameterPoint<double>& at) {
  std::vector<ParameterPoint<double>> steps;
  for (const ParameterPoint<double>& goal :
       {ParameterPoint<double>{0.25, 0.5}, {0.6, 0.3}, {0.05, 0.9}, {0.01, 0.01}})
    for (const double factor : {1.0, 0.1, 1e-3}) steps.push_back(factor * (goal - at));
  return steps;
}

TEST(Chart, ChordAgreesWithThePointsAndNormalsOfLongDouble) {
  for_each_point([](const Chart& chart, const ChartIn<Long>& formula, const ParameterPoint<double>& at,
                    const std::string& where) {
    for (const ParameterPoint<double>& w : steps_from(at)) {
      if (w.s == 0 && w.t == 0) continue;
      const Chord<double> chord = chart.in<double>().chord(at, w);
      const Frame<Long> p = formula.frame({at.s, at.t});
      const Frame<Long> q = formula.frame({static_cast<Long>(at.s) + w.s, static_cast<Long>(at.t) + w.t});
      const Vector<Long> difference = q.point - p.point;
      const Long length = norm(difference);
      const Long step = std::hypot(static_cast<Long>(w.s), static_cast<Long>(w.t));
      // Long double loses what it must in the difference and in the products; the chord loses nothing.
      const Long lost = 4e-19L * (1 + norm(p.point)) / length;
      EXPECT_LE(norm(widened(chord.difference) - difference), (8e-15L + lost) * length)
          << where << " step " << step;
      const Long depth_p = dot(difference, unit_normal(p));
      const Long depth_q = -dot(difference, unit_normal(q));
      const Long bends = norm(widened(chord.bend_p)) + norm(widened(chord.bend_q));
      EXPECT_LE(std::abs(dot(widened(chord.bend_p), unit_normal(p)) - depth_p),
                2e-14L * bends + lost * length)
          << where << " step " << step;
      EXPECT_LE(std::abs(dot(widened(chord.bend_q), unit_normal(q)) - depth_q),
                2e-14L * bends + lost * length)
          << where << " step " << step;
    }
  });
}

TEST(Chart, ChordOfASmallStepIsTheDifferentialAndHalfTheSecondOne) {
  for_each_point([](const Chart& chart, const ChartIn<Long>&, const ParameterPoint<double>& at,
                    const std::string& where) {
    if (chart.facts().singular == SingularLine::s_zero && at.s < 0.1) return;
    const ParameterPoint<double> direction{0.3 - at.s, 0.25 - at.t};
    const double tiny = 0x1p-60;
    const Chord<double> chord = chart.in<double>().chord(at, tiny * direction);
    const Frame<double> frame = chart.in<double>().frame(at);
    const Vector<double> differential = direction.s * frame.tangent_s + direction.t * frame.tangent_t;
    EXPECT_LE(norm((1 / tiny) * chord.difference - differential),
              4e-15 * (norm(frame.tangent_s) + norm(frame.tangent_t)))
        << where;
    const Chord<double> larger = chart.in<double>().chord(at, 0x1p-40 * direction);
    const Vector<double> bend = (1 / (tiny * tiny)) * chord.bend_p;
    EXPECT_LE(norm(bend - 0x1p80 * larger.bend_p), 1e-10 * (1 + norm(bend)))
        << where << ": the bend goes with the square";
    EXPECT_LE(norm(bend - (1 / (tiny * tiny)) * chord.bend_q), 1e-10 * (1 + norm(bend)))
        << where << ": both ends alike";
  });
}

}  // namespace
}  // namespace radcert
