// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/elements/panel_reflectivity.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "radcert/core/work_limit.h"
#include "radcert/geometry/plane_polygon.h"
#include "radcert/polynomial/plane_polynomial_algebra.h"

namespace radcert {

const WorkLimit most_triangles("continuous/panel_reflectivity: triangles of a panel", 2000, 8,
                               "a larger bound of rho, or a refusal: rho is not proved to lie in [0,1)");

namespace {

using Point = ParameterPoint<Rational>;
using Triangle = std::array<Point, 3>;

/// Between what a polynomial lies on a triangle, and its largest value at a corner.
struct Range {
  Rational least = 0;
  Rational largest = 0;
  Rational least_seen = 0;
  Rational largest_seen = 0;
};

Rational factorial(int n) { return n < 2 ? Rational(1) : Rational(n) * factorial(n - 1); }

/// Maths     s^k t^l = sum over i >= k, j >= l of i!/(i-k)! j!/(j-l)! (n-k-l)!/n! B_ij
Range range_on(const PlanePolynomial<Rational>& f, const Triangle& on) {
  const auto along = [&](Rational Point::*coordinate) {
    const Rational& from = on[0].*coordinate;
    return affine_polynomial<Rational>(from, on[1].*coordinate - from, on[2].*coordinate - from);
  };
  const PlanePolynomial<Rational> here = composed(f, along(&Point::s), along(&Point::t));
  const int n = here.degree();
  Range range;
  bool is_first = true;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) {
      Rational coefficient = 0;
      for (int k = 0; k <= i; ++k)
        for (int l = 0; l <= j; ++l) {
          if (here(k, l).sign() == 0) continue;
          coefficient += factorial(i) / factorial(i - k) * factorial(j) / factorial(j - l) *
                         factorial(n - k - l) / factorial(n) * here(k, l);
        }
      range.least = is_first ? coefficient : std::min(range.least, coefficient);
      range.largest = is_first ? coefficient : std::max(range.largest, coefficient);
      is_first = false;
    }
  for (const Point& corner : on) {
    const Rational value = f.value(corner.s, corner.t);
    range.least_seen = &corner == on.data() ? value : std::min(range.least_seen, value);
    range.largest_seen = &corner == on.data() ? value : std::max(range.largest_seen, value);
  }
  return range;
}

/// Halves of a triangle, by the middle of the side between its last corners: the next side the time after.
std::array<Triangle, 2> halves(const Triangle& whole) {
  const Rational half(1, 2);
  const Point middle{half * (whole[1].s + whole[2].s), half * (whole[1].t + whole[2].t)};
  return {Triangle{middle, whole[0], whole[1]}, Triangle{middle, whole[2], whole[0]}};
}

}  // namespace

PanelReflectivity::PanelReflectivity(const Rational& constant)
    : polynomial(constant_polynomial(constant)), largest(constant), seen(constant) {}

Outcome<PanelReflectivity> reflectivity_of(const Panel& panel, const PlanePolynomial<Rational>& rho) {
  const std::vector<Vector<Rational>>& c = panel.corners;
  const auto place = [&](const Vector<Rational>& p) {
    return coordinates(p - c[0], c[1] - c[0], c[2] - c[0]);
  };
  std::vector<Triangle> open;
  for (std::size_t k = 1; k + 1 < c.size(); ++k) open.push_back({place(c[0]), place(c[k]), place(c[k + 1])});
  Rational seen = rho.value(Rational(0), Rational(0));
  Rational largest = seen;
  // Level by level, so that the largest values are seen early.
  for (std::size_t done = 0; done < open.size(); ++done) {
    const Triangle here = open[done];
    const Range range = range_on(rho, here);
    if (range.least_seen.sign() < 0) return because("it is negative, " + range.least_seen.to_text());
    if (range.largest_seen >= Rational(1)) return because("it reaches " + range.largest_seen.to_text());
    seen = std::max(seen, range.largest_seen);
    const bool is_positive = range.least.sign() >= 0;
    const bool is_close =
        range.largest < Rational(1) && (range.largest - seen) * Rational(1024) <= Rational(1) - range.largest;
    const bool is_last = open.size() >= most_triangles.count();
    if (is_last && !is_positive) return because("it is not proved to be nowhere negative");
    if (is_last && !(range.largest < Rational(1))) return because("it is not proved to stay below 1");
    if (is_last || (is_positive && is_close)) {
      largest = std::max(largest, range.largest);
      continue;
    }
    for (const Triangle& half : halves(here)) open.push_back(half);
  }
  return PanelReflectivity(rho, largest, seen);
}

}  // namespace radcert
