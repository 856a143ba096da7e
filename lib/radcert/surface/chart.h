// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "radcert/geometry/plane.h"
#include "radcert/geometry/vector.h"
#include "radcert/scalar/divided_difference.h"
#include "radcert/scalar/dual.h"
#include "radcert/surface/chord.h"

namespace radcert {

/// The side of the surface that the inner normal takes, relative to D_s F x D_t F.
enum class Orientation { along_the_cross_product = 1, against_the_cross_product = -1 };

/// What a chart knows at one parameter point.
/// Maths     point = F(s,t);  area_normal = +-(D_s F x D_t F), the inner normal with the length of the area element
/// Source    [ac98, (14), (30)]
/// Requires  -
/// Result    rounded as R rounds; tangents by forward differentiation
/// Limits    area_normal vanishes where the chart degenerates; the catalogue has no such chart
template <Field R>
struct Frame {
  Vector<R> point;
  Vector<R> tangent_s;
  Vector<R> tangent_t;
  Vector<R> area_normal;
};

/// The unit inner normal n_P of a frame.
template <Real R>
Vector<R> unit_normal(const Frame<R>& frame) {
  return (R(1) / norm(frame.area_normal)) * frame.area_normal;
}

/// The area element |D_s F x D_t F| of a frame.
template <Real R>
R area_element(const Frame<R>& frame) {
  return norm(frame.area_normal);
}

/// A chart's formula in one arithmetic.
/// Maths     F, its tangents and its divided differences
/// Source    [ac98, (14)]
/// Requires  (s,t) in the chart's domain
/// Result    see Frame and Chord
/// Limits    the only virtual call between a formula and the loops that use it; one call serves one point
template <Real R>
class ChartIn {
public:
  virtual ~ChartIn() = default;
  virtual Frame<R> frame(const ParameterPoint<R>& at) const = 0;
  virtual Chord<R> chord(const ParameterPoint<R>& p, const ParameterPoint<R>& w) const = 0;
};

/// The corners of the convex polygon R_j over which a chart is defined.
enum class ChartDomain {
  unit_square,    ///< 0 <= s, t <= 1
  unit_triangle,  ///< 0 <= s, t, s + t <= 1
};

/// A line of the parameter plane on which a chart is not analytic.
enum class SingularLine { none, s_zero };

/// What is known of a chart beside its formula.
struct ChartFacts {
  std::string name;   ///< unique in its surface
  std::string piece;  ///< the smooth piece it belongs to; charts of one piece join smoothly
  ChartDomain domain = ChartDomain::unit_square;
  Orientation orientation = Orientation::along_the_cross_product;
  std::optional<Plane> plane = std::nullopt;  ///< set exactly if the chart is affine: then G vanishes on it
  SingularLine singular = SingularLine::none;
};

/// One smooth patch of a surface: facts, and a formula in every arithmetic that radcert compiles.
/// Maths     F_j : R_j -> S_j one-to-one and onto, R_j a closed convex polygon
/// Source    [ac98, (13)-(14)]
/// Requires  F_j twice continuously differentiable off its singular line
/// Result    immutable; safe to share between threads
/// Limits    arithmetics: double
class Chart {
public:
  Chart(ChartFacts facts, std::shared_ptr<const ChartIn<double>> in_double)
      : facts_(std::move(facts)), in_double_(std::move(in_double)) {}

  const ChartFacts& facts() const { return facts_; }
  template <Real R>
  const ChartIn<R>& in() const;

private:
  ChartFacts facts_;
  std::shared_ptr<const ChartIn<double>> in_double_;
};

template <>
inline const ChartIn<double>& Chart::in<double>() const {
  return *in_double_;
}

/// A chart's formula, differentiated.
/// Maths     Formula<R> is a class with  template <Field T> Vector<T> operator()(const T& s, const T& t) const;  here T is
///           Dual<R> for the tangents and DividedDifference<R> for the chord
/// Source    design: derivatives by forward differentiation
/// Requires  the formula uses + - * / sqrt power on T and constants of type R
/// Result    see Frame and Chord
/// Limits    -
template <Real R, class Formula>
class ChartOf final : public ChartIn<R> {
public:
  ChartOf(Formula formula, Orientation orientation)
      : formula_(std::move(formula)), sign_(orientation == Orientation::along_the_cross_product ? 1 : -1) {}

  Frame<R> frame(const ParameterPoint<R>& at) const override {
    const Vector<Dual<R>> f = formula_(Dual<R>{at.s, R(1), R(0)}, Dual<R>{at.t, R(0), R(1)});
    Frame<R> frame;
    frame.point = {f.x.value, f.y.value, f.z.value};
    frame.tangent_s = {f.x.by_s, f.y.by_s, f.z.by_s};
    frame.tangent_t = {f.x.by_t, f.y.by_t, f.z.by_t};
    frame.area_normal = sign_ * cross(frame.tangent_s, frame.tangent_t);
    return frame;
  }

  Chord<R> chord(const ParameterPoint<R>& p, const ParameterPoint<R>& w) const override {
    using D = DividedDifference<R>;
    const Vector<D> f = formula_(D::variable(p.s, w.s, R(1)), D::variable(p.t, w.t, R(1)));
    return {.difference = {f.x.first, f.y.first, f.z.first},
            .bend_p = {f.x.second_p, f.y.second_p, f.z.second_p},
            .bend_q = {f.x.second_q, f.y.second_q, f.z.second_q}};
  }

private:
  Formula formula_;
  R sign_;
};

/// A chart from a formula template and its exact parameters, in every arithmetic that radcert compiles.
/// Maths     Formula<R>(parameters...) for each R
/// Source    design: one formula, several arithmetics
/// Requires  Formula<R> constructible from the Rational parameters
/// Result    a Chart
/// Limits    a new arithmetic is added here, once
template <template <class> class Formula, class... Parameters>
Chart make_chart(ChartFacts facts, const Parameters&... parameters) {
  auto in_double =
      std::make_shared<ChartOf<double, Formula<double>>>(Formula<double>(parameters...), facts.orientation);
  return Chart(std::move(facts), std::move(in_double));
}

}  // namespace radcert
