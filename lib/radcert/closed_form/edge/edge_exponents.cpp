// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/closed_form/edge/edge_exponents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "radcert/closed_form/edge/edge_symbol_patch.h"
#include "radcert/core/contract.h"
#include "radcert/core/interrupt.h"
#include "radcert/core/work_limit.h"

namespace radcert {
namespace {

const WorkLimit halvings("closed_form/edge/edge_exponents: halvings towards the smallest exponent", 60, 2,
                         "refused, with the interval reached");
const WorkLimit most_boxes("closed_form/edge/edge_exponents: boxes in which exponents are counted", 40000, 1,
                           "refused: the exponents were not counted");
const WorkLimit most_terms("closed_form/edge/edge_exponents: terms of the series of all patches", 10'000'000,
                           1, "refused before any is summed up: the exponents were not counted");
const WorkLimit steps("closed_form/edge/edge_exponents: steps of Newton's method", 60, 1,
                      "refused, with the ball reached");

constexpr long bits_of_a_search = 80;

long bits_of(const Rational& radius) {
  long bits = 0;
  for (Rational unit = 1; unit > radius; unit = unit / Rational(2)) ++bits;
  return bits;
}

/// H(b) = R pi x b (b+1) F - s sin(pi b) at the precision at which it was made; the symbol is an EdgeSymbol
/// or a patch of one.
template <class Symbol>
class Characteristic {
public:
  Characteristic(Symbol symbol, const Edge& edge, int sign)
      : symbol_(std::move(symbol)),
        scale_(Ball::pi() * sqrt(Ball(edge.reflectivity * edge.other_reflectivity))),
        sign_(sign) {}

  SymbolValue operator()(const ComplexBall& b) const {
    const SymbolValue entire = symbol_.entire(b);
    const ComplexBall pi(Ball::pi());
    const ComplexBall s(sign_);
    return {.value = scale_ * entire.value - s * sin(pi * b),
            .slope = scale_ * entire.slope - s * pi * cos(pi * b)};
  }

private:
  Symbol symbol_;
  ComplexBall scale_;
  int sign_;
};

Characteristic<EdgeSymbol> characteristic(const Edge& edge, int sign) {
  return {EdgeSymbol(edge.angle()), edge, sign};
}

ComplexBall midpoint_of(const ComplexBall& b) { return {b.real().midpoint(), b.imag().midpoint()}; }

/// A ball with one zero in it, narrower: N(X) = m - H(m)/H'(X) contains every zero of X.
Outcome<ComplexBall> narrowed(const Edge& edge, int sign, ComplexBall zero, const Rational& radius) {
  const Ball wanted(radius);
  const auto is_narrow = [&](const ComplexBall& b) {
    return certainly_at_most(b.real().radius_ball(), wanted) &&
           certainly_at_most(b.imag().radius_ball(), wanted);
  };
  const BallPrecision precision(2 * bits_of(radius) + bits_of_a_search);
  const auto h = characteristic(edge, sign);
  for (long step = 0; !is_narrow(zero); ++step) {
    if (step == steps.value()) return because("Newton's method stands at " + zero.to_text());
    const ComplexBall middle = midpoint_of(zero);
    const ComplexBall next = middle - h(middle).value / h(zero).slope;
    if (!next.is_finite()) return because("Newton's method ends at " + zero.to_text());
    // Of a real zero the imaginary part stays 0.
    zero = zero.is_real() ? ComplexBall(intersection(zero.real(), next.real())) : intersection(zero, next);
  }
  return zero;
}

/// A closed box of the complex plane, with exact sides.
struct Box {
  Rational left, right, lower, upper;

