// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/surfaces/unit_square_integrals.h"

#include <cmath>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/polynomial/rules/gauss.h"

namespace radcert::verification::ac98 {
namespace {

long panels(const Ball& z) { return static_cast<long>(std::ceil(1 / z.lower_double())); }

IntervalRule<Ball> composite_rule(long m, int points) {
  const IntervalRule<Ball> rule = gauss_rule<Ball>(points, IntervalWeight::one);
  IntervalRule<Ball> composite;
  for (long k = 0; k < m; ++k)
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      composite.nodes.push_back((Ball(k) + rule.nodes[i]) / Ball(m));
      composite.weights.push_back(rule.weights[i] / Ball(m));
    }
  return composite;
}

// What the rule cuts off in one variable, for panels of half-width 1/(2m) or less.
Ball truncation(const Ball& z, long m, int points) {
  const Ball least = z.lower();
  const Ball t = least * Ball(m);
  const Ball rho = t + sqrt(t * t + Ball(1));
  const Ball largest = Ball(5) / power(least, 3);
  return Ball(4) * largest * power(rho, 1 - 2 * static_cast<long>(points)) / (rho - Ball(1));
}

void require(const Ball& length, const Ball& z) {
  expects(certainly_positive(length) && certainly_at_most(length, Ball(1)), "0 < x, r <= 1",
          named("length", length));
  expects(certainly_positive(z) && certainly_less(z, Ball(1)), "0 < z < 1", named("z", z));
}

}  // namespace

UnitSquareIntegrals unit_square_integrals(const Ball& x, const Ball& z, int points) {
  require(x, z);
  const long m = panels(z);
  const IntervalRule<Ball> rule = composite_rule(m, points);
  std::vector<Ball> offsets;
  std::vector<Ball> squares;
  for (const Ball& node : rule.nodes) {
    offsets.push_back(node - x);
    squares.push_back(offsets.back() * offsets.back());
  }
  UnitSquareIntegrals sum;
  for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
    const Ball& eta = rule.nodes[j];
    const Ball rest = eta * eta + z * z;
    Ball first;   // Int dxi / D
    Ball second;  // Int dxi / D^2
    Ball moment;  // Int (xi - x) dxi / D^2
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const Ball inverse = reciprocal(squares[i] + rest);
      const Ball weighted = rule.weights[i] * inverse;
      first += weighted;
      const Ball again = weighted * inverse;
      second += again;
      moment += again * offsets[i];
    }
    const Ball factor = rule.weights[j] * z;
    sum.one += factor * eta * second;
    sum.offset += factor * eta * moment;
    sum.distance += factor * (eta * eta) * second;
    sum.inverse_square += factor * first;
  }
  const Ball off = Ball(2) * truncation(z, m, points);
  for (Ball* each : {&sum.one, &sum.offset, &sum.distance, &sum.inverse_square}) *each = widened(*each, off);
  return sum;
}

Ball half_disk_integral(const Ball& radius, const Ball& z, int points) {
  require(radius, z);
  const long m = panels(z);
  const IntervalRule<Ball> rule = composite_rule(m, points);
  Ball sum;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const Ball rho = radius * rule.nodes[i];
    sum += rule.weights[i] * radius * z * rho / (rho * rho + z * z);
  }
  return Ball::pi() * widened(sum, truncation(z, m, points));
}

}  // namespace radcert::verification::ac98
