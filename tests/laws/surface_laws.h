// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "radcert/scalar/pack.h"
#include "radcert/surface/surface.h"

namespace radcert::laws {

/// Points of a chart's domain: corners, sides and inside.
inline std::vector<ParameterPoint<double>> points_of_the_domain(ChartDomain domain) {
  std::vector<ParameterPoint<double>> points;
  for (const double s : {0.0, 0.015625, 0.25, 0.5, 0.875, 1.0})
    for (const double t : {0.0, 0.03125, 0.375, 0.5, 1.0})
      points.push_back({s, domain == ChartDomain::unit_square ? t : t * (1 - s)});
  return points;
}

namespace detail {

inline std::string text(const Chart& chart, const ParameterPoint<double>& at) {
  return chart.facts().name + " at (" + std::to_string(at.s) + ", " + std::to_string(at.t) + ")";
}

}  // namespace detail

/// Charts have different names, pieces and domains are named, and there is a diagonal a chart.
inline ::testing::AssertionResult is_fully_described(const Surface& surface) {
  if (surface.charts.empty()) return ::testing::AssertionFailure() << "no charts";
  if (surface.diagonals.size() != surface.charts.size())
    return ::testing::AssertionFailure() << surface.diagonals.size() << " diagonals";
  std::set<std::string> names;
  for (const Chart& chart : surface.charts) {
    if (chart.facts().piece.empty()) return ::testing::AssertionFailure() << "a chart of no piece";
    if (!names.insert(chart.facts().name).second)
      return ::testing::AssertionFailure() << "two charts are called " << chart.facts().name;
  }
  return ::testing::AssertionSuccess();
}

/// In packs a chart has the bits that it has in double.
inline ::testing::AssertionResult has_the_same_bits_in_packs(const Surface& surface) {
  for (const Chart& chart : surface.charts) {
    const std::vector<ParameterPoint<double>> points = points_of_the_domain(chart.facts().domain);
    for (std::size_t first = 0; first < points.size(); ++first) {
      ParameterPoint<Pack> at{0, 0};
      for (std::size_t i = 0; i < Pack::lanes; ++i) {
        at.s.set_lane(i, points[(first + i) % points.size()].s);
        at.t.set_lane(i, points[(first + i) % points.size()].t);
      }
      const ParameterPoint<Pack> step{Pack(points[first].s) - at.s, Pack(points[first].t) - at.t};
      const Frame<Pack> frame = chart.in<Pack>().frame(at);
      const Chord<Pack> chord = chart.in<Pack>().chord(at, step);
      for (std::size_t i = 0; i < Pack::lanes; ++i) {
        const auto lane = [i](const Vector<Pack>& v) {
          return Vector<double>{v.x.lane(i), v.y.lane(i), v.z.lane(i)};
        };
        const ParameterPoint<double> here{at.s.lane(i), at.t.lane(i)};
        const Frame<double> f = chart.in<double>().frame(here);
        const Chord<double> c = chart.in<double>().chord(here, {step.s.lane(i), step.t.lane(i)});
        const bool same = lane(frame.point) == f.point && lane(frame.tangent_s) == f.tangent_s &&
                          lane(frame.tangent_t) == f.tangent_t && lane(frame.area_normal) == f.area_normal &&
                          lane(chord.difference) == c.difference && lane(chord.bend_p) == c.bend_p &&
                          lane(chord.bend_q) == c.bend_q;
        if (!same) return ::testing::AssertionFailure() << "other bits on " << detail::text(chart, here);
      }
    }
  }
  return ::testing::AssertionSuccess();
}

/// The area normal is +-(D_s F x D_t F), with the sign of the chart's orientation, and nowhere 0.
inline ::testing::AssertionResult has_normals_across_its_tangents(const Surface& surface, double tolerance) {
  for (const Chart& chart : surface.charts)
    for (const ParameterPoint<double>& at : points_of_the_domain(chart.facts().domain)) {
      const Frame<double> frame = chart.in<double>().frame(at);
      const double sign = chart.facts().orientation == Orientation::along_the_cross_product ? 1 : -1;
      const Vector<double> expected = sign * cross(frame.tangent_s, frame.tangent_t);
      const double scale = norm(frame.tangent_s) * norm(frame.tangent_t);
      if (!(norm(frame.area_normal) > 1e-8 * scale))
        return ::testing::AssertionFailure() << "no normal on " << detail::text(chart, at);
      if (!(norm(frame.area_normal - expected) <= tolerance * scale))
        return ::testing::AssertionFailure() << "another normal on " << detail::text(chart, at);
    }
  return ::testing::AssertionSuccess();
}

/// The tangents are the derivatives of the point: a difference quotient of width `step` is as near as step
/// allows.
inline ::testing::AssertionResult has_tangents_that_are_derivatives(const Surface& surface, double step,
                                                                    double tolerance) {
  for (const Chart& chart : surface.charts) {
    const ChartIn<double>& formula = chart.in<double>();
    for (ParameterPoint<double> at : points_of_the_domain(chart.facts().domain)) {
      // Into the interior, so that the quotient stays in the domain.
      const double centre = chart.facts().domain == ChartDomain::unit_square ? 0.5 : 1.0 / 3;
      at = {0.75 * at.s + 0.25 * centre, 0.75 * at.t + 0.25 * centre};
      const Frame<double> frame = formula.frame(at);
      const auto quotient = [&](const ParameterPoint<double>& w) {
        return (1 / (2 * step)) * (formula.frame(at + w).point - formula.frame(at - w).point);
      };
      const double wrong =
          std::max(norm(quotient({step, 0}) - frame.tangent_s), norm(quotient({0, step}) - frame.tangent_t));
      if (!(wrong <= tolerance * (1 + norm(frame.point) + norm(frame.tangent_s) + norm(frame.tangent_t))))
        return ::testing::AssertionFailure()
               << "a tangent is " << wrong << " off on " << detail::text(chart, at);
    }
  }
  return ::testing::AssertionSuccess();
}

/// Every tangent plane has the whole surface on the side of the normal: S lies in the boundary of a convex
/// body, and normals point inwards.
inline ::testing::AssertionResult lies_inside_its_tangent_planes(const Surface& surface, double tolerance) {
  std::vector<Vector<double>> points;
  for (const Chart& chart : surface.charts)
    for (const ParameterPoint<double>& at : points_of_the_domain(chart.facts().domain))
      points.push_back(chart.in<double>().frame(at).point);
  for (const Chart& chart : surface.charts)
    for (const ParameterPoint<double>& at : points_of_the_domain(chart.facts().domain)) {
      const Frame<double> frame = chart.in<double>().frame(at);
      const Vector<double> normal = unit_normal(frame);
      double deepest = 0;
      for (const Vector<double>& q : points) {
        const double depth = dot(q - frame.point, normal);
        if (!(depth >= -tolerance * (1 + norm(q))))
          return ::testing::AssertionFailure()
                 << "a point lies " << -depth << " behind " << detail::text(chart, at);
        deepest = std::max(deepest, depth);
      }
      if (!(deepest > tolerance))
        return ::testing::AssertionFailure() << "nothing lies before " << detail::text(chart, at);
    }
  return ::testing::AssertionSuccess();
}

/// The vector Int n dS vanishes on a closed surface. Midpoints of `cells`^2 cells a chart: the tolerance is
/// theirs.
inline ::testing::AssertionResult has_a_vanishing_integral_of_its_normal(const Surface& surface, int cells,
                                                                         double tolerance) {
  Vector<double> sum{};
  double area = 0;
  for (const Chart& chart : surface.charts)
    for (int i = 0; i < cells; ++i)
      for (int j = 0; j < cells; ++j) {
        ParameterPoint<double> at{(i + 0.5) / cells, (j + 0.5) / cells};
        double weight = 1.0 / (cells * cells);
        if (chart.facts().domain == ChartDomain::unit_triangle) {
          weight *= 1 - at.s;
          at.t *= 1 - at.s;
        }
        const Vector<double> normal = chart.in<double>().frame(at).area_normal;
        sum = sum + weight * normal;
        area += weight * norm(normal);
      }
  if (!(norm(sum) <= tolerance * area))
    return ::testing::AssertionFailure() << "the integral of the normal has the length " << norm(sum);
  return ::testing::AssertionSuccess();
}

/// All of the above, as far as the surface's own facts ask for them.
inline ::testing::AssertionResult obeys_the_surface_laws(const Surface& surface) {
  const std::vector<::testing::AssertionResult> results{
      is_fully_described(surface),
      has_normals_across_its_tangents(surface, 4e-16),
      has_tangents_that_are_derivatives(surface, 1e-5, 1e-9),
      has_the_same_bits_in_packs(surface),
      surface.unoccluded ? lies_inside_its_tangent_planes(surface, 1e-14) : ::testing::AssertionSuccess(),
      surface.closed ? has_a_vanishing_integral_of_its_normal(surface, 64, 1e-3)
                     : ::testing::AssertionSuccess()};
  for (const ::testing::AssertionResult& result : results)
    if (!result) return result;
  return ::testing::AssertionSuccess();
}

}  // namespace radcert::laws
