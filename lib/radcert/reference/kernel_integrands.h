// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "radcert/geometry/vector.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/reference/polygon.h"
#include "radcert/scalar/real.h"
#include "radcert/surface/chart.h"
#include "radcert/surface/chord.h"

namespace radcert::reference {

inline constexpr double roundoff = unit_roundoff<double>();

/// The integrand of the operator at one point.
/// Maths     G J u, J the area element
/// Source    [ac98, (2)]
/// Requires  -
/// Result    value rounded, with an absolute error of at most `noise` to first order, beside a few units in its last place
/// Limits    -
struct Sample {
  double value;
  double noise;  // a bound for its rounding beside the relative one
};

/// Where an integrand looks: the density, and a chart whose parameters are counted from an apex.
/// Maths     at(w) = apex + w
/// Source    -
/// Requires  apex and apex + w in the chart's domain up to rounding; a density that outlives this
/// Result    parameters in the unit square, also where rounding had carried them out of it
/// Limits    -
struct Target {
  const Density* density;
  std::size_t chart;
  ChartDomain domain;
  Parameters apex;

  Parameters at(const Parameters& w) const {
    const Parameters sum = apex + w;
    return {std::clamp(sum.s, 0.0, 1.0), std::clamp(sum.t, 0.0, 1.0)};
  }
  double u(const Parameters& at, const Vector<double>& point) const { return (*density)({chart, at}, point); }
};

/// G J u on another chart than P's, a flat one.
/// Maths     Q - P = offset + DF w;  (P-Q).n_Q J = height is constant
/// Source    [ac98, (2)]
/// Requires  P off the point; offset = F(apex) - P with an error of at most offset_error
/// Result    see Sample; no digits are lost beside those that the offset has lost
/// Limits    -
struct FlatIntegrand {
  Target target;
  Vector<double> origin;  // F(0,0)
  Vector<double> tangent_s;
  Vector<double> tangent_t;
  Vector<double> normal_p;
  Vector<double> offset;  // F(apex) - P
  double height;          // (P-Q).n_Q J
  double area;            // J
  double offset_error;    // of `offset`

  Sample operator()(const Parameters& w) const {
    const Vector<double> d = offset + (w.s * tangent_s + w.t * tangent_t);
    const double squared = dot(d, d);
    const double cosine_p = dot(d, normal_p);
    const Parameters at = target.at(w);
    const double weight = target.u(at, origin + (at.s * tangent_s + at.t * tangent_t)) / (squared * squared);
    const double shift = offset_error + 4 * roundoff * std::sqrt(squared);
    return {cosine_p * height * weight,
            2 * shift * (area * std::abs(cosine_p) + std::abs(height) + area * shift) * std::abs(weight)};
  }
};

/// G J u on another chart than P's, a curved one.
/// Maths     Q - P = F(apex + w) - P
/// Source    [ac98, (2)]
/// Requires  P off the point
/// Result    see Sample
/// Limits    points of space are subtracted: near P the noise grows like u |P| / distance
struct CurvedIntegrand {
  Target target;
  const ChartIn<double>* chart;
  Vector<double> p;
  Vector<double> normal_p;
  double size_of_p;

  Sample operator()(const Parameters& w) const {
    const Parameters at = target.at(w);
    const Frame<double> frame = chart->frame(at);
    const Vector<double> d = frame.point - p;
    const double squared = dot(d, d);
    const double weight = target.u(at, frame.point) / (squared * squared);
    const double cosine_p = dot(d, normal_p);
    const double cosine_q = -dot(d, frame.area_normal);
    const double area = area_element(frame);
    const double shift = 2 * roundoff *
                         (size_of_p + norm(frame.point) + norm(frame.tangent_s) * at.s +
                          norm(frame.tangent_t) * at.t + 2 * std::sqrt(squared));
    return {cosine_p * cosine_q * weight,
            shift * (area * std::abs(cosine_p) + std::abs(cosine_q) + area * shift) * std::abs(weight)};
  }
};

/// |x_1| + |x_2| + |x_3|, which bounds the length from above.
inline double taxicab_norm(const Vector<double>& x) { return std::abs(x.x) + std::abs(x.y) + std::abs(x.z); }

/// G J u on P's own chart.
/// Maths     Q - P and its parts along either normal by divided differences, see Chord
/// Source    [ac98, (5)-(6)]
/// Requires  apex + w off P
/// Result    see Sample; no digits are lost up to the diagonal
/// Limits    -
struct ChordIntegrand {
  Target target;
  const ChartIn<double>* chart;
  Parameters p;
  Parameters offset;  // apex - p
  Vector<double> normal_p;

  Sample operator()(const Parameters& w) const {
    // Rounding must not carry the point over the border of the domain: a power has no value beyond its singular line.
    const Parameters step{std::clamp(offset.s + w.s, -p.s, 1 - p.s),
                          std::clamp(offset.t + w.t, -p.t, 1 - p.t)};
    const Parameters at = p + step;
    const Frame<double> frame = chart->frame(at);
    const Chord<double> chord = chart->chord(p, step);
    const double value = target.u(at, frame.point);
    const double squared = dot(chord.difference, chord.difference);
    const double bend_p = dot(chord.bend_p, normal_p) / squared;
    const double bend_q = dot(chord.bend_q, frame.area_normal) / squared;
    const double spread = taxicab_norm(chord.bend_p) * std::abs(bend_q) +
                          taxicab_norm(chord.bend_q) * area_element(frame) * std::abs(bend_p);
    return {bend_p * bend_q * value, 4 * roundoff * spread / squared * std::abs(value)};
  }
};

}  // namespace radcert::reference