  ComplexBall ball(const Rational& by = 0) const {
    const auto side = [&](const Rational& from, const Rational& to) {
      const Rational margin = (to - from) * by;
      return hull(Ball(from - margin), Ball(to + margin));
    };
    return {side(left, right), side(lower, upper)};
  }
};

std::pair<Box, Box> halves(const Box& box) {
  Box a = box;
  Box b = box;
  if (box.right - box.left >= box.upper - box.lower) {
    a.right = b.left = (box.left + box.right) / Rational(2);
  } else {
    a.upper = b.lower = (box.lower + box.upper) / Rational(2);
  }
  return {a, b};
}

/// Whether every point of an enclosure lies in the inside of another.
bool inside(const ComplexBall& a, const ComplexBall& b) {
  return a.is_finite() && b.is_finite() && certainly_less(b.real().lower(), a.real().lower()) &&
         certainly_less(a.real().upper(), b.real().upper()) &&
         certainly_less(b.imag().lower(), a.imag().lower()) &&
         certainly_less(a.imag().upper(), b.imag().upper());
}

struct Zero {
  ComplexBall at;
  ComplexBall alone_in;  ///< where H has no other
};

/// Krawczyk's operator on a box that is a little larger: the one zero there, or nothing.
template <class H>
std::optional<Zero> one_zero(const H& h, const Box& box) {
  const ComplexBall x = box.ball(Rational(1, 8));
  const ComplexBall slope = h(x).slope;
  if (!slope.is_finite() || slope.contains_zero()) return std::nullopt;
  const ComplexBall middle = midpoint_of(x);
  const ComplexBall inverse = midpoint_of(reciprocal(midpoint_of(slope)));
  if (!inverse.is_finite()) return std::nullopt;
  const ComplexBall image =
      middle - inverse * h(middle).value + (ComplexBall(1) - inverse * slope) * (x - middle);
  if (!inside(image, x)) return std::nullopt;
  Zero zero{.at = image, .alone_in = x};
  constexpr int enough =
      4;  // Newton's steps square the radius: zeros of overlapping boxes are compared by it
  for (int step = 0; step < enough; ++step) {
    const ComplexBall center = midpoint_of(zero.at);
    const ComplexBall next = center - h(center).value / h(zero.at).slope;
    if (next.is_finite()) zero.at = intersection(zero.at, next);
  }
  return zero;
}

template <class H>
bool has_none(const H& h, const ComplexBall& x) {
  const SymbolValue there = h(x);
  if (there.value.is_finite() && !there.value.contains_zero()) return true;
  if (!there.slope.is_finite()) return false;
  const ComplexBall middle = midpoint_of(x);
  const ComplexBall value = h(middle).value + there.slope * (x - middle);
  return value.is_finite() && !value.contains_zero();
}

/// Beyond which imaginary part there is no zero with 0 <= Re b <= up_to: see edge_exponents.
Rational imaginary_bound(const Edge& edge, const Rational& up_to) {
  const Ball angle = edge.angle();
  const Ball scale = Ball::pi() * sqrt(Ball(edge.reflectivity * edge.other_reflectivity));
  const auto hyperbolic = [](const Ball& x, int sign) { return (exp(x) + Ball(sign) * exp(-x)) / Ball(2); };
  Rational bound(1, 2);
  for (;;) {
    const Ball size(up_to + bound);
    const Ball t(bound);
    const Ball most = scale * size * hyperbolic((Ball::pi() - angle) * t, 1) / sin(angle / Ball(2));
    if (certainly_less(most, hyperbolic(Ball::pi() * t, -1)) && certainly_at_most(Ball(1), angle * size))
      return bound;
    bound = bound * Rational(5, 4);
  }
}

/// The zeros in a box and its parts, added to others; `left` counts the boxes that may still be looked at.
template <class H>
bool add_zeros(const H& h, const Box& all, std::vector<Zero>& zeros, long& left) {
  std::vector<Box> boxes{all};
  while (!boxes.empty()) {
    if (left-- == 0) return false;
    throw_if_interrupted();
    const Box box = boxes.back();
    boxes.pop_back();
    if (has_none(h, box.ball())) continue;
    if (std::optional<Zero> zero = one_zero(h, box)) {
      const bool is_known = std::any_of(zeros.begin(), zeros.end(), [&](const Zero& other) {
        return other.alone_in.contains(zero->at) || zero->alone_in.contains(other.at);
      });
      if (!is_known) zeros.push_back(*std::move(zero));
      continue;
    }
    auto [a, b] = halves(box);
    boxes.push_back(std::move(a));
    boxes.push_back(std::move(b));
  }
  return true;
}

constexpr std::array<int, 2> signs{1, -1};
using ZerosBySign = std::array<std::vector<Zero>, signs.size()>;

/// Parts of a rectangle on each of which the symbol is taken as a polynomial.
std::vector<Box> patches_of(const Box& rectangle) {
  const Rational patch_size(2);
  std::vector<Box> patches;
  std::vector<Box> large{rectangle};
  while (!large.empty()) {
    Box box = large.back();
    large.pop_back();
    if (box.right - box.left > patch_size || box.upper - box.lower > patch_size) {
      auto [a, b] = halves(box);
      large.push_back(std::move(a));
      large.push_back(std::move(b));
    } else {
      patches.push_back(std::move(box));
    }
  }
  return patches;
}

/// About how many terms the series of a patch takes: its bounds are products of 1 + |b|^2/n^2, at most
/// sinh(pi |b|)/(pi |b|), times x^n.
double expected_terms(const Box& patch, double x) {
  const double size = std::hypot(patch.right.to_double(), patch.upper.to_double());
  return (static_cast<double>(BallPrecision::current()) * std::numbers::ln2 + std::numbers::pi * size) /
         -std::log(x);
}

/// All zeros of H in the rectangle for either sign, and perhaps some beside it.
Outcome<ZerosBySign> zeros_in(const Edge& edge, const Box& rectangle,
                              const std::function<void(double)>& told) {
  const EdgeSymbol symbol(edge.angle());
  const std::vector<Box> patches = patches_of(rectangle);
  std::vector<double> terms;
  for (const Box& box : patches) terms.push_back(expected_terms(box, symbol.at_zero().to_double()));
  const double all = std::accumulate(terms.begin(), terms.end(), 0.0);
  if (!(all <= static_cast<double>(most_terms.value())))
    return because("the exponents were not counted: the series of the symbol over the " +
                   std::to_string(patches.size()) + " parts of the rectangle that may hold some would have " +
                   std::to_string(std::llround(all)) + " terms, more than " +
                   std::to_string(most_terms.value()) + ": the angle is too small or the size too large");
  ZerosBySign zeros;
  long left = most_boxes.value();
  double done = 0;
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const Box& box = patches[k];
    throw_if_interrupted();
    if (told) told(done / all);
    done += terms[k];
    const EdgeSymbolPatch patch(symbol, box.ball(Rational(1, 4)));
    for (std::size_t i = 0; i < signs.size(); ++i)
      if (!add_zeros(Characteristic<EdgeSymbolPatch>(patch, edge, signs.at(i)), box, zeros.at(i), left))
        return because("the exponents were not counted in " + std::to_string(most_boxes.value()) +
                       " boxes: some are too close, the angle is too small or the size too large");
  }
  return zeros;
}

ComplexBall conjugate(const ComplexBall& b) { return {b.real(), -b.imag()}; }

/// The whole number in a real ball, if there is one.
std::optional<long> whole_in(const Ball& b) {
  const long n = std::lround(b.to_double());
  if (b.contains(Rational(n))) return n;
  return std::nullopt;
}

/// Where R k < 1, as far to the right as a few halvings tell: left of it there is no exponent.
Outcome<Rational> start_of(const Edge& edge) {
  const auto h = characteristic(edge, 1);
  Rational start(1, 2);
  for (long halved = 0; halved <= halvings.value(); ++halved) {
    if (certainly_negative(h(ComplexBall(start)).value.real())) return start;
    start = start / Rational(2);
  }
  return because("the product of the reflectivities is too near to the largest for this angle");
}

/// Of the zeros for one sign those that are exponents of the size asked for.
Outcome<std::vector<EdgeExponent>> exponents_among(std::vector<Zero> zeros, const Edge& edge, int sign,
                                                   const Rational& up_to, const Rational& radius) {
  std::vector<EdgeExponent> out;
  for (Zero& zero : zeros) {
    // Real: the conjugate is a zero as well, and there is one alone.
    if (zero.at.imag().contains_zero() && zero.alone_in.contains(conjugate(zero.at)))
      zero.at = ComplexBall(zero.at.real());
    Outcome<ComplexBall> narrow = narrowed(edge, sign, zero.at, radius);
    if (!narrow) return because(narrow.reason());
    const Ball real = narrow->real();
    if (!narrow->is_real()) {
      if (certainly_negative(narrow->imag())) continue;
      if (!certainly_positive(narrow->imag()))
        return because("an exponent near " + narrow->to_text(12) + " may be real or not");
    } else if (const std::optional<long> n = whole_in(real)) {
      // At a right angle P_n'(0) = 0 for even n: there H vanishes, and k has no pole.
      if (edge.is_right_angled && *n % 2 == 0) continue;
      const BallPrecision precision(2 * bits_of(radius) + bits_of_a_search);
      if (characteristic(edge, sign)(ComplexBall(*n)).value.contains_zero())
        return because("whether " + std::to_string(*n) + " is an exponent was not decided");
    }
    if (certainly_less(Ball(up_to), real)) continue;
    if (!certainly_at_most(real, Ball(up_to)))
      return because("whether the exponent " + narrow->to_text(12) + " exceeds " + up_to.to_text() +
                     " was not decided");
    if (std::any_of(out.begin(), out.end(),
                    [&](const EdgeExponent& other) { return overlaps(other.value, *narrow); }))
      return because("two exponents near " + narrow->to_text(12) + " were not told apart");
    out.push_back({.value = *std::move(narrow), .symmetric = sign > 0});
  }
  return out;
}

/// Whether a search can tell the angle from 0 and from a straight one.
bool is_told_from_straight(const Edge& edge) {
  const BallPrecision precision(bits_of_a_search);
  const Ball angle = edge.angle();
  return certainly_positive(angle) && certainly_less(angle, Ball::pi());
}
constexpr std::string_view not_told = "the angle is too near to 180 degrees to be told from it";

void require(const Edge& edge) {
  expects(edge.reflectivity.sign() > 0 && edge.other_reflectivity.sign() > 0 &&
              edge.reflectivity < Rational(1) && edge.other_reflectivity < Rational(1),
          "reflectivities in (0, 1)", named("reflectivity", edge.reflectivity),
          named("other_reflectivity", edge.other_reflectivity));
}

}  // namespace

