// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/scalar/ball.h"
#include "radcert/surface/catalogue.h"
#include "radcert/surface/surface_function.h"

namespace radcert {
namespace {

PiecewiseExpression sum_of_coordinates() {
  return own_function({.words = "x + 2 y + 3 z",
                       .values = [](std::span<const double> x, std::span<const double> y,
                                    std::span<const double> z, std::span<double> values) {
                         for (std::size_t i = 0; i < values.size(); ++i)
                           values[i] = x[i] + 2 * y[i] + 3 * z[i];
                       }});
}

TEST(OwnFunction, GivesItsValuesOnEveryChart) {
  const Surface cube = default_surface(*find_surface("cube"));
  const SurfaceFunction f(sum_of_coordinates(), cube);
  const std::vector<double> x{1, 0.5};
  const std::vector<double> y{2, 0.25};
  const std::vector<double> z{3, 0.125};
  for (std::size_t chart = 0; chart < cube.chart_count(); ++chart) {
    EXPECT_EQ(f(chart, {1, 2, 3}), 14);
    std::vector<double> values(2);
    f.evaluate(chart, x, y, z, values);
    EXPECT_EQ(values, (std::vector<double>{14, 1.375}));
  }
  EXPECT_FALSE(f.is_by_formulas());
  EXPECT_TRUE(SurfaceFunction({.cases = {{"*", Expression::constant(Rational(1))}}}, cube).is_by_formulas());
}

TEST(OwnFunction, HasNoValueForWhoeverAsksItsExpression) {
  const PiecewiseExpression function = sum_of_coordinates();
  EXPECT_TRUE(function.has_own());
  const Expression& expression = function.on("floor");
  EXPECT_EQ(expression.text(), "x + 2 y + 3 z");
  EXPECT_FALSE(expression.is_constant());
  EXPECT_TRUE(std::isnan(expression.evaluate<double>({1, 2, 3})));
  EXPECT_TRUE(std::isnan(CompiledExpression(expression).at(1, 2, 3)));
  EXPECT_FALSE(expression.evaluate<Ball>({Ball(1), Ball(2), Ball(3)}).is_finite());
}

TEST(OwnFunction, IsRefusedWhereItIsNotFinite) {
  const Surface cube = default_surface(*find_surface("cube"));
  const SurfaceFunction f(
      own_function({.words = "nothing",
                    .values = [](auto, auto, auto, std::span<double> values) { values[0] = std::nan(""); }}),
      cube);
  double value = 0;
  const double zero = 0;
  EXPECT_THROW(f.evaluate(0, {&zero, 1}, {&zero, 1}, {&zero, 1}, {&value, 1}), InputError);
  EXPECT_THROW(static_cast<void>(own_function({.words = "nothing", .values = nullptr})), ContractViolation);
  EXPECT_THROW(static_cast<void>(own_function({.words = "", .values = [](auto, auto, auto, auto) {}})),
               ContractViolation);
}

}  // namespace
}  // namespace radcert
