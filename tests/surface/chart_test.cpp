// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/chart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "radcert/scalar/mpfr_real.h"
#include "tests/surface/sample_surfaces.h"

namespace radcert {
namespace {

using testing::sample_points;
using testing::sample_surfaces;
using testing::SampleSurface;
/// Of the truth.
using Long = Mpfr<50>;

Vector<Long> widened(const Vector<double>& x) { return {Long(x.x), Long(x.y), Long(x.z)}; }
ParameterPoint<Long> widened(const ParameterPoint<double>& at) { return {Long(at.s), Long(at.t)}; }
double size(const Vector<Long>& x) { return norm(x).to_double(); }

/// Calls the visitor with each chart, its formula in 50 digits, and each of its sample points.
void for_each_point(
    const std::function<void(const Chart&, const ChartIn<Long>&, const ParameterPoint<double>&,
                             const std::string& where)>& visit) {
  for (const SampleSurface& sample : sample_surfaces()) {
    const Surface surface = sample.make();
    for (std::size_t j = 0; j < surface.chart_count(); ++j)
      for (const ParameterPoint<double>& at : sample_points(surface.charts[j].facts().domain))
        visit(surface.charts[j], surface.charts[j].in<Long>(), at,
              sample.entry + " " + surface.charts[j].facts().name + " " + std::to_string(at.s) + " " +
                  std::to_string(at.t));
  }
}

TEST(Chart, FrameAgreesWithFiftyDigits) {
  for_each_point([](const Chart& chart, const ChartIn<Long>& formula, const ParameterPoint<double>& at,
                    const std::string& where) {
    const Frame<double> frame = chart.in<double>().frame(at);
    const Frame<Long> truth = formula.frame(widened(at));
    EXPECT_LE(size(widened(frame.point) - truth.point), 4e-16 * (1 + size(truth.point))) << where;
    EXPECT_LE(size(widened(frame.tangent_s) - truth.tangent_s), 1e-15 * (1 + size(truth.tangent_s))) << where;
    EXPECT_LE(size(widened(frame.tangent_t) - truth.tangent_t), 1e-15 * (1 + size(truth.tangent_t))) << where;
    EXPECT_LE(size(widened(frame.area_normal) - truth.area_normal),
              2e-15 * (1 + size(truth.tangent_s) * size(truth.tangent_t)))
        << where;
  });
}

TEST(Chart, TangentsAreDerivatives) {
  for_each_point([](const Chart& chart, const ChartIn<Long>& formula, const ParameterPoint<double>& at,
                    const std::string& where) {
    if (chart.facts().singular == SingularLine::s_zero && at.s < 0.1) return;
    const Long h(0x1p-40);
    const Long none;
    // Formulas go on a little beyond their domain, except at a singular line.
    const Frame<Long> frame = formula.frame(widened(at));
    const auto point = [&](const Long& s, const Long& t) {
      return formula.frame({Long(at.s) + s, Long(at.t) + t}).point;
    };
    const Long factor = Long(1) / (Long(2) * h);
    const Vector<Long> by_s = factor * (point(h, none) - point(-h, none));
    const Vector<Long> by_t = factor * (point(none, h) - point(none, -h));
    EXPECT_LE(size(by_s - frame.tangent_s), 1e-20 * (1 + size(by_s))) << where;
    EXPECT_LE(size(by_t - frame.tangent_t), 1e-20 * (1 + size(by_t))) << where;
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

TEST(Chart, ChordAgreesWithThePointsAndNormalsOfFiftyDigits) {
  for_each_point([](const Chart& chart, const ChartIn<Long>& formula, const ParameterPoint<double>& at,
                    const std::string& where) {
    const Frame<Long> p = formula.frame(widened(at));
    for (const ParameterPoint<double>& w : steps_from(at)) {
      if (w.s == 0 && w.t == 0) continue;
      const Chord<double> chord = chart.in<double>().chord(at, w);
      const Frame<Long> q = formula.frame(widened(at) + widened(w));
      const Vector<Long> difference = q.point - p.point;
      const std::string step = where + " step " + std::to_string(w.s) + " " + std::to_string(w.t);
      EXPECT_LE(size(widened(chord.difference) - difference), 8e-15 * size(difference)) << step;
      const Long depth_p = dot(difference, unit_normal(p));
      const Long depth_q = -dot(difference, unit_normal(q));
      // What 50 digits leave of the depths.
      const double lost = 1e-48 * size(difference);
      const double bends = norm(chord.bend_p) + norm(chord.bend_q);
      EXPECT_LE(abs(dot(widened(chord.bend_p), unit_normal(p)) - depth_p).to_double(), 2e-14 * bends + lost)
          << step;
      EXPECT_LE(abs(dot(widened(chord.bend_q), unit_normal(q)) - depth_q).to_double(), 2e-14 * bends + lost)
          << step;
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
