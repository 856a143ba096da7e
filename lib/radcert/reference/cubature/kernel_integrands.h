// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <variant>

#include "radcert/geometry/vector.h"
#include "radcert/reference/cubature/square_maps.h"
#include "radcert/reference/polygon.h"
#include "radcert/scalar/pack.h"
#include "radcert/scalar/real.h"
#include "radcert/surface/chart.h"
#include "radcert/surface/chord.h"

namespace radcert::reference {

/// The unit roundoff of double, 2^-53.
inline constexpr double roundoff = unit_roundoff<double>();

/// The integrand of the operator at eight points, but for the density.
/// Maths     the points, and G J there, J the area element
/// Source    [ac98, (2)]
/// Result    kernel rounded, with an absolute error of at most `noise` to first order, beside a few units in
///           its last place
struct Samples {
  ParameterPoint<Pack> at;
  Vector<Pack> point;
  Pack kernel;
  Pack noise;
};

/// Where an integrand looks: a chart whose parameters are counted from an apex.
/// Maths     at(w) = apex + w
/// Requires  apex and apex + w in the chart's domain up to rounding
/// Result    parameters in the unit square, also where rounding had carried them out of it
struct Target {
  std::size_t chart;
  Parameters apex;

  ParameterPoint<Pack> at(const ParameterPoint<Pack>& w) const {
    return {min(max(apex.s + w.s, 0.0), 1.0), min(max(apex.t + w.t, 0.0), 1.0)};
  }
};

/// a . b with two of its three sums fused.
inline Pack fused_dot(const Vector<Pack>& a, const Vector<Pack>& b) {
  return fma(a.x, b.x, fma(a.y, b.y, a.z * b.z));
}

/// |x_1| + |x_2| + |x_3|, which bounds the length from above.
inline Pack taxicab_norm(const Vector<Pack>& x) { return abs(x.x) + abs(x.y) + abs(x.z); }

/// A vector of doubles, eight times.
inline Vector<Pack> broadcast(const Vector<double>& x) { return {x.x, x.y, x.z}; }

/// a + c b.
inline Vector<Pack> along(const Vector<Pack>& a, const Pack& c, const Vector<Pack>& b) {
  return {fma(c, b.x, a.x), fma(c, b.y, a.y), fma(c, b.z, a.z)};
}

/// G J on another chart than P's, a flat one.
/// Maths     Q - P = offset + DF w;  (P-Q).n_Q J = height is constant
/// Source    [ac98, (2)]
/// Requires  P off the point; offset = F(apex) - P with an error of at most offset_error
/// Result    see Samples; no digits are lost beside those that the offset has lost
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

  /// The terms that are constant along a line.
  class OnLine {
  public:
    OnLine(const FlatIntegrand& f, const Line<double>& line)
        : f_(f),
          base_({line.base.s, line.base.t}),
          direction_({line.direction.s, line.direction.t}),
          start_(broadcast(f.offset + (line.base.s * f.tangent_s + line.base.t * f.tangent_t))),
          step_(broadcast(line.direction.s * f.tangent_s + line.direction.t * f.tangent_t)) {}

    Samples operator()(const Pack& r) const {
      Samples q;
      q.at = f_.target.at({fma(r, direction_.s, base_.s), fma(r, direction_.t, base_.t)});
      q.point = along(along(broadcast(f_.origin), q.at.s, broadcast(f_.tangent_s)), q.at.t,
                      broadcast(f_.tangent_t));
      const Vector<Pack> d = along(start_, r, step_);
      const Pack squared = fused_dot(d, d);
      const Pack cosine_p = fused_dot(d, broadcast(f_.normal_p));
      const Pack weight = 1.0 / (squared * squared);
      const Pack shift = fma(taxicab_norm(d), 4 * roundoff, f_.offset_error);
      q.kernel = cosine_p * f_.height * weight;
      q.noise = 2.0 * shift * weight * fma(f_.area, abs(cosine_p) + shift, std::abs(f_.height));
      return q;
    }

