// SPDX-License-Identifier: GPL-3.0-or-later

// Lemmas 5, 6 and 8 follow from the vanishing of B(Phi, g) = Int Phi (I - L) g for polynomials, as
// interpolation_defects.h has it: up to the total degree r + 2 on the square and r + 1 on the triangle for
// alpha_0, r + 1 on the square for even r. For a triangle of precision d' it vanishes up to d': where deg Phi
// + r <= d', Int Phi L g is the rule applied to Phi g. On the square one degree more is odd about the centre.
//
// Checked      these B, enclosed in balls, r = 1 and 3 at alpha_0, r = 0, 2 and 4 at alpha = 1/10; and that
//              the next degree does not vanish, so that no power of h is given away. Rejected: alpha = 1/10
//              for odd r; for even r two triangles that are each other's mirror images. On one triangle, r
//              even: up to r and no more at alpha = 1/10, the remark after Lemma 8, rejected for nodes of
//              degree r - 1; but for r = 2 there are alpha with one degree more, proved by the certificate of
//              superconvergent_insets, and for r = 8 none.
// Not checked  the constant c. Of other r there is none with an alpha_0 up to 11. The remark on general
// triangles: an affine map
//              takes B to a multiple of itself; the derivatives are then those of g and Phi behind the map.

#include "radcert/polynomial/nodes/superconvergent_inset.h"
#include "verification/claims/ac98/surfaces/proved_number.h"
#include "verification/claims/m06/section_3/interpolation_defects.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

using ac98::proved;

constexpr double zero_to_within = 1e-40;

// alpha_0 to within 1e-50.
Ball inset_of(int r) {
  const Rational width = 1 / power(Rational(10), 50);
  const Rational near = superconvergent_inset(r, width).value().value;
  return hull(Ball(near - width), Ball(near + width));
}

struct LemmaCase {
  std::string name;
  int r;
  Ball alpha;
};

// B vanishes up to `last` and not at last + 1.
void require_case(Finding& finding, const LemmaCase& each, Region region, int last) {
  const AgreesWith zero{.value = Ball(0), .within = zero_to_within};
  const AtMost clearly_below_zero{.value = -0x1p-40, .slack = 0, .why = "it must not vanish"};
  const TriangleBasis<Ball> basis(InsetBasis<Ball>(each.r, each.alpha));
  for (int total = each.r; total <= last; ++total)
    finding.require("largest |B| of the total degree " + std::to_string(total) + ", " + each.name, zero,
                    largest_defect(basis, region, total));
  const Ball next = largest_defect(basis, region, last + 1);
  finding.require("minus the largest |B| of the total degree " + std::to_string(last + 1) + ", " + each.name,
                  clearly_below_zero, proved(-next));
}

// Two triangles that make no parallelogram, or nodes of one degree less.
void control_even_degree(Finding& finding, int r, Region region, int total) {
  const AgreesWith zero{.value = Ball(0), .within = zero_to_within};
  const bool is_square = region == Region::parallelogram;
  const TriangleBasis<Ball> basis(InsetBasis<Ball>(is_square ? r : r - 1, Ball(Rational(1, 10))));
  finding.control("largest |B| of the total degree " + std::to_string(total) +
                      ", alpha = 1/10, r = " + std::to_string(r) +
                      (is_square ? ", two triangles that are mirror images" : ", nodes of degree r - 1"),
                  zero, largest_defect(basis, region, total, Halves::mirrored));
}

void control_other_inset(Finding& finding, int r, Region region, int last) {
  const AgreesWith zero{.value = Ball(0), .within = zero_to_within};
  const TriangleBasis<Ball> basis(InsetBasis<Ball>(r, Ball(Rational(1, 10))));
  finding.control(
      "largest |B| of the total degree " + std::to_string(last) + ", alpha = 1/10, r = " + std::to_string(r),
      zero, largest_defect(basis, region, last));
}

Finding odd_degrees(Region region, int gained) {
  const BallPrecision precision(256);
  Finding finding;
  for (const int r : {1, 3}) {
    require_case(finding, {"alpha_0, r = " + std::to_string(r), r, inset_of(r)}, region, r + gained);
    control_other_inset(finding, r, region, r + 1);  // r + 2 is odd: there it vanishes for every inset
  }
  return finding;
}

Finding even_degrees(Region region, int gained) {
  const BallPrecision precision(256);
  Finding finding;
  for (const int r : {2, 4}) {
    require_case(finding, {"alpha = 1/10, r = " + std::to_string(r), r, Ball(Rational(1, 10))}, region,
                 r + gained);
    control_even_degree(finding, r, region, r + gained);
  }
  return finding;
}

}  // namespace

Finding lemma_5(const Bench&) { return odd_degrees(Region::parallelogram, 2); }

Finding lemma_6(const Bench&) { return odd_degrees(Region::triangle, 1); }

Finding lemma_8(const Bench&) {
  const BallPrecision precision(256);
  Finding finding = even_degrees(Region::parallelogram, 1);
  require_case(finding, {"r = 0", 0, Ball(0)}, Region::parallelogram, 1);
  control_other_inset(finding, 1, Region::parallelogram, 2);
  return finding;
}

Finding lemma_8_one_triangle(const Bench&) {
  const auto gaining = [](int r) {
    const SuperconvergentInsets answer = superconvergent_insets(r, Region::triangle);
    // A certificate that fails counts as well.
    return Rational(static_cast<long>(answer.insets.size()) + (recheck(answer) ? 0 : 1));
  };
  Finding finding = even_degrees(Region::triangle, 0);
  finding.require("alpha in (0, 1/3) for which one triangle has a degree more, r = 2", IsExactly{0},
                  gaining(2));
  finding.instead("alpha in (0, 1/3) for which one triangle has a degree more, r = 8", IsExactly{0},
                  gaining(8));
  finding.control("alpha in (0, 1/3) for which one triangle has a degree more, r = 1", IsExactly{0},
                  gaining(1));
  return finding;
}

}  // namespace radcert::verification::m06