Edge edge_of_degrees(const Rational& degrees, const Rational& reflectivity,
                     const Rational& other_reflectivity) {
  expects(degrees.sign() > 0 && degrees < Rational(180), "0 < degrees < 180", named("degrees", degrees));
  return {.angle = [degrees] { return Ball::pi() * Ball(degrees / Rational(180)); },
          .is_right_angled = degrees == Rational(90),
          .reflectivity = reflectivity,
          .other_reflectivity = other_reflectivity};
}

Outcome<Ball> smallest_edge_exponent(const Edge& edge, const Rational& radius) {
  require(edge);
  expects(radius.sign() > 0, "radius > 0", named("radius", radius));
  if (!is_told_from_straight(edge)) return because(std::string(not_told));
  // sin(pi b) > 0 in (0, 1): H has the sign of R k - 1.
  Rational lower = 0;
  Rational upper = 1;
  const Rational enough(1, 1 << 12);
  {
    const BallPrecision precision(bits_of_a_search + halvings.value());
    const auto h = characteristic(edge, 1);
    for (long halved = 0;; ++halved) {
      // Newton's method may begin where the slope is known to be positive.
      if (upper - lower < enough && lower.sign() > 0 &&
          certainly_positive(h(ComplexBall(hull(Ball(lower), Ball(upper)))).slope.real()))
        break;
      const Rational middle = (lower + upper) / Rational(2);
      const Ball value = h(ComplexBall(middle)).value.real();
      if (halved == halvings.value() || !(certainly_positive(value) || certainly_negative(value)))
        return because("the smallest exponent lies in " + hull(Ball(lower), Ball(upper)).to_text());
      (certainly_positive(value) ? upper : lower) = middle;
    }
  }
  const BallPrecision precision(2 * bits_of(radius) + bits_of_a_search);
  const Outcome<ComplexBall> zero = narrowed(edge, 1, ComplexBall(hull(Ball(lower), Ball(upper))), radius);
  if (!zero) return because(zero.reason());
  return zero->real();
}

