// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/geometry/plane.h"
#include "radcert/geometry/vector.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/complex_ball.h"
#include "radcert/scalar/dual.h"
#include "radcert/scalar/functions/divided_difference.h"
#include "radcert/scalar/functions/taylor_model.h"
#include "radcert/scalar/mpfr_real.h"
#include "radcert/scalar/pack.h"
#include "radcert/surface/chart_structure.h"
#include "radcert/surface/chord.h"

namespace radcert {

/// The side of the surface that the inner normal takes, relative to D_s F x D_t F.
enum class Orientation { along_the_cross_product = 1, against_the_cross_product = -1 };

/// The point of a chart at one parameter point, and its tangents.
/// Maths     point = F(s,t);  area_normal = +-(D_s F x D_t F), the inner normal with the length of the area
///           element
/// Source    [ac98, (14), (30)]
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
  /// chord(p, step direction) with the step divided out: difference / step, bend_p / step^2, bend_q / step^2.
  /// Step = 0 has a value, and chord_kernel of it is the limit of G along the direction. ContractViolation
  /// where the chart does not offer it.
  virtual Chord<R> chord_along(const ParameterPoint<R>& p, const ParameterPoint<R>& direction,
                               const R& step) const {
    static_cast<void>(p), static_cast<void>(direction), static_cast<void>(step);
    expects(false, "a chart with chords along rays");
    return {};
  }
};

/// A chart known in double only, taken into packs lane by lane.
/// Maths     that of the chart
/// Result    the bits of the chart in double
/// Limits    slow: a call a lane; `make_chart` gives packs a formula of their own
class ChartByLane final : public ChartIn<Pack> {
public:
  explicit ChartByLane(std::shared_ptr<const ChartIn<double>> chart) : chart_(std::move(chart)) {}

  Frame<Pack> frame(const ParameterPoint<Pack>& at) const override {
    Frame<Pack> result;
    for (std::size_t i = 0; i < Pack::lanes; ++i) {
      const Frame<double> f = chart_->frame({at.s.lane(i), at.t.lane(i)});
      set(result.point, i, f.point);
      set(result.tangent_s, i, f.tangent_s);
      set(result.tangent_t, i, f.tangent_t);
      set(result.area_normal, i, f.area_normal);
    }
    return result;
  }

  Chord<Pack> chord(const ParameterPoint<Pack>& p, const ParameterPoint<Pack>& w) const override {
    Chord<Pack> result;
    for (std::size_t i = 0; i < Pack::lanes; ++i) {
      const Chord<double> c = chart_->chord({p.s.lane(i), p.t.lane(i)}, {w.s.lane(i), w.t.lane(i)});
      set(result.difference, i, c.difference);
      set(result.bend_p, i, c.bend_p);
      set(result.bend_q, i, c.bend_q);
    }
    return result;
  }

private:
  static void set(Vector<Pack>& to, std::size_t lane, const Vector<double>& from) {
    to.x.set_lane(lane, from.x);
    to.y.set_lane(lane, from.y);
    to.z.set_lane(lane, from.z);
  }

  std::shared_ptr<const ChartIn<double>> chart_;
};

/// The corners of the convex polygon R_j over which a chart is defined.
enum class ChartDomain {
  unit_square,    ///< 0 <= s, t <= 1
  unit_triangle,  ///< 0 <= s, t, s + t <= 1
};

/// A line of the parameter plane on which a chart is not analytic.
enum class SingularLine { none, s_zero };

/// The facts of a chart beside its formula.
struct ChartFacts {
  std::string name;  ///< unique in its surface
  /// The smooth piece it belongs to; charts of one piece join smoothly unless the surface says otherwise
  std::string piece;
  ChartDomain domain = ChartDomain::unit_square;
  Orientation orientation = Orientation::along_the_cross_product;
  std::optional<Plane> plane = std::nullopt;  ///< set exactly if the chart is affine: then G vanishes on it
  SingularLine singular = SingularLine::none;
  std::optional<Plane> plane_of_disk =
      std::nullopt;  ///< set exactly if the chart is not affine and its image flat: G vanishes there too
  ChartStructure structure = {};

  /// The plane in which the chart's image lies, if it lies in one.
  const std::optional<Plane>& flat_in() const { return plane ? plane : plane_of_disk; }
};

