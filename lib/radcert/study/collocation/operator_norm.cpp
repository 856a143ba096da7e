// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/collocation/operator_norm.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/core/work_limit.h"
#include "radcert/expression/expression.h"
#include "radcert/scalar/approximation.h"
#include "radcert/scalar/ball.h"
#include "radcert/surface/own_surface.h"

namespace radcert {
namespace {

/// sup rho where it is a constant on every piece.
std::optional<Rational> constant_bound(const PiecewiseExpression& reflectivity, const Surface& surface) {
  Rational bound = 0;
  for (const std::string& piece : surface.piece_names()) {
    const std::optional<Rational> value = reflectivity.on(piece).is_constant();
    if (!value) return std::nullopt;
    bound = std::max(bound, *value);
  }
  return bound;
}

/// A square of the parameter plane with corners at multiples of 2^-depth.
struct ParameterSquare {
  long s = 0;
  long t = 0;
  int depth = 0;
};

const WorkLimit deepest("study/operator_norm: halvings of a parameter", 12, 0,
                        "refused: rho is not proved to stay below 1");
const WorkLimit most_boxes("study/operator_norm: boxes", 20000, 0,
                           "refused: rho is not proved to stay below 1");

Ball side(long place, int depth) {
  const Rational step = Rational(1) / power(Rational(2), depth);
  return hull(Ball(Rational(place) * step), Ball(Rational(place + 1) * step));
}

/// Whether a box lies beyond the domain.
bool is_outside(const ParameterSquare& box, ChartDomain domain) {
  return domain == ChartDomain::unit_triangle && box.s + box.t >= 1L << box.depth;
}

bool is_below_one(const Expression& f, const Chart& chart) {
  if (const std::optional<Rational> constant = f.is_constant()) return *constant < Rational(1);
  std::vector<ParameterSquare> open{{}};
  for (std::size_t seen = 0; !open.empty(); ++seen) {
    const ParameterSquare box = open.back();
    open.pop_back();
    if (is_outside(box, chart.facts().domain)) continue;
    const Vector<Ball> q = chart.in<Ball>().frame({side(box.s, box.depth), side(box.t, box.depth)}).point;
    if (certainly_less(f.evaluate<Ball>({q.x, q.y, q.z}), Ball(1))) continue;
    if (box.depth >= deepest.value() || seen >= most_boxes.count()) return false;
    for (const long s : {2 * box.s, 2 * box.s + 1})
      for (const long t : {2 * box.t, 2 * box.t + 1}) open.push_back({s, t, box.depth + 1});
  }
  return true;
}

}  // namespace

Approximation largest_row(std::span<const double> rho_at_nodes, std::span<const double> kernel_integral) {
  double norm = 0;
  for (std::size_t i = 0; i < rho_at_nodes.size(); ++i)
    norm = std::max(norm, rho_at_nodes[i] * kernel_integral[i] / pi<double>());
  return Approximation::without_radius(norm);
}

Approximation norm_of_K(const Surface& surface, const PiecewiseExpression& reflectivity,
                        std::span<const double> rho_at_nodes, std::span<const double> kernel_integral) {
  if (!surface.closed) return largest_row(rho_at_nodes, kernel_integral);
  // The double 0.8 is not 4/5: what lies between them is its radius.
  if (const std::optional<Rational> bound = constant_bound(reflectivity, surface))
    return is_known_in_balls(surface) ? enclosing(Ball(*bound))
                                      : Approximation::without_radius(bound->to_double());
  expects(!rho_at_nodes.empty(), "rho at nodes where it is no constant");
  return Approximation::without_radius(*std::max_element(rho_at_nodes.begin(), rho_at_nodes.end()));
}

void refuse_norm_from_one(const Approximation& norm) {
  if (norm.value < 1) return;
  throw InputError({.pointer = "/reflectivity",
                    .value = shortest(norm.value),
                    .problem = "is the norm of K: the equation need not have one solution",
                    .allowed = "reflectivities for which the norm of K is below 1"});
}

Outcome<void> reflectivity_below_one(const Surface& surface, const PiecewiseExpression& reflectivity) {
  for (const Chart& chart : surface.charts) {
    const Expression& f = reflectivity.on(chart.facts().piece);
    if (!is_below_one(f, chart))
      return because("the reflectivity " + f.text() + " is not proved to stay below 1 on piece " +
                     chart.facts().piece);
  }
  return {};
}

}  // namespace radcert