Outcome<std::vector<EdgeExponent>> edge_exponents(const Edge& edge, const Rational& up_to, int digits,
                                                  const std::function<void(double)>& told) {
  require(edge);
  expects(up_to.sign() > 0 && digits >= 1, "up_to > 0, digits >= 1", named("up_to", up_to),
          named("digits", digits));
  if (!is_told_from_straight(edge)) return because(std::string(not_told));
  const Rational radius = power(Rational(10), -digits);
  std::vector<EdgeExponent> all;
  Outcome<ZerosBySign> zeros = ZerosBySign{};
  {
    const BallPrecision precision(bits_of_a_search);
    const Outcome<Rational> start = start_of(edge);
    if (!start) return because(start.reason());
    if (*start >= up_to) return all;
    const Box rectangle{.left = *start, .right = up_to, .lower = 0, .upper = imaginary_bound(edge, up_to)};
    zeros = zeros_in(edge, rectangle, told);
    if (!zeros) return because(zeros.reason());
  }
  for (std::size_t i = 0; i < signs.size(); ++i) {
    Outcome<std::vector<EdgeExponent>> part =
        exponents_among(std::move(zeros->at(i)), edge, signs.at(i), up_to, radius);
    if (!part) return because(part.reason());
    for (EdgeExponent& exponent : *part) all.push_back(std::move(exponent));
  }
  std::sort(all.begin(), all.end(), [](const EdgeExponent& a, const EdgeExponent& b) {
    return a.value.real().to_double() < b.value.real().to_double();
  });
  return all;
}

}  // namespace radcert