/// One smooth patch of a surface: facts, and a formula in every arithmetic that radcert compiles.
/// Maths     F_j : R_j -> S_j one-to-one and onto, R_j a closed convex polygon
/// Source    [ac98, (13)-(14)]
/// Requires  F_j twice continuously differentiable off its singular line
/// Result    immutable; safe to share between threads
/// Limits    arithmetics: double, Pack, Mpfr<50>, Ball, ComplexBall, TaylorModel; a chart made of a formula
///           in double alone has no digits beyond
class Chart {
public:
  Chart(ChartFacts facts, const std::shared_ptr<const ChartIn<double>>& in_double)
      : Chart(std::move(facts), in_double, std::make_shared<ChartByLane>(in_double)) {}
  Chart(ChartFacts facts, std::shared_ptr<const ChartIn<double>> in_double,
        std::shared_ptr<const ChartIn<Pack>> in_pack,
        std::shared_ptr<const ChartIn<Mpfr<50>>> in_fifty_digits = nullptr,
        std::shared_ptr<const ChartIn<Ball>> in_balls = nullptr,
        std::shared_ptr<const ChartIn<ComplexBall>> in_complex_balls = nullptr,
        std::shared_ptr<const ChartIn<TaylorModel>> in_models = nullptr)
      : facts_(std::move(facts)),
        in_double_(std::move(in_double)),
        in_pack_(std::move(in_pack)),
        in_fifty_digits_(std::move(in_fifty_digits)),
        in_balls_(std::move(in_balls)),
        in_complex_balls_(std::move(in_complex_balls)),
        in_models_(std::move(in_models)) {}

  const ChartFacts& facts() const { return facts_; }
  template <Real R>
  const ChartIn<R>& in() const;
  /// Whether in<Ball>() has a formula to give.
  bool is_known_in_balls() const { return in_balls_ != nullptr; }

private:
  ChartFacts facts_;
  std::shared_ptr<const ChartIn<double>> in_double_;
  std::shared_ptr<const ChartIn<Pack>> in_pack_;
  std::shared_ptr<const ChartIn<Mpfr<50>>> in_fifty_digits_;
  std::shared_ptr<const ChartIn<Ball>> in_balls_;
  std::shared_ptr<const ChartIn<ComplexBall>> in_complex_balls_;
  std::shared_ptr<const ChartIn<TaylorModel>> in_models_;
};

template <>
inline const ChartIn<double>& Chart::in<double>() const {
  return *in_double_;
}

template <>
inline const ChartIn<Pack>& Chart::in<Pack>() const {
  return *in_pack_;
}

template <>
inline const ChartIn<Mpfr<50>>& Chart::in<Mpfr<50>>() const {
  expects(in_fifty_digits_ != nullptr, "a chart with a formula in 50 digits", named("chart", facts_.name));
  return *in_fifty_digits_;
}

template <>
inline const ChartIn<Ball>& Chart::in<Ball>() const {
  expects(in_balls_ != nullptr, "a chart with a formula in balls", named("chart", facts_.name));
  return *in_balls_;
}

template <>
inline const ChartIn<ComplexBall>& Chart::in<ComplexBall>() const {
  expects(in_complex_balls_ != nullptr, "a chart with a formula in complex balls",
          named("chart", facts_.name));
  return *in_complex_balls_;
}

template <>
inline const ChartIn<TaylorModel>& Chart::in<TaylorModel>() const {
  expects(in_models_ != nullptr, "a chart with a formula in Taylor models", named("chart", facts_.name));
  return *in_models_;
}

namespace detail {

/// Work in an arithmetic of machine numbers with every call in it inlined: a formula's steps then stay in
/// registers.
template <class Work>
[[gnu::flatten]] auto inlined(const Work& work) {
  return work();
}

}  // namespace detail

/// A chart's formula, differentiated.
/// Maths     Formula<R> is a class with  template <Field T> Vector<T> operator()(const T& s, const T& t)
///           const;  here T is Dual<R> for the tangents and DividedDifference<R> for the chord
/// Requires  the formula uses + - * / sqrt power on T and constants of type R
/// Result    see Frame and Chord
template <Real R, class Formula>
class ChartOf final : public ChartIn<R> {
public:
  ChartOf(Formula formula, Orientation orientation)
      : formula_(std::move(formula)), sign_(orientation == Orientation::along_the_cross_product ? 1 : -1) {}

  Frame<R> frame(const ParameterPoint<R>& at) const override {
    return in_one_body([&] { return frame_at(at); });
  }

  Chord<R> chord(const ParameterPoint<R>& p, const ParameterPoint<R>& w) const override {
    return in_one_body([&] { return chord_between(p, w); });
  }

