// SPDX-License-Identifier: GPL-3.0-or-later

// K is compact on C(S) and on L^2(S), where G is bounded by c_1 (lemma_1_a) and smooth off the diagonal.
//
// On L^2(S): the kernel rho G/pi is square integrable, with the norm of Hilbert and Schmidt at most norm of
// rho c_1 area(S)/pi. On the unit sphere with a constant rho it is rho exactly, as G = 1/4 and the area is 4
// pi.
//
// On C(S): cut G off continuously within the distance delta of P. What is left has a continuous kernel, and
// is compact by the theorem of Arzela and Ascoli; the norm of what is cut off is at most norm of rho c_1/pi
// times the largest area of S within delta of a point. On the unit sphere that area is pi delta^2, on the
// roof z = 2 - x^2 of two_piece(2) at most 5^(1/2) pi delta^2: points within delta have parameters within
// delta, and the area element is at most 5^(1/2). So K is a limit of compact operators.
//
// Checked      both norms, with c_1 and the areas enclosed, rho = 1/2: Hilbert and Schmidt's on the sphere,
//              and bounds of it on the roof and between the two pieces; the norm of what is cut off at delta
//              = 2^-10 and 2^-20, which is below delta. Rejected: two squares that meet in an edge, where G
//              is not bounded. From the distance z = delta/1000 of the edge the part within delta/2 along and
//              across the edge has the same integral for every delta; and the square integral of G has parts,
//              2^-(k+1) <= eta, z <= 2^-k and |xi - x| <= 2^-k, x in the middle half, where G >= 4^k/36, that
//              add up to no finite number.
// Not checked  other surfaces.

#include "radcert/enclosure/interval_integral.h"
#include "verification/claims/ac98/surfaces/smooth_bounds.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

Ball reflectivity() { return Ball(Rational(1, 2)); }

// The largest G on the roof and its area, Int_0^1 (1 + 4x^2)^(1/2) dx.
Ball largest_on_the_roof() { return ac98::roof_bounds(2, 1e-6).kernel; }
Ball area_of_the_roof() {
  const auto element = line_function([]<class R>(const R& x) -> R { return sqrt(R(1) + R(4) * x * x); });
  return known(integral_on_interval(element, Ball(0), Ball(1), {.radius = 1e-20}));
}

// The norm of Hilbert and Schmidt for a bound of G and the areas of both points' pieces.
Ball square_norm(const Ball& kernel, const Ball& of_p, const Ball& of_q) {
  return reflectivity() * kernel * sqrt(of_p * of_q) / Ball::pi();
}

// A lower bound of that norm on two squares that meet in an edge, the strips k <= last alone: 4^k/36 on a set
// of the measure 1/2 (2 2^-k) (2^-(k+1))^2 each.
Ball square_norm_at_an_edge(long last) {
  Rational sum = 0;
  for (long k = 2; k <= last; ++k) {
    const Rational kernel = power(Rational(4), k) / 36;
    sum += kernel * kernel * power(Rational(2), -k) * power(Rational(2), -2 * (k + 1));
  }
  return reflectivity() * sqrt(Ball(sum)) / Ball::pi();
}

// The norm of what is cut off, for a bound of G and of the area within delta over delta^2.
Ball cut_off(const Ball& kernel, const Ball& area, const Rational& delta) {
  return reflectivity() * kernel * area * Ball(delta * delta) / Ball::pi();
}

// The same at an edge from below: Int over |xi - x| <= L, 0 <= eta <= L of z eta/(r^2 + (xi - x)^2)^2, r^2 =
// eta^2 + z^2, L = delta/2 and z = delta/1000; (xi - x)/(2 r^2 (r^2 + (xi - x)^2)) + atan((xi - x)/r)/(2 r^3)
// is an antiderivative. All points are within delta of P.
Ball cut_off_at_an_edge(const Rational& delta) {
  const auto kernel = line_function([delta]<class R>(const R& eta) -> R {
    const R z = from_rational<R>(delta / 1000);
    const R reach = from_rational<R>(delta / 2);
    const R square = eta * eta + z * z;
    const R r = sqrt(square);
    return eta * z * (reach / (square * (reach * reach + square)) + atan(reach / r) / (square * r));
  });
  return reflectivity() / Ball::pi() *
         known(integral_on_interval(kernel, Ball(0), Ball(delta / 2), {.radius = 1e-12}));
}

}  // namespace

Finding section_1_1_compact_square_integrable(const Bench&) {
  const BallPrecision precision(128);
  const Ball quarter(Rational(1, 4));
  const Ball area_of_sphere = Ball(4) * Ball::pi();
  const AtMost finite{.value = 1, .slack = 0, .why = ""};
  const AgreesWith is_rho{.value = reflectivity(), .within = 1e-25};
  Finding finding;
  finding.require("norm of Hilbert and Schmidt on the unit sphere, rho = 1/2", is_rho,
                  square_norm(quarter, area_of_sphere, area_of_sphere));
  finding.control("the same for half of the sphere, which is not closed", is_rho,
                  square_norm(quarter, area_of_sphere / Ball(2), area_of_sphere / Ball(2)));
  const Ball roof = area_of_the_roof();
  finding.require("bound of that norm on the roof of two_piece(2)", finite,
                  proved(square_norm(largest_on_the_roof(), roof, roof)));
  finding.require("bound of that norm between the square and the roof", finite,
                  proved(square_norm(ac98::largest_kernel_between_the_pieces(2, 1e-6), Ball(1), roof)));
  finding.control("lower bound of that norm on two squares that meet in an edge, strips to 2^-40", finite,
                  proved(square_norm_at_an_edge(40)));
  return finding;
}

Finding section_1_1_compact_continuous(const Bench&) {
  const BallPrecision precision(128);
  const AtMost below_delta{};
  Finding finding;
  for (const long k : {10, 20}) {
    const Rational delta = 1 / power(Rational(2), k);
    const std::string of = ", less delta = 2^-" + std::to_string(k);
    finding.require("norm of what is cut off on the unit sphere" + of, below_delta,
                    proved(cut_off(Ball(Rational(1, 4)), Ball::pi(), delta) - Ball(delta)));
    finding.require("norm of what is cut off on the roof of two_piece(2)" + of, below_delta,
                    proved(cut_off(largest_on_the_roof(), sqrt(Ball(5)) * Ball::pi(), delta) - Ball(delta)));
    finding.control("norm of what is cut off on two squares that meet in an edge" + of, below_delta,
                    proved(cut_off_at_an_edge(delta) - Ball(delta)));
  }
  return finding;
}

}  // namespace radcert::verification::m06
