// SPDX-License-Identifier: GPL-3.0-or-later

// The theorem asks for E in C^2(S) and says nothing of rho. u = E + K u has the smoothness of rho: with
// rho continuous only, u need not be in C^2(S), and (48) fails. Section 2 has rho in C^m(S) among the
// hypotheses of Theorem 2.4.
//
// Checked      theorem_3_1: (48) off the nodes: max |u - hat u_n| over points of S, hat u_n = E + K u_n
//              integrated by cubature that shares nothing with the matrix; on the roofs of two surfaces of
//              two pieces and on an ellipsoid, where G is singular, alpha = 1/10; in balls on the sphere,
//              where E that is not in C^2 is rejected. theorem_3_1_reflectivity: the unit sphere, E = 1,
//              rho = (1/2)|(x - y)/2^(1/2)|^(1/4), whose mean is 2/5, and the smooth rho of the same mean
//              in its place. equation_50: the error over a sample of S, degrees 0 to 3.
//              equation_51_constant: c of (51) level by level.
// Not checked  "for all n >= n_0"; collective compactness.

#include <algorithm>

#include "radcert/expression/parse.h"
#include "radcert/formats/result/stored_levels.h"
#include "verification/claims/ac98/collocation/element_function.h"
#include "verification/claims/ac98/collocation/known_problems.h"
#include "verification/claims/ac98/collocation/sphere_collocation.h"
#include "verification/claims/ac98/surfaces/two_piece_total.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/level_errors.h"

