// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/closed_form/point_to_polygon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "radcert/closed_form/kernel_moments.h"
#include "radcert/core/contract.h"
#include "radcert/scalar/mpfr_real.h"
#include "radcert/scalar/raised_precision.h"

namespace radcert {

namespace {

using Corner = ParameterPoint<Rational>;

/// All that is decided about P and the polygon, exactly. Corners are relative to the foot of P, in the
/// polygon's parameters.
struct Setting {
  Corner foot;
  Rational height;  ///< over |polygon normal|
  std::vector<PolygonLoop> loops;
  bool foot_outside = false;

  // Products of the polygon's frame f, g, of its normal f x g, and of n_P, not normalised.
  Rational first_squared;
  Rational first_second;
  Rational second_squared;
  Rational normal_squared;
  Rational p_normal_squared;
  Rational p_first;
  Rational p_second;
  Rational p_normal;
};

/// The part of a loop where `level` is not negative; edges along the cut remain.
template <class Level>
PolygonLoop clipped(const PolygonLoop& loop, const Level& level) {
  PolygonLoop kept;
  const auto keep = [&kept](Corner corner) {
    if (kept.empty() || !(kept.back() == corner)) kept.push_back(std::move(corner));
  };
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Corner& from = loop[k];
    const Corner& to = loop[(k + 1) % loop.size()];
    const Rational before = level(from);
    const Rational after = level(to);
    if (before.sign() >= 0) keep(from);
    if (before.sign() * after.sign() < 0) keep(from + (before / (before - after)) * (to - from));
  }
  while (kept.size() > 1 && kept.front() == kept.back()) kept.pop_back();
  // Two corners are an edge there and back: all line integrals over it are zero.
  if (kept.size() < 3) kept.clear();
  return kept;
}

/// How often the loops run around the origin; nothing where it lies on one of them.
std::optional<int> winding_number(const std::vector<PolygonLoop>& loops) {
  int winding = 0;
  for (const PolygonLoop& loop : loops) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Corner& from = loop[k];
      const Corner& to = loop[(k + 1) % loop.size()];
      // Above or below the origin a side neither holds it nor crosses the half-line to its right.
      if (from.t.sign() * to.t.sign() > 0) continue;
      const int side = cross(from, to).sign();
      if (side == 0 && (from.s * to.s + from.t * to.t).sign() <= 0) return std::nullopt;
      const bool from_above = from.t.sign() > 0;
      const bool to_above = to.t.sign() > 0;
      if (!from_above && to_above && side > 0) ++winding;
      if (from_above && !to_above && side < 0) --winding;
    }
  }
  return winding;
}

Setting setting(const Vector<Rational>& p, const Vector<Rational>& normal, const PlanePolygon& polygon,
                BehindTangentPlane behind) {
  Setting result;
  const Vector<Rational>& first = polygon.first();
  const Vector<Rational>& second = polygon.second();
  const Vector<Rational> plane_normal = polygon.normal();
  result.first_squared = dot(first, first);
  result.first_second = dot(first, second);
  result.second_squared = dot(second, second);
  result.normal_squared = dot(plane_normal, plane_normal);
  result.p_normal_squared = dot(normal, normal);
  result.p_first = dot(normal, first);
  result.p_second = dot(normal, second);
  result.p_normal = dot(normal, plane_normal);
  expects(result.p_normal_squared.sign() != 0, "a normal that is not zero");

  const Vector<Rational> offset = p - polygon.origin();
  result.foot = {dot(cross(offset, second), plane_normal) / result.normal_squared,
                 dot(cross(first, offset), plane_normal) / result.normal_squared};
  result.height = dot(offset, plane_normal) / result.normal_squared;
  for (PolygonLoop loop : polygon.loops()) {
    for (Corner& corner : loop) corner = corner - result.foot;
    result.loops.push_back(std::move(loop));
  }
  if (result.height.sign() == 0) {
    if (winding_number(result.loops) != 0) {
      const Vector<Rational> across = cross(normal, plane_normal);
      expects(across == Vector<Rational>{} && result.p_normal.sign() > 0,
              "P lies off the closed polygon, or has its normal", named("x", p.x), named("y", p.y),
              named("z", p.z));
    }
    result.loops.clear();
    return result;
  }
  if (behind == BehindTangentPlane::left_out) {
    const Rational base = result.height * result.p_normal;
    for (PolygonLoop& loop : result.loops) {
      loop = clipped(loop,
                     [&](const Corner& at) { return at.s * result.p_first + at.t * result.p_second - base; });
    }
    std::erase_if(result.loops, [](const PolygonLoop& loop) { return loop.empty(); });
  }
  // The formulas for a foot outside are good where P lies low against the distance of its foot.
  if (winding_number(result.loops) == 0) {
    const Rational squared_height = result.height * result.height * result.normal_squared;
    result.foot_outside = true;
    for (const PolygonLoop& loop : result.loops) {
      for (const Corner& at : loop) {
        const Rational distance = at.s * at.s * result.first_squared + 2 * at.s * at.t * result.first_second +
                                  at.t * at.t * result.second_squared;
        if (distance < squared_height) result.foot_outside = false;
      }
    }
  }
  return result;
}

