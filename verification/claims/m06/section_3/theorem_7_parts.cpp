// SPDX-License-Identifier: GPL-3.0-or-later

// Two steps of the proof of Theorem 7, on the O(1/h) triangles of T_n^(2), which are no halves of
// parallelograms.
//
// Their distance: in a coarse triangle refined L times they lie along one side, whichever is chosen to pair
// by (theorem_7_partition): their barycentric coordinate x_i of that side is at most 2^-L. v_i has
// coordinates with the sum 1, so that one of them is at least 1/3: pair by that side, and they are farther
// from v_i than 1/3 - 2^-L in that coordinate, a multiple of the height that does not depend on n. With one
// direction for all nodes this fails: a node near that side has about 1/h of them within any distance.
//
// Their share: Lemma 6 bounds it by h^(r+2) Int (|Phi| + |D Phi|) max {|D^(r+1) u|, |D^(r+2) u|} each; with
// 2^L of them of an area O(h^2) that is O(h^(r+3)). The page has the norm of D^(r+2) u alone: then the share
// would be zero for every g of degree r + 1, and it is not.
//
// Checked      theorem_7_partition_far: for the centroid of every triangle of the levels 2 to 5 of the unit
//              triangle, exactly, how many triangles of T_n^(2) have a vertex nearer than 1/12 in that
//              coordinate. Rejected: one direction for all nodes. theorem_7_leftover_share: Int Phi (I - L) g
//              for Phi and g of degree 1 and r + 1 over one triangle, r = 1 and 3 at alpha_0, exactly; for
//              Phi = 1 it is zero.
// Not checked  coarse triangles beside that of v_i, on which a side is chosen likewise; the order of the
//              share is lemma_6 times the count of theorem_7_partition.

#include <algorithm>

#include "verification/claims/m06/section_2/symmetric_refinement.h"
#include "verification/claims/m06/section_3/interpolation_error.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

using Coordinates = std::array<Rational, 3>;

Coordinates barycentric(const Corner& p) { return {1 - p[0] - p[1], p[0], p[1]}; }

Coordinates centroid(const Triangle& t) {
  return barycentric({(t[0][0] + t[1][0] + t[2][0]) / 3, (t[0][1] + t[1][1] + t[2][1]) / 3});
}

// Upright triangles with a side on x_i = 0: those without a partner for sides of that direction.
bool is_left_over(const Triangle& t, std::size_t i) {
  return std::count_if(t.begin(), t.end(), [i](const Corner& c) { return barycentric(c)[i] == 0; }) == 2;
}

// Those of each side.
std::array<std::vector<Triangle>, 3> left_over(const std::vector<Triangle>& triangles) {
  std::array<std::vector<Triangle>, 3> all;
  for (std::size_t side = 0; side < 3; ++side)
    std::copy_if(triangles.begin(), triangles.end(), std::back_inserter(all[side]),
                 [side](const Triangle& t) { return is_left_over(t, side); });
  return all;
}

// The number of pairs of a node and a triangle left over with a vertex within 1/12 in the coordinate of the
// side, the side chosen for the node or always the first.
Rational too_near(const std::vector<Triangle>& triangles, bool chosen_for_node) {
  const std::array<std::vector<Triangle>, 3> of_sides = left_over(triangles);
  long count = 0;
  for (const Triangle& own : triangles) {
    const Coordinates v = centroid(own);
    const auto largest = static_cast<std::size_t>(std::max_element(v.begin(), v.end()) - v.begin());
    const std::size_t side = chosen_for_node ? largest : 0;
    const Rational near = v[side] - Rational(1, 12);
    for (const Triangle& t : of_sides[side])
      if (std::any_of(t.begin(), t.end(), [&](const Corner& c) { return barycentric(c)[side] > near; }))
        ++count;
  }
  return {count};
}

}  // namespace

Finding theorem_7_partition_far(const Bench&) {
  const IsExactly none{0};
  Finding finding;
  for (int level = 2; level <= 5; ++level) {
    const std::string of = ", level " + std::to_string(level);
    const std::vector<Triangle> triangles = domains(level).back().triangles;
    finding.require("triangles left over within 1/12 of a node, the side chosen for the node" + of, none,
                    too_near(triangles, true));
    finding.control("triangles left over within 1/12 of a node, one side for all nodes" + of, none,
                    too_near(triangles, false));
    finding.require(
        "triangles left over less 2^L" + of, none,
        Rational(static_cast<long>(left_over(triangles).front().size())) - power(Rational(2), level));
  }
  return finding;
}

Finding theorem_7_leftover_share(const Bench&) {
  const RationalPolynomial a = RationalPolynomial::variable();
  const IsExactly none{0};
  Finding finding;
  for (const int r : {1, 3}) {
    const std::string of = ", r = " + std::to_string(r);
    const InterpolationError error(r);
    const RationalPolynomial of_alpha_0 = r == 1 ? 6 * a - 1 : 15 * a * a - 14 * a + 1;
    finding.require(
        "coefficients left of Int Phi (I - L) g over a triangle, Phi of degree 1, g of degree r + 1" + of,
        none, error.coefficients_left(Over::triangle, 1, r + 1, of_alpha_0));
    finding.instead("the same for Phi = 1" + of, none,
                    error.coefficients_left(Over::triangle, 0, r + 1, of_alpha_0));
    finding.instead("the same for g of degree r" + of, none,
                    error.coefficients_left(Over::triangle, 1, r, of_alpha_0));
    finding.control("the same for Phi = 1, alpha = 1/10" + of, none,
                    error.coefficients_left(Over::triangle, 0, r + 1, a - Rational(1, 10)));
  }
  return finding;
}

}  // namespace radcert::verification::m06
