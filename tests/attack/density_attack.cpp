// SPDX-License-Identifier: GPL-3.0-or-later
// The second route to Ku for densities with a feature between its points: peaks and tents on one side of a
// box, seen from another.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "radcert/core/text.h"
#include "radcert/expression/parse.h"
#include "radcert/polynomial/rules/gauss.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/surface/catalogue/box.h"
#include "tests/attack/attack.h"

namespace radcert::attack {
namespace {

/// u = base + height f, f a peak exp(-|Q-Q_0|^2 / width^2) or a tent max(0, 1 - |Q-Q_0|_1 / width) about a
/// point of the floor.
struct Instance {
  std::array<Rational, 3> sides{Rational(1), Rational(1), Rational(1)};
  bool is_tent = false;
  double base = 1;
  double height = 1;
  double width = 1e-3;
  Vector<double> at{};            ///< Q_0
  SurfacePoint<double> p{5, {}};  ///< on another side

  [[nodiscard]] std::string formula() const {
    const auto off = [](const char* name, double x) {
      return "(" + std::string(name) + " - " + shortest(x) + ")";
    };
    const std::string x = off("x", at.x);
    const std::string y = off("y", at.y);
    const std::string feature =
        is_tent ? "max(0, 1 - (abs(" + x + ") + abs(" + y + ") + z)/" + shortest(width) + ")"
                : "exp(-(" + x + "^2 + " + y + "^2 + z^2)/" + shortest(width) + "^2)";
    return shortest(base) + " + (" + shortest(height) + ")*" + feature;
  }
};

std::string text(const Instance& x) {
  return "box " + x.sides[0].to_text() + ", " + x.sides[1].to_text() + ", " + x.sides[2].to_text() +
         ", u = " + x.formula() + ", P on chart " + std::to_string(x.p.chart) + " at (" + shortest(x.p.at.s) +
         ", " + shortest(x.p.at.t) + ")";
}

/// Int G f over the plane of the floor, f the feature: by the trapezoidal rule, which leaves out
/// exp(-(pi/0.3)^2) of a peak, and by Gauss's rule on the four triangles of a tent.
double feature_integral(const Instance& x, const std::function<double(double, double)>& kernel) {
  double sum = 0;
  if (!x.is_tent) {
    constexpr double step = 0.3;
    constexpr int reach = 22;
    for (int i = -reach; i <= reach; ++i)
      for (int k = -reach; k <= reach; ++k)
        sum += step * step * std::exp(-step * step * (i * i + k * k)) *
               kernel(x.at.x + step * i * x.width, x.at.y + step * k * x.width);
    return sum * x.width * x.width;
  }
  const IntervalRule<double> rule = gauss_rule<double>(16, IntervalWeight::one);
  for (const double sign_x : {-1.0, 1.0})
    for (const double sign_y : {-1.0, 1.0})
      for (std::size_t i = 0; i < rule.nodes.size(); ++i)
        for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
          const double r = rule.nodes[i];  // the distance from Q_0 in widths
          const double m = rule.nodes[k];
          sum += rule.weights[i] * rule.weights[k] * r * (1 - r) *
                 kernel(x.at.x + sign_x * r * m * x.width, x.at.y + sign_y * r * (1 - m) * x.width);
        }
  return sum * x.width * x.width;
}

Judgement judge(const Instance& x) {
  const Surface surface = box(x.sides[0], x.sides[1], x.sides[2]);
  const Expression u = parse_expression(x.formula()).value();
  const reference::Density density = [&](const SurfacePoint<double>&, const Vector<double>& q) {
    return u.evaluate<double>({q.x, q.y, q.z});
  };
  const reference::AppliedOperator applied(surface, density,
                                           std::vector<Expression>(surface.chart_count(), u));
  const Approximation found = applied(x.p);
  const Frame<double> frame = surface.charts[x.p.chart].in<double>().frame(x.p.at);
  const Vector<double> normal = unit_normal(frame);
  const double feature = feature_integral(x, [&](double qx, double qy) {
    const Vector<double> d = Vector<double>{qx, qy, 0} - frame.point;
    return dot(d, normal) * -d.z / (dot(d, d) * dot(d, d));
  });
  const double truth = x.base * std::numbers::pi + x.height * feature;
  const double rounding = 0x1p-48 * (std::abs(x.base) * 4 + std::abs(x.height * feature));
  if (std::abs(found.value - truth) <= found.radius + rounding) return Judgement::held(1);
  return Judgement::violated(shortest(found.value) + " +- " + shortest(found.radius) + ", truth " +
                             shortest(truth));
}

Instance make(Draw& draw) {
  Instance x;
  const std::vector<Rational> sides{Rational(1), Rational(1, 2), Rational(2), Rational(7, 3),
                                    Rational(1, 10)};
  for (Rational& side : x.sides) side = sides[draw.below(sides.size())];
  if (x.sides[2] == Rational(1, 10)) x.sides[2] = 1;  // P stays far from the floor beside the widths
  const double a = x.sides[0].to_double();
  const double b = x.sides[1].to_double();
  x.is_tent = draw.below(2) == 0;
  x.base = std::vector{0.0, 1.0, -3.0, 1e-3}[draw.below(4)];
  x.height = std::vector{1.0, 1e-4, -1e6}[draw.below(3)];
  x.width = std::min(a, b) * std::pow(10, -2 - 5 * draw.unit());
  // A peak stays ten widths off the walls; now and then it lies where cells are halved.
  const auto within = [&](double side) {
    const double place = draw.below(3) == 0 ? 0.25 * static_cast<double>(1 + draw.below(3)) : draw.unit();
    return 10 * x.width + place * (side - 20 * x.width);
  };
  x.at = {within(a), within(b), 0};
  x.p.chart = std::vector<std::size_t>{0, 1, 2, 3, 5}[draw.below(5)];
  x.p.at = {0.1 + 0.8 * draw.unit(), 0.1 + 0.8 * draw.unit()};
  return x;
}

TEST(DensityAttack, SeesWhatLiesBetweenThePoints) {
  hold(Attack<Instance>{.name = "Ku, features between the points",
                        .usual_instances = 6,
                        .make = make,
                        .judge = judge,
                        .text = text,
                        .smaller = [](const Instance& x) {
                          std::vector<Instance> found;
                          if (x.base != 1) {
                            found.push_back(x);
                            found.back().base = 1;
                          }
                          if (x.height != 1) {
                            found.push_back(x);
                            found.back().height = 1;
                          }
                          return found;
                        }});
}

}  // namespace
}  // namespace radcert::attack