namespace radcert::verification::ac98 {
namespace {

using Function = SphereCollocation::Function;

// The element of a chart that holds a point.
std::size_t element_at(const std::vector<ParameterTriangle>& elements, const SurfacePoint<double>& p) {
  const auto holds = [&](const ParameterTriangle& t) {
    const auto& [a, b, c] = t.vertices;
    return t.chart == p.chart && cross(b - a, p.at - a) >= 0 && cross(c - b, p.at - b) >= 0 &&
           cross(a - c, p.at - c) >= 0;
  };
  const auto found = std::find_if(elements.begin(), elements.end(), holds);
  expects(found != elements.end(), "a point of the chart", named("chart", p.chart));
  return static_cast<std::size_t>(found - elements.begin());
}

// hat u_n - u = K (u_n - u), furthest from 0 over points away from the nodes: the centroids of three elements
// of a chart, which are the same places at every level to within an element, and in each the point that is by
// a tenth of the way to the centroid off a node.
Approximation furthest_off_the_nodes(const Bench& bench, const Problem& problem, std::size_t chart,
                                     int level) {
  const IteratedError error(bench.route, problem, bench.levels.level(problem, level));
  const ElementFunction& u_n = error.u_n();
  Approximation worst{.value = 0, .radius = 0};
  const auto look_at = [&](const SurfacePoint<double>& p) {
    const Approximation here = error(p);
    worst.value = std::max(worst.value, here.value);
    worst.radius = std::max(worst.radius, here.radius);
  };
  for (const auto& [s, t] : {std::pair{0.31, 0.42}, {0.17, 0.29}, {0.55, 0.13}}) {
    const std::size_t element = element_at(u_n.triangles(), {chart, {s, t}});
    const ParameterPoint<double> centroid = u_n.triangles().at(element).at({1.0 / 3, 1.0 / 3, 1.0 / 3});
    look_at({chart, centroid});
    look_at({chart, 0.9 * u_n.node(element, 0).at + 0.1 * centroid});
  }
  return worst;
}

// The mean of 1/(5/4 - z), and that function.
Ball peak(const Vector<Ball>& q) { return reciprocal(Ball(Rational(5, 4)) - q.z); }
Ball mean_of_peak() { return log(Ball(9)) / Ball(2); }

// 2/5 (1 + e) |(x - y)/2^(1/2)|^e, e = 2^-roots: of the mean 2/5, and in no C^1. The great circle on which it
// is not smooth goes through the middles of elements, in the same way at every level.
Function rough(int roots) {
  return [roots](const Vector<Ball>& q) {
    Ball root = abs(q.x - q.y) / sqrt(Ball(2));
    for (int i = 0; i < roots; ++i) root = sqrt(root);
    return Ball(Rational(2, 5) * (1 + Rational(1, 1L << roots))) * root;
  };
}
const Rational mean_of_rough(2, 5);

// The same mean, and smooth: 3/10 + z^4/2. On a symmetric triangulation z^2 would have no error.
Ball smooth_reflectivity(const Vector<Ball>& q) { return Ball(Rational(3, 10)) + power(q.z, 4) / Ball(2); }

// max |u - hat u_n| on the sphere, rho = 1/2: rho/(1 - rho) |M E - M_n E|.
Approximation error_on_the_sphere(const Function& e, const Ball& mean, int level, const Rational& alpha) {
  return proved(abs(mean - SphereCollocation(symmetric_octant(level), alpha).mean(e)));
}

// max |u - hat u_n| over max rho, E = 1: |1/(1 - M rho) - 1/(1 - M_n rho)|.
Approximation error_with(const Function& rho, int level) {
  const Ball mean = SphereCollocation(symmetric_octant(level), Rational(1, 10)).mean(rho);
  return proved(abs(Ball(1 / (1 - mean_of_rough)) - reciprocal(Ball(1) - mean)));
}

const std::string squares_text = "x^2 + y^2 + z^2";
const std::string wave = "exp(x + y/2 - z/3)";

}  // namespace

Finding theorem_3_1(const Bench& bench) {
  const BallPrecision precision(192);
  const Order two = Order::at_least(2);
  Finding finding;
  const Rational tenth(1, 10);
  constexpr std::size_t roof = 1;
  constexpr std::size_t octant = 0;
  const auto order_of = [&](const Problem& problem, std::size_t chart, int last) {
    return observed_order(over_levels(levels_from(last - 2, last), [&](int level) {
      return furthest_off_the_nodes(bench, problem, chart, level);
    }));
  };
  const SurfaceParameter two_p{"p", 2};
  const SurfaceParameter three_p{"p", 3};
  const std::vector<SurfaceParameter> axes{{"a", 1}, {"b", Rational(3, 2)}, {"c", 2}};
  const std::string what = "order of max |u - hat u_n| off the nodes, alpha = 1/10, ";
  finding.require(what + "the roof of two_piece(2), " + squares_text, two,
                  order_of(known_problem("two_piece", {two_p}, "1", squares_text, 1, tenth), roof, 3));
  finding.require(what + "the roof of two_piece(3), " + wave, two,
                  order_of(known_problem("two_piece", {three_p}, "1", wave, 1, tenth), roof, 3));
  finding.require(what + "ellipsoid (1,3/2,2), " + wave, two,
                  order_of(known_problem("ellipsoid", axes, "1/2", wave, 1, tenth), octant,
                           bench.budget == Budget::quick ? 2 : 3));
  finding.remark(
      "order off the nodes for alpha = 1/6, the roof of two_piece(2), " + squares_text,
      order_of(known_problem("two_piece", {two_p}, "1", squares_text, 1, Rational(1, 6)), roof, 3).exponent);
  const auto on_the_sphere = [&](const Function& e, const Ball& mean) {
    return over_levels(levels_from(2, 5),
                       [&](int level) { return error_on_the_sphere(e, mean, level, tenth); });
  };
  const LevelErrors errors = on_the_sphere(peak, mean_of_peak());
  const ObservedOrder in_balls = observed_order(errors);
  finding.require("sphere, E = 1/(5/4 - z): the same in balls, levels 2 to 5", two, in_balls);
  finding.control("sphere, E = |x - y|^(1/4), which is not in C^2", two,
                  observed_order(on_the_sphere(rough(2), Ball(mean_of_rough))));
  finding.remark("sphere: max |u - hat u_n|, level 5", errors.errors.back());
  finding.show(in_balls.exponent);
  return finding;
}

Finding theorem_3_1_reflectivity(const Bench&) {
  const BallPrecision precision(192);
  const Order two = Order::at_least(2);
  Finding finding;
  const auto order_of = [](const Function& rho, double next) {
    return observed_order(over_levels(levels_from(1, 5), [&](int level) { return error_with(rho, level); }),
                          {.next = next});
  };
  // On the elements along the circle the interpolant of |x - y|^(1/4) is off by h^(1/4), and beyond them by
  // less and less: together h^(5/4), and h^2 beside it.
  const ObservedOrder order = order_of(rough(2), 0.75);
  const ObservedOrder smooth = order_of(smooth_reflectivity, 1);
  finding.require("order of max |u - hat u_n|, rho only continuous, E = 1, levels 1 to 5", two, order);
  finding.control("the same, rho like |x - y|^(1/8)", two, order_of(rough(3), 0.875));
  finding.instead("the same, rho = 3/10 + z^4/2, in C^2(S)", two, smooth);
  const Order five_quarters = Order::is(1.25, 0.25, 2);
  finding.instead("the exponent for rho only continuous", five_quarters, order);
  finding.control("the exponent for rho = 3/10 + z^4/2", five_quarters, smooth);
  for (int level = 1; level <= 5; ++level)
    finding.remark("max |u - hat u_n| over max rho, rho only continuous, level " + std::to_string(level),
                   error_with(rough(2), level));
  finding.show(order.exponent);
  return finding;
}

Finding equation_50(const Bench& bench) {
  Finding finding;
  const auto order = [&](const std::string& solution, int degree, int p = 2) {
    const int last = (degree < 2 ? 3 : 2) + (bench.budget == Budget::quick ? 0 : 1);
    const Problem problem = known_problem("two_piece", {{"p", p}}, "1", solution, degree, Rational(1, 10));
    return observed_order(uniform_errors(bench, problem, levels_from(0, last)));
  };
  for (int degree = 0; degree <= 3; ++degree) {
    const Order printed = Order::at_least(degree + 1);
    const std::string of = "order of max |u - u_n|, two_piece(2), degree " + std::to_string(degree);
    finding.require(of + ", " + squares_text, printed, order(squares_text, degree));
    if (degree < 2 || bench.budget != Budget::quick)
      finding.require(of + ", " + wave, printed, order(wave, degree));
    if (degree > 0)
      finding.control("the same for degree " + std::to_string(degree - 1) + ", two_piece(3)", printed,
                      order(squares_text, degree - 1, 3));
  }
  return finding;
}

Finding equation_51_constant(const Bench& bench) {
  const BallPrecision precision(128);
  const auto norm_on_two_piece = [](int p) { return (largest_total(p, 1e-3) / Ball::pi()).upper_double(); };
  const auto quotient = [](const LevelResult& level) {
    const Approximation error = as_sampled(level.node_error.value());
    const Approximation right = as_sampled(level.discretisation_error.value());
    const double value = error.value / right.value;
    return Approximation{.value = value,
                         .radius = value * (error.radius / error.value + right.radius / right.value)};
  };
  Finding finding;
  struct Case {
    std::string name;
    Problem problem;
    double norm;  ///< an upper bound of the norm of K, rho included
    int last;
  };
  const Rational sixth(1, 6);
  const Problem closed = known_problem("sphere", {}, "9/10", wave, 1, sixth);
  const std::vector<Case> cases{
      {"two_piece(2)", known_problem("two_piece", {{"p", 2}}, "1", wave, 1, sixth), norm_on_two_piece(2), 3},
      {"two_piece(3)", known_problem("two_piece", {{"p", 3}}, "1", wave, 1, sixth), norm_on_two_piece(3), 3},
      {"ellipsoid (1,3/2,2)",
       known_problem("ellipsoid", {{"a", 1}, {"b", Rational(3, 2)}, {"c", 2}}, "1/2", wave, 1, sixth), 0.5,
       2}};
  for (const Case& each : cases) {
    const AtMost bound{.value = 1 / (1 - each.norm),
                       .slack = 0,
                       .why = "1/(1 - norm of K), which bounds c where no weight is negative"};
    std::vector<LevelResult> levels;
    for (int level = 0; level <= each.last; ++level)
      levels.push_back(bench.levels.level(each.problem, level).result);
    for (const LevelResult& level : levels)
      finding.require("max |u - u_n| over max |K(I - P_n)u| at the nodes, " + each.name + ", level " +
                          std::to_string(level.level),
                      bound, quotient(level));
    // A norm of K of 9/10, on the sphere: there the quotient is 1/(1 - 9/10), as K(I - P_n)u is constant.
    finding.control("the same on the sphere, rho = 9/10, level 1, against the bound for " + each.name, bound,
                    quotient(bench.levels.level(closed, 1).result));
  }
  return finding;
}

}  // namespace radcert::verification::ac98