/// One arithmetic's view of a setting: x along the first vector of the frame.
template <Real R>
class Frame {
public:
  explicit Frame(const Setting& from)
      : from_(from),
        first_length_(root(from.first_squared)),
        normal_length_(root(from.normal_squared)),
        p_length_(root(from.p_normal_squared)) {}

  [[nodiscard]] FootView<R> view() const {
    // The second axis is n x f / (|n| |f|), and n_P . (n x f) = (f.f)(n_P.g) - (f.g)(n_P.f) for n = f x g.
    const Rational along_second = from_.first_squared * from_.p_second - from_.first_second * from_.p_first;
    FootView<R> view;
    view.height = number(from_.height) * normal_length_;
    view.normal_x = number(from_.p_first) / (first_length_ * p_length_);
    view.normal_y = number(along_second) / (normal_length_ * first_length_ * p_length_);
    view.normal_z = number(from_.p_normal) / (normal_length_ * p_length_);
    view.foot_outside = from_.foot_outside;
    return view;
  }

  [[nodiscard]] FootEdge<R> edge(const Corner& from, const Corner& to) const {
    const Corner along = to - from;
    const Rational squared_length = product(along, along);
    const Rational turn = cross(from, along);
    const Rational start = product(from, along);
    const Rational end = product(to, along);
    const R length = root(squared_length);
    FootEdge<R> edge;
    edge.length = length;
    edge.direction_x = x(along) / length;
    edge.direction_y = y(along) / length;
    edge.distance = number(turn) * normal_length_ / length;
    edge.slant = root((turn * turn / squared_length + from_.height * from_.height) * from_.normal_squared);
    edge.start = number(start) / length;
    edge.end = number(end) / length;
    edge.start_x = x(from);
    edge.start_y = y(from);
    edge.end_x = x(to);
    edge.end_y = y(to);
    edge.distance_sign = turn.sign();
    edge.start_sign = start.sign();
    edge.end_sign = end.sign();
    return edge;
  }

  [[nodiscard]] PlaneSubstitution<R> substitution() const {
    const Rational slope = from_.first_second / from_.first_squared;
    return {.t_0 = number(from_.foot.t),
            .t_y = first_length_ / normal_length_,
            .s_0 = number(from_.foot.s + slope * from_.foot.t),
            .s_x = R(1) / first_length_,
            .s_t = number(-slope)};
  }

private:
  static R number(const Rational& value) { return from_rational<R>(value); }
  static R root(const Rational& value) {
    using std::sqrt;
    return sqrt(number(value));
  }
  [[nodiscard]] Rational product(const Corner& a, const Corner& b) const {
    return a.s * b.s * from_.first_squared + (a.s * b.t + a.t * b.s) * from_.first_second +
           a.t * b.t * from_.second_squared;
  }
  [[nodiscard]] R x(const Corner& at) const {
    return number(at.s * from_.first_squared + at.t * from_.first_second) / first_length_;
  }
  [[nodiscard]] R y(const Corner& at) const { return number(at.t) * normal_length_ / first_length_; }