  private:
    const FlatIntegrand& f_;
    ParameterPoint<Pack> base_;
    ParameterPoint<Pack> direction_;
    Vector<Pack> start_;
    Vector<Pack> step_;
  };
  OnLine on(const Line<double>& line) const { return {*this, line}; }
};

/// The points w = base + r direction of a line.
class ParametersOnLine {
public:
  explicit ParametersOnLine(const Line<double>& line)
      : base_({line.base.s, line.base.t}), direction_({line.direction.s, line.direction.t}) {}
  ParameterPoint<Pack> operator()(const Pack& r) const {
    return {fma(r, direction_.s, base_.s), fma(r, direction_.t, base_.t)};
  }

private:
  ParameterPoint<Pack> base_;
  ParameterPoint<Pack> direction_;
};

/// G J on another chart than P's, a curved one.
/// Maths     Q - P = F(apex + w) - P
/// Source    [ac98, (2)]
/// Requires  P off the point
/// Result    see Samples
/// Limits    points of space are subtracted: near P the noise grows like u |P| / distance
struct CurvedIntegrand {
  Target target;
  const ChartIn<Pack>* chart;
  Vector<double> p;
  Vector<double> normal_p;
  double size_of_p;

  auto on(const Line<double>& line) const {
    return [this, w = ParametersOnLine(line)](const Pack& r) {
      Samples q;
      q.at = target.at(w(r));
      const Frame<Pack> frame = chart->frame(q.at);
      q.point = frame.point;
      const Vector<Pack> d = frame.point - broadcast(p);
      const Pack squared = fused_dot(d, d);
      const Pack weight = 1.0 / (squared * squared);
      const Pack cosine_p = fused_dot(d, broadcast(normal_p));
      const Pack cosine_q = -fused_dot(d, frame.area_normal);
      const Pack area = area_element(frame);
      const Pack reach =
          fma(taxicab_norm(frame.tangent_s), q.at.s,
              fma(taxicab_norm(frame.tangent_t), q.at.t, fma(sqrt(squared), 2.0, norm(frame.point))));
      const Pack shift = 2 * roundoff * (size_of_p + reach);
      q.kernel = cosine_p * cosine_q * weight;
      q.noise = shift * weight * fma(area, abs(cosine_p) + shift, abs(cosine_q));
      return q;
    };
  }
};

/// G J on P's own chart.
/// Maths     Q - P and its parts along either normal by divided differences, see Chord
/// Source    [ac98, (5)-(6)]
/// Requires  apex + w off P
/// Result    see Samples; no digits are lost up to the diagonal
struct ChordIntegrand {
  Target target;
  const ChartIn<Pack>* chart;
  Parameters p;
  Parameters offset;  // apex - p
  Vector<double> normal_p;

  auto on(const Line<double>& line) const {
    return [this, w = ParametersOnLine(line)](const Pack& r) {
      // Rounding must not carry the point over the border of the domain: a power has no value beyond its
      // singular line.
      const ParameterPoint<Pack> from_apex = w(r);
      const ParameterPoint<Pack> step{min(max(offset.s + from_apex.s, -p.s), 1 - p.s),
                                      min(max(offset.t + from_apex.t, -p.t), 1 - p.t)};
      Samples q;
      q.at = {p.s + step.s, p.t + step.t};
      const Frame<Pack> frame = chart->frame(q.at);
      const Chord<Pack> chord = chart->chord({p.s, p.t}, step);
      q.point = frame.point;
      const Pack inverse = 1.0 / fused_dot(chord.difference, chord.difference);
      const Pack bend_p = fused_dot(chord.bend_p, broadcast(normal_p)) * inverse;
      const Pack bend_q = fused_dot(chord.bend_q, frame.area_normal) * inverse;
      const Pack spread = fma(taxicab_norm(chord.bend_p), abs(bend_q),
                              taxicab_norm(chord.bend_q) * taxicab_norm(frame.area_normal) * abs(bend_p));
      q.kernel = bend_p * bend_q;
      q.noise = 4 * roundoff * spread * inverse;
      return q;
    };
  }
};

/// Any of them.
using Integrand = std::variant<FlatIntegrand, CurvedIntegrand, ChordIntegrand>;

}  // namespace radcert::reference
