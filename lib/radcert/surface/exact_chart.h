// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>

#include "radcert/surface/chart.h"
#include "radcert/surface/exact_function.h"

namespace radcert {

/// A chart's formula as exact functions of the parameters.
/// Maths     (s, t) -> F(s, t)
/// Result    coordinates may be unknown: see ExactFunction. What is proved of the image is proved of the
///           chart, which has the same formula
class ExactImage {
public:
  ExactImage() = default;
  ExactImage(const ExactImage&) = delete;
  ExactImage& operator=(const ExactImage&) = delete;
  virtual ~ExactImage() = default;
  virtual Vector<ExactFunction> image() const = 0;
};

/// A chart's formula in balls that knows its exact image: both are the formula itself, none is stated.
template <template <class> class Formula, class... Parameters>
class BallsWithImage final : public ChartIn<Ball>, public ExactImage {
public:
  BallsWithImage(Orientation orientation, const Parameters&... parameters)
      : balls_(orientation, parameters...), parameters_(parameters...) {}

  Frame<Ball> frame(const ParameterPoint<Ball>& at) const override { return balls_.frame(at); }
  Chord<Ball> chord(const ParameterPoint<Ball>& p, const ParameterPoint<Ball>& w) const override {
    return balls_.chord(p, w);
  }
  Chord<Ball> chord_along(const ParameterPoint<Ball>& p, const ParameterPoint<Ball>& direction,
                          const Ball& step) const override {
    return balls_.chord_along(p, direction, step);
  }
  Vector<ExactFunction> image() const override {
    return std::apply(
        [](const Parameters&... parameters) {
          return Formula<ExactFunction>(parameters...)(ExactFunction::s(), ExactFunction::t());
        },
        parameters_);
  }

private:
  ChartAtAnyPrecision<Ball, Formula, Parameters...> balls_;
  std::tuple<Parameters...> parameters_;
};

/// A chart as make_chart makes it, with its exact image.
/// Maths     Formula<R>(parameters...) for each R, ExactFunction among them
/// Source    CONTRIBUTING.md, on arithmetics
/// Requires  as make_chart; the formula uses + - * / sqrt and powers
/// Result    a Chart of which exact_image() is known
template <template <class> class Formula, class... Parameters>
Chart make_exact_chart(ChartFacts facts, const Parameters&... parameters) {
  const Orientation orientation = facts.orientation;
  const auto made = std::make_shared<const Chart>(make_chart<Formula>(facts, parameters...));
  const auto formula_in = [&made]<class R>(const R&) {
    return std::shared_ptr<const ChartIn<R>>(made, &made->template in<R>());
  };
  return Chart(std::move(facts), formula_in(double()), formula_in(Pack()), formula_in(Mpfr<50>()),
               std::make_shared<BallsWithImage<Formula, Parameters...>>(orientation, parameters...),
               formula_in(ComplexBall()), formula_in(TaylorModel()));
}

/// The exact image of a chart in balls, or null where its formula is not known that way.
inline const ExactImage* exact_image(const ChartIn<Ball>& chart) {
  return dynamic_cast<const ExactImage*>(&chart);
}

}  // namespace radcert