  const Setting& from_;
  R first_length_;
  R normal_length_;
  R p_length_;
};

template <Real R>
std::vector<R> moments(const Setting& setting, int degree) {
  std::vector<R> result;
  result.reserve(PlanePolynomial<R>::size_of(degree));
  if (setting.loops.empty()) {
    result.assign(PlanePolynomial<R>::size_of(degree), R(0));
    return result;
  }
  const Frame<R> frame(setting);
  KernelMoments<R> sums(frame.view(), degree);
  for (const PolygonLoop& loop : setting.loops) {
    for (std::size_t k = 0; k < loop.size(); ++k) sums.add(frame.edge(loop[k], loop[(k + 1) % loop.size()]));
  }
  typename KernelMoments<R>::Table table = sums.finish();
  substitute(frame.substitution(), degree, table);
  for (int n = 0; n <= degree; ++n) {
    for (int j = 0; j <= n; ++j) {
      result.push_back(table[static_cast<std::size_t>(n - j)][static_cast<std::size_t>(j)]);
    }
  }
  return result;
}

void expect_degree(int degree) {
  expects(degree >= 0 && degree <= KernelMoments<Ball>::largest_degree, "a polynomial of degree at most 8",
          named("degree", degree));
}

Ball integral(const Setting& setting, const PlanePolynomial<Rational>& q) {
  const std::vector<Ball> values = moments<Ball>(setting, q.degree());
  Ball sum;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const Rational& coefficient = q.coefficients()[k];
    if (coefficient.sign() != 0) sum += Ball(coefficient) * values[k];
  }
  return sum;
}

}  // namespace

const WorkLimit most_bits_of_a_point("closed_form/point_to_polygon: bits", 1L << 16U,
                                     BallPrecision::smallest_bits, "refused, with the ball reached");

Ball point_to_polygon(const Vector<Rational>& p, const Vector<Rational>& normal, const PlanePolygon& polygon,
                      const PlanePolynomial<Rational>& q, BehindTangentPlane behind) {
  expect_degree(q.degree());
  return integral(setting(p, normal, polygon, behind), q);
}

Outcome<Ball> point_to_polygon_within(const Rational& radius, const Vector<Rational>& p,
                                      const Vector<Rational>& normal, const PlanePolygon& polygon,
                                      const PlanePolynomial<Rational>& q, BehindTangentPlane behind,
                                      long most_bits) {
  expect_degree(q.degree());
  expects(radius.sign() > 0, "radius > 0", named("radius", radius));
  const Setting decided = setting(p, normal, polygon, behind);
  constexpr long first_bits = 64;
  return at_raised_precision(
      std::min(first_bits, most_bits), most_bits, [&] { return integral(decided, q); },
      [&](const Ball& value) { return certainly_at_most(value.radius_ball(), Ball(radius).lower()); });
}

template <Real R>
std::vector<R> point_to_polygon_moments(const Vector<Rational>& p, const Vector<Rational>& normal,
                                        const PlanePolygon& polygon, int degree, BehindTangentPlane behind) {
  expect_degree(degree);
  return moments<R>(setting(p, normal, polygon, behind), degree);
}

template std::vector<double> point_to_polygon_moments(const Vector<Rational>&, const Vector<Rational>&,
                                                      const PlanePolygon&, int, BehindTangentPlane);
template std::vector<Mpfr<50>> point_to_polygon_moments(const Vector<Rational>&, const Vector<Rational>&,
                                                        const PlanePolygon&, int, BehindTangentPlane);
template std::vector<Ball> point_to_polygon_moments(const Vector<Rational>&, const Vector<Rational>&,
                                                    const PlanePolygon&, int, BehindTangentPlane);

}  // namespace radcert