  Chord<R> chord_along(const ParameterPoint<R>& p, const ParameterPoint<R>& direction,
                       const R& step) const override {
    using D = DividedDifference<R>;
    return chord_of(formula_(D::variable(p.s, direction.s, step), D::variable(p.t, direction.t, step)));
  }

private:
  Frame<R> frame_at(const ParameterPoint<R>& at) const {
    const Vector<Dual<R>> f = formula_(Dual<R>{at.s, R(1), R(0)}, Dual<R>{at.t, R(0), R(1)});
    Frame<R> frame;
    frame.point = {f.x.value, f.y.value, f.z.value};
    frame.tangent_s = {f.x.by_s, f.y.by_s, f.z.by_s};
    frame.tangent_t = {f.x.by_t, f.y.by_t, f.z.by_t};
    frame.area_normal = sign_ * cross(frame.tangent_s, frame.tangent_t);
    return frame;
  }

  Chord<R> chord_between(const ParameterPoint<R>& p, const ParameterPoint<R>& w) const {
    using D = DividedDifference<R>;
    return chord_of(formula_(D::variable(p.s, w.s, R(1)), D::variable(p.t, w.t, R(1))));
  }

  static Chord<R> chord_of(const Vector<DividedDifference<R>>& f) {
    return {.difference = {f.x.first, f.y.first, f.z.first},
            .bend_p = {f.x.second_p, f.y.second_p, f.z.second_p},
            .bend_q = {f.x.second_q, f.y.second_q, f.z.second_q}};
  }

  /// Other arithmetics call functions of libraries at each step: inlining would cost compile time and gain
  /// none.
  template <class Work>
  static auto in_one_body(const Work& work) {
    if constexpr (std::is_same_v<R, double> || std::is_same_v<R, Pack>)
      return detail::inlined(work);
    else
      return work();
  }

  Formula formula_;
  R sign_;
};

/// A chart's formula in an arithmetic whose precision is that of the moment.
/// Maths     Formula<R>(parameters...), made anew at each call
/// Requires  as ChartOf; parameters exact
/// Result    as ChartOf: for R = Ball and ComplexBall enclosed, and as narrow as BallPrecision::current()
///           allows
/// Limits    a formula is made for each point
template <Real R, template <class> class Formula, class... Parameters>
class ChartAtAnyPrecision final : public ChartIn<R> {
public:
  ChartAtAnyPrecision(Orientation orientation, const Parameters&... parameters)
      : orientation_(orientation), parameters_(parameters...) {}

  Frame<R> frame(const ParameterPoint<R>& at) const override { return now().frame(at); }
  Chord<R> chord(const ParameterPoint<R>& p, const ParameterPoint<R>& w) const override {
    return now().chord(p, w);
  }
  Chord<R> chord_along(const ParameterPoint<R>& p, const ParameterPoint<R>& direction,
                       const R& step) const override {
    return now().chord_along(p, direction, step);
  }

private:
  ChartOf<R, Formula<R>> now() const {
    return std::apply(
        [this](const Parameters&... parameters) {
          return ChartOf<R, Formula<R>>(Formula<R>(parameters...), orientation_);
        },
        parameters_);
  }

  Orientation orientation_;
  std::tuple<Parameters...> parameters_;
};

/// A chart from a formula template and its exact parameters, in every arithmetic that radcert compiles.
/// Maths     Formula<R>(parameters...) for each R
/// Source    CONTRIBUTING.md, on arithmetics
/// Requires  Formula<R> constructible from the Rational parameters
/// Result    a Chart
/// Limits    a new arithmetic is added here, once
template <template <class> class Formula, class... Parameters>
Chart make_chart(ChartFacts facts, const Parameters&... parameters) {
  auto in_double =
      std::make_shared<ChartOf<double, Formula<double>>>(Formula<double>(parameters...), facts.orientation);
  auto in_pack =
      std::make_shared<ChartOf<Pack, Formula<Pack>>>(Formula<Pack>(parameters...), facts.orientation);
  auto in_fifty_digits = std::make_shared<ChartOf<Mpfr<50>, Formula<Mpfr<50>>>>(
      Formula<Mpfr<50>>(parameters...), facts.orientation);
  auto in_balls =
      std::make_shared<ChartAtAnyPrecision<Ball, Formula, Parameters...>>(facts.orientation, parameters...);
  auto in_complex_balls = std::make_shared<ChartAtAnyPrecision<ComplexBall, Formula, Parameters...>>(
      facts.orientation, parameters...);
  auto in_models = std::make_shared<ChartOf<TaylorModel, Formula<TaylorModel>>>(
      Formula<TaylorModel>(parameters...), facts.orientation);
  return Chart(std::move(facts), std::move(in_double), std::move(in_pack), std::move(in_fifty_digits),
               std::move(in_balls), std::move(in_complex_balls), std::move(in_models));
}

}  // namespace radcert
