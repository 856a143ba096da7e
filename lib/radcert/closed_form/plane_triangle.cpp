// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/closed_form/plane_triangle.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "radcert/closed_form/bounded_pack.h"
#include "radcert/closed_form/kernel_moments.h"
#include "radcert/core/contract.h"

namespace radcert {

namespace {

using B = BoundedPack;

constexpr double unit = B::unit;
/// The part of the lengths that a product of twofold vectors may err by beside its last rounding: directions
/// are known to
/// 2^-100 times the quotient of the sides' product and the area, which is at most 2^20.
constexpr double direction_error = 0x1p-76;
constexpr double largest_quotient = 0x1p20;
/// Fourth powers of such lengths, and their products with tails, stay in the range of doubles.
constexpr double smallest_length = 1e-30;
constexpr double largest_length = 1e30;

struct TwofoldPack {
  Pack head;
  Pack tail;
};
struct TwofoldPackVector {
  std::array<Pack, 3> head;
  std::array<Pack, 3> tail;
};

TwofoldPack exact_sum(const Pack& a, const Pack& b) {
  const Pack sum = a + b;
  const Pack part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

/// direction . difference, rounded once; `size` bounds the product of the lengths.
B product(const TwofoldVector& direction, const TwofoldPackVector& difference, const Pack& size) {
  Pack sum(0);
  Pack tail(0);
  for (std::size_t i = 0; i < 3; ++i) {
    const Pack factor(direction.head[i]);
    const Pack head = factor * difference.head[i];
    const TwofoldPack next = exact_sum(sum, head);
    sum = next.head;
    tail += next.tail + fused(factor, difference.head[i], -head) +
            fused(factor, difference.tail[i], Pack(direction.tail[i]) * difference.head[i]);
  }
  const Pack value = sum + tail;
  return {value, fused(Pack(unit), abs(value), Pack(direction_error) * size)};
}

/// The same for a direction of doubles that are exact.
B product(const std::array<Pack, 3>& direction, const TwofoldPackVector& difference, const Pack& size) {
  Pack sum(0);
  Pack tail(0);
  for (std::size_t i = 0; i < 3; ++i) {
    const Pack head = direction[i] * difference.head[i];
    const TwofoldPack next = exact_sum(sum, head);
    sum = next.head;
    // The product's rounding first: it is exact, and would be lost in a sum with the tail's product.
    tail +=
        next.tail + fused(direction[i], difference.tail[i], fused(direction[i], difference.head[i], -head));
  }
  const Pack value = sum + tail;
  return {value, fused(Pack(unit), abs(value), Pack(direction_error) * size)};
}

/// A prepared number of vectors, its size at most `size`.
B stored(double value, double size) {
  return {Pack(value), Pack(unit * std::abs(value) + direction_error * size)};
}

/// direction . v for a twofold direction of unit length and an exact vector.
B component(const TwofoldVector& direction, const std::array<Pack, 3>& v, const Pack& size) {
  return product(direction, TwofoldPackVector{v, {Pack(0), Pack(0), Pack(0)}}, size);
}

TwofoldVector vector_of(const std::array<Twofold, 3>& a) {
  TwofoldVector result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.head[i] = a[i].head;
    result.tail[i] = a[i].tail;
  }
  return result;
}

using Exact = std::array<Twofold, 3>;

Exact side(const Vector<double>& from, const Vector<double>& to) {
  return {radcert::exact_sum(to.x, -from.x), radcert::exact_sum(to.y, -from.y),
          radcert::exact_sum(to.z, -from.z)};
}
Twofold dot(const Exact& a, const Exact& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Exact cross(const Exact& a, const Exact& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Exact divided(const Exact& a, const Twofold& by) { return {a[0] / by, a[1] / by, a[2] / by}; }

/// What the edges share for the logarithmic part.
struct LogarithmView {
  Pack height;      ///< |h|
  Pack reference;   ///< c
  Pack distance;    ///< of the foot from the triangle where c is not h, |h| where it is
  Pack logarithms;  ///< bounds |log(w / c^2)| over the triangle where c is not h, 0 where it is
  Pack height_error;
};

/// The edge's part of N_00: Int d log(w / c^2) / (2 rho^2) dt, rho^2 = d^2 + t^2, w = rho^2 + h^2.
/// Evaluated at the doubles d, t and h themselves, as KernelMoments does it; what their errors change is
/// bounded by the integral's own derivatives, which stay bounded where the parts' do not.
/// c = h: |F_t| <= |d| / (2 h rho), as log(1 + v) <= sqrt(v); |F_d| <= 1/2 Int log(1 + rho^2/h^2) / rho^2 dt
/// and |F_h| = Int |d| / (h w) dt, which are at most pi/h, and length / (h max(|d|, h)).
/// Otherwise the foot is at least `distance` >= h from the edge: |F_t| <= |log| |d| / (2 rho^2),
/// |F_d| <= (1 + |log|/2) Int dt / rho^2 and |F_h| <= Int h |d| / (rho^2 w) dt, where Int dt / rho^2 is at most
/// pi / distance, and length / max(|d|, distance)^2.
class LogarithmPart {
public:
  LogarithmPart(const LogarithmView& view, const B& distance) : view_(view), signed_(distance) {
    // As small a distance counts as much as its error; no logarithm of 0 then.
    constexpr double negligible = 0x1p-60;
    size_ = B::exactly(max(abs(distance.value()), Pack(negligible) * view.height));
    const B height = B::exactly(view.height);
    square_ = size_ * size_;
    square_slant_ = square_ + height * height;
    slant_ = sqrt(square_slant_);
    const B sum = slant_ + size_;
    excess_ = height * height / sum;
    const B quotient = height / sum;
    log_ratio_ = twice(log(quotient));  // log kappa
    log_size_ = log(twice(size_) / sum);
    log_sum_ = log(sum / B::exactly(view.reference));
  }

  [[nodiscard]] B between(const B& start, const B& end) const {
    const Part to = primitive(end.value());
    const Part from = primitive(start.value());
    B value = (to.theta - from.theta) * log_sum_ + (to.rest - from.rest);
    constexpr double slack = 1.1;
    // The edge's line may go through the foot, or nearly: F = Int F_d as far as d. Then 0 has the smaller
    // bound.
    const Pack most = Pack(slack * std::numbers::pi) * max(Pack(1), view_.logarithms) *
                      (abs(signed_.value()) + signed_.error()) / view_.distance;
    value = select(less(most, value.error()), B(Pack(0), most), value);
    const Pack line = abs(signed_.value()) + signed_.error();
    const Pack span = abs(end.value() - start.value()) + (end.error() + start.error());
    const Pack turn = min(Pack(std::numbers::pi), span / max(size_.value(), view_.distance));
    const Pack by_distance =
        turn * (fused(Pack(0.5) * view_.logarithms, signed_.error(), signed_.error()) + view_.height_error);
    const auto by_end = [&](const B& t) { return line / max(line, t.smallest_size()) * t.error(); };
    const Pack by_ends = Pack(0.5) * max(Pack(1), view_.logarithms) * (by_end(start) + by_end(end));
    const Pack passed = Pack(slack) * (by_distance + by_ends) / view_.distance;
    constexpr double small_distance = 0x1p-58;  // pi/h times the distance that stands for a smaller one
    const Pack error = value.error() + passed + Pack(small_distance) * (Pack(1) + view_.logarithms);
    return {select(less(signed_.value(), Pack(0)), -value.value(), value.value()), error};
  }

private:
  static B twice(const B& a) { return {a.value() + a.value(), a.error() + a.error()}; }
  static B halved(const B& a) { return {Pack(0.5) * a.value(), Pack(0.5) * a.error()}; }

  /// What an end contributes: theta log((a + d) / c) + rest.
  struct Part {
    B theta;
    B rest;
  };
  /// theta log((a + d) / c) + 1/2 Im [Li_2(z) - Li_2(e^(2 i psi))], z = kappa e^(2 i psi), tan psi = d / t.
  /// With log(1 - z) = log(2d / (a + d)) + 1/2 log(w / rho^2) - i beta, tan beta = t (a - d) / (a d + t^2); from
  /// -log(1 - z) or from -log z, whichever is smaller, by Li_2(z) + Li_2(1 - z) = pi^2/6 - log z log(1 - z).
  [[nodiscard]] Part primitive(const Pack& along) const {
    const B t = B::exactly(abs(along));
    const B t_square = t * t;
    const B rho_square = square_ + t_square;
    const AcuteAngles angles = acute_angles(t.value(), size_.value());
    const Pack exact(0.0);
    const B theta = B::acute(angles, exact);
    const B double_psi = twice(B::acute({angles.of_second, angles.of_first, angles.error}, exact));
    const B opposite = t * excess_;
    const B adjacent = slant_ * size_ + t_square;
    const B beta =
        B::acute(acute_angles(opposite.value(), adjacent.value()), Pack(quotient_roundings * unit));
    const B log_rim = halved(log(twice(twice(square_)) / rho_square));  // of 2 sin psi = |1 - e^(2 i psi)|
    const B log_other = log_size_ + halved(log((square_slant_ + t_square) / rho_square));  // |1 - z|

    const Pack near = fused(log_ratio_.value(), log_ratio_.value(), double_psi.value() * double_psi.value());
    const Pack far = fused(log_other.value(), log_other.value(), beta.value() * beta.value());
    const PackMask at_one = less(near, far);
    const B x = select(at_one, -log_ratio_, -log_other);
    const B y = select(at_one, double_psi, beta);
    const Pack series = dilogarithm_series(x.value(), y.value());
    // The derivative by w is w / (e^w - 1) = 1 - w/2 + w^2/12 - ...: its imaginary part, which multiplies the
    // error of x, is at most (1/2 + 1.06/6 + 0.01) |y|, its real part 1 + 1.06^2/12 + 0.01, and |x| / 2 more
    // where x < 0.
    constexpr double across = 0.7;
    constexpr double along_y = 1.11;
    constexpr double series_roundings = 6;
    const Pack turn = abs(y.value()) + y.error();
    const Pack slope = Pack(along_y) + Pack(0.5) * max(Pack(0), x.error() - x.value());
    const Pack series_error =
        fused(Pack(series_roundings * unit), turn, fused(Pack(across) * turn, x.error(), slope * y.error()));
    const B whole = B(series, series_error);
    const B correction = log_ratio_ * beta - double_psi * log_other;
    const B inside = select(at_one, whole + correction, whole);

    const Pack rest = clausen_rest(double_psi.value() * double_psi.value());
    constexpr double rest_roundings = 2;
    constexpr double rest_slope = 0.25;  // |E'| <= log(2) / pi
    const Pack rest_error = fused(Pack(rest_slope), double_psi.error(), Pack(rest_roundings * unit));
    const B rim = double_psi * (B(rest, rest_error) - log_rim);
    const B other = halved(inside - rim);
    const PackMask back = less(along, Pack(0));
    return {select(back, -theta, theta), select(back, -other, other)};
  }

  /// Of t (a - d) / (a d + t^2): 6 above and 5 below, as a has 2 and a + d has 3.
  static constexpr double quotient_roundings = 12;

  const LogarithmView& view_;
  B signed_;
  B size_;
  B square_;
  B square_slant_;
  B slant_;
  B excess_;  ///< a - d
  B log_ratio_;
  B log_size_;
  B log_sum_;
};

/// The value where a number's sign is not known: between both signs.
B with_sign_of(const B& sign, const B& a) {
  const PackMask known = less(sign.error(), abs(sign.value()));
  const Pack value = select(less(sign.value(), Pack(0)), -a.value(), a.value());
  return {select(known, value, Pack(0)), select(known, a.error(), abs(a.value()) + a.error())};
}

/// The edge's part of 2 h^2 M_00. Foot inside: d/a angle. Outside the angles at the foot may be taken away:
/// what is left,
/// with the difference of the two angles found as one, has h^2 as a factor.
B lambert_part(const FootEdge<B>& edge, const B& angle, const B& squared_height, const PackMask& outside) {
  const B inner = edge.distance / edge.slant * angle;
  if (outside.lanes() == 0) return inner;
  const B size{abs(edge.distance.value()), edge.distance.error()};
  const B excess = squared_height / (edge.slant + size);
  const B ends = edge.start * edge.end;
  const B both = edge.slant * size;
  const B opposite = edge.length * excess * (both - ends);
  const B adjacent =
      (size * size + ends) * (edge.slant * edge.slant + ends) + both * edge.length * edge.length;
  const B outer = atan2(opposite, adjacent) + excess / edge.slant * angle;
  return select(outside, -with_sign_of(edge.distance, outer), inner);
}

}  // namespace

TriangleFunctions::TriangleFunctions(const std::vector<PlanePolynomial<Rational>>& functions) {
  expects(!functions.empty(), "at least one function");
  for (const PlanePolynomial<Rational>& q : functions) degree_ = std::max(degree_, q.degree());
  expects(degree_ <= largest_degree, "functions of degree at most 3", named("degree", degree_));
  constexpr int steps = 8;
  constexpr double rounding = 0x1p-50;
  for (const PlanePolynomial<Rational>& q : functions) {
    Function function;
    Rational largest;
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; i + j <= steps; ++j) {
        largest = std::max(largest, abs(q.value(Rational(i, steps), Rational(j, steps))));
      }
    }
    expects(largest.sign() > 0, "functions that are not zero");
    function.maximum = largest.to_double() * (1 - rounding);
    for (const Rational& c : q.coefficients()) {
      function.coefficients.push_back(c.to_double());
      function.bound += std::abs(c.to_double()) * (1 + rounding);
    }
    function.coefficients.resize(PlanePolynomial<Rational>::size_of(degree_), 0.0);
    functions_.push_back(std::move(function));
  }
}

PlaneTriangle::PlaneTriangle(const Corners& corners, std::shared_ptr<const TriangleFunctions> functions,
                             double accuracy)
    : functions_(std::move(functions)), accuracy_(accuracy), corners_(corners) {
  expects(functions_ != nullptr && accuracy > 0, "functions, and an accuracy > 0",
          named("accuracy", accuracy));
  for (const Vector<double>& c : corners) {
    expects(std::isfinite(c.x + c.y + c.z), "finite numbers", named("x", c.x), named("y", c.y),
            named("z", c.z));
  }
  const std::array<Exact, 3> sides{side(corners[0], corners[1]), side(corners[1], corners[2]),
                                   side(corners[2], corners[0])};
  std::array<Twofold, 3> lengths;
  for (std::size_t k = 0; k < 3; ++k) {
    const Twofold squared = dot(sides[k], sides[k]);
    is_fair_ = is_fair_ && squared.head > smallest_length * smallest_length &&
               squared.head < largest_length * largest_length;
    if (!is_fair_) return;
    lengths[k] = sqrt(squared);
  }
  const Exact normal = cross(sides[0], side(corners[0], corners[2]));
  const Twofold normal_square = dot(normal, normal);
  const double least = lengths[0].head * lengths[2].head / largest_quotient;
  is_fair_ = normal_square.head > least * least;
  if (!is_fair_) return;
  const Exact z = divided(normal, sqrt(normal_square));
  const Exact x = divided(sides[0], lengths[0]);
  const Exact y = cross(z, x);
  axis_x_ = vector_of(x);
  axis_y_ = vector_of(y);
  axis_z_ = vector_of(z);
  for (std::size_t k = 0; k < 3; ++k) {
    const Exact direction = divided(sides[k], lengths[k]);
    edges_[k].direction = vector_of(direction);
    edges_[k].inward = vector_of(cross(z, direction));
    edges_[k].direction_x = dot(direction, x).head;
    edges_[k].direction_y = dot(direction, y).head;
    edges_[k].length = lengths[k].head;
  }
  edges_[0].direction_x = 1;
  edges_[0].direction_y = 0;
  const Exact apex = side(corners[0], corners[2]);
  apex_x_ = dot(apex, x).head;
  apex_y_ = dot(apex, y).head;
}

/// A block of points and what they see.
struct PlaneTriangle::Eye {
  std::array<TwofoldPackVector, 3> differences;  ///< P - corner
  Pack size;                                     ///< bounds their lengths
  B height;
  B normal_x;
  B normal_y;
  B normal_z;
  std::array<B, 3> levels;  ///< (corner - P) . n_P / |n_P|, or 0 where it is negligible or of unknown sign
  Pack undecided;           ///< bounds the sizes of such
  PackMask usable;
  PackMask unseen;
  PackMask cut;
};

PlaneTriangle::Eye PlaneTriangle::look(const Vector<Pack>& p, const Vector<Pack>& normal) const {
  const std::array<Pack, 3> point{p.x, p.y, p.z};
  const std::array<Pack, 3> n{normal.x, normal.y, normal.z};
  std::array<TwofoldPackVector, 3> differences;
  Pack size(0);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::array<double, 3> corner{corners_[k].x, corners_[k].y, corners_[k].z};
    Pack sum(0);
    for (std::size_t i = 0; i < 3; ++i) {
      const TwofoldPack d = exact_sum(point[i], Pack(-corner[i]));
      differences[k].head[i] = d.head;
      differences[k].tail[i] = d.tail;
      sum += abs(d.head);
    }
    size = max(size, sum);
  }
  size = Pack(2) * size;
  const Pack squared = fused(n[0], n[0], fused(n[1], n[1], n[2] * n[2]));
  const B length = sqrt(B::rounded(squared, 3));
  const Pack normal_size = Pack(2) * length.value();
  std::array<B, 3> levels;
  Pack undecided(0);
  PackMask any_seen;
  PackMask any_behind;
  PackMask all_behind = !any_seen;
  Pack largest(0);
  for (std::size_t k = 0; k < 3; ++k) {
    levels[k] = -product(n, differences[k], normal_size * size) / length;
    largest = max(largest, abs(levels[k].value()));
  }
  // A corner that close to the tangent plane counts as on it: the integral changes by the square of that.
  constexpr double negligible_level = 0x1p-30;
  for (B& level : levels) {
    const Pack bound = max(level.error(), Pack(negligible_level) * largest);
    const PackMask behind = less(level.value(), -bound);
    const PackMask seen = less(bound, level.value());
    const PackMask known = behind | seen;
    any_seen = any_seen | seen;
    any_behind = any_behind | behind;
    all_behind = all_behind & less(level.value(), -level.error());
    undecided = max(undecided, select(known, Pack(0), abs(level.value()) + level.error()));
    level = select(known, level, B(Pack(0), Pack(0)));
  }
  const PackMask in_range = less(Pack(smallest_length), size) & less(size, Pack(largest_length)) &
                            less(Pack(smallest_length * smallest_length), squared) &
                            less(squared, Pack(largest_length * largest_length));
  const B height = product(axis_z_, differences[0], size);
  const PackMask off_plane =
      less(height.error(), abs(height.value())) & less(Pack(smallest_length), abs(height.value()));
  return {differences,
          size,
          height,
          component(axis_x_, n, normal_size) / length,
          component(axis_y_, n, normal_size) / length,
          component(axis_z_, n, normal_size) / length,
          levels,
          undecided,
          in_range & off_plane & any_seen,
          in_range & all_behind,
          in_range & off_plane & any_seen & any_behind};
}

template <int degree, bool is_cut>
unsigned PlaneTriangle::closed_form(const Eye& eye, std::span<Pack> values) const {
  constexpr std::size_t edge_count = is_cut ? 4 : 3;
  constexpr bool has_logarithms = degree > 0;
  const Pack zero(0);
  const B nothing(zero, zero);
  const B squared_height = eye.height * eye.height;
  // P's coordinates about c_0.
  const B p_x = product(axis_x_, eye.differences[0], eye.size);
  const B p_y = product(axis_y_, eye.differences[0], eye.size);
  const double side = edges_[2].length;
  const std::array<B, 3> corner_x{-p_x, stored(edges_[0].length, 0) - p_x, stored(apex_x_, side) - p_x};
  const std::array<B, 3> corner_y{-p_y, -p_y, stored(apex_y_, side) - p_y};

  std::array<FootEdge<B>, edge_count> edges;
  std::array<PackMask, edge_count> empty;
  // Where the visible part's boundary leaves the triangle's and where it comes back.
  B leaves_x = nothing;
  B leaves_y = nothing;
  B returns_x = nothing;
  B returns_y = nothing;
  Pack farthest_out = zero;  // the largest of -d: the foot is as far from the triangle
  Pack its_error = zero;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    FootEdge<B>& edge = edges[k];
    edge.direction_x = k == 0 ? B(1) : stored(edges_[k].direction_x, 1);
    edge.direction_y = k == 0 ? B(0) : stored(edges_[k].direction_y, 1);
    edge.distance = k == 0 ? p_y : product(edges_[k].inward, eye.differences[k], eye.size);
    edge.slant = sqrt(edge.distance * edge.distance + squared_height);
    edge.length = stored(edges_[k].length, 0);
    edge.start = k == 0 ? -p_x : -product(edges_[k].direction, eye.differences[k], eye.size);
    edge.end = edge.start + edge.length;
    edge.start_x = corner_x[k];
    edge.start_y = corner_y[k];
    edge.end_x = corner_x[next];
    edge.end_y = corner_y[next];
    const PackMask farther = less(farthest_out, -edge.distance.value());
    farthest_out = select(farther, -edge.distance.value(), farthest_out);
    its_error = max(its_error, edge.distance.error());
    if constexpr (is_cut) {
      const B& from = eye.levels[k];
      const B& to = eye.levels[next];
      const PackMask from_unseen = less(from.value(), zero);
      const PackMask to_unseen = less(to.value(), zero);
      const PackMask leaves = !from_unseen & to_unseen;
      const PackMask returns = from_unseen & !to_unseen;
      const PackMask crosses = leaves | returns;
      const B share =
          select(crosses, from, nothing) / (select(crosses, from, B(1)) - select(crosses, to, nothing));
      const B cut_t = edge.start + share * edge.length;
      const B cut_x = edge.start_x + share * (edge.end_x - edge.start_x);
      const B cut_y = edge.start_y + share * (edge.end_y - edge.start_y);
      edge.start = select(returns, cut_t, edge.start);
      edge.start_x = select(returns, cut_x, edge.start_x);
      edge.start_y = select(returns, cut_y, edge.start_y);
      edge.end = select(leaves, cut_t, edge.end);
      edge.end_x = select(leaves, cut_x, edge.end_x);
      edge.end_y = select(leaves, cut_y, edge.end_y);
      const B shorter = select(leaves, share, B(1) - share) * edge.length;
      edge.length = select(crosses, shorter, edge.length);
      empty[k] = from_unseen & to_unseen;
      leaves_x = select(leaves, cut_x, leaves_x);
      leaves_y = select(leaves, cut_y, leaves_y);
      returns_x = select(returns, cut_x, returns_x);
      returns_y = select(returns, cut_y, returns_y);
    }
  }
  if constexpr (is_cut) {
    // Along the tangent plane, with the normal's part in the polygon's plane to the left.
    FootEdge<B>& edge = edges[3];
    const B slope = sqrt(eye.normal_x * eye.normal_x + eye.normal_y * eye.normal_y);
    edge.direction_x = eye.normal_y / slope;
    edge.direction_y = -eye.normal_x / slope;
    edge.distance = -(eye.height * eye.normal_z) / slope;
    edge.slant = sqrt(edge.distance * edge.distance + squared_height);
    edge.start = edge.direction_x * leaves_x + edge.direction_y * leaves_y;
    edge.end = edge.direction_x * returns_x + edge.direction_y * returns_y;
    edge.length = edge.end - edge.start;
    // Positive exactly, as an angle's sine asks for.
    edge.length = {max(zero, edge.length.value()), edge.length.error()};
    edge.start_x = leaves_x;
    edge.start_y = leaves_y;
    edge.end_x = returns_x;
    edge.end_y = returns_y;
    const PackMask farther = less(farthest_out, -edge.distance.value());
    farthest_out = select(farther, -edge.distance.value(), farthest_out);
    its_error = max(its_error, edge.distance.error());
  }

  const Pack height = abs(eye.height.value());
  // Nearer than its height the foot may count as inside: nothing cancels there, and no edge's line comes
  // close to it from an unknown side.
  const PackMask outside = less(height + its_error, farthest_out);
  LogarithmView logarithms;
  if constexpr (has_logarithms) {
    Pack largest = zero;
    Pack sum = zero;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& d = eye.differences[k].head;
      const Pack w = fused(d[0], d[0], fused(d[1], d[1], d[2] * d[2]));
      largest = max(largest, w);
      sum += w;
    }
    const Pack mean = sum * Pack(1.0 / 3);
    const Pack distance = farthest_out - its_error;
    const Pack least = fused(distance, distance, height * height);
    // log v <= sqrt(v) for v >= 1.
    constexpr double rounding = 1.01;
    const Pack bound = Pack(rounding) * sqrt(max(largest / mean, mean / least));
    logarithms = {height, select(outside, sqrt(mean), height), select(outside, distance, height),
                  select(outside, bound, zero), eye.height.error()};
  }

  FootView<B> view;
  view.height = eye.height;
  view.normal_x = eye.normal_x;
  view.normal_y = eye.normal_y;
  view.normal_z = eye.normal_z;
  KernelMoments<B, std::max(degree, 1)> sums(view, degree);
  for (std::size_t k = 0; k < edge_count; ++k) {
    FootEdge<B>& edge = edges[k];
    EdgeIntegrals<B> found;
    const B squared_slant = edge.slant * edge.slant;
    found.angle = atan2(edge.slant * edge.length, squared_slant + edge.start * edge.end);
    found.lambert = lambert_part(edge, found.angle, squared_height, outside);
    if constexpr (has_logarithms) {
      found.logarithm = LogarithmPart(logarithms, edge.distance).between(edge.start, edge.end);
      const B rise = log((squared_slant + edge.end * edge.end) / (squared_slant + edge.start * edge.start));
      found.rise = {Pack(0.5) * rise.value(), Pack(0.5) * rise.error()};
    }
    if constexpr (is_cut) {
      found.angle = select(empty[k], nothing, found.angle);
      found.lambert = select(empty[k], nothing, found.lambert);
      found.logarithm = select(empty[k], nothing, found.logarithm);
      found.rise = select(empty[k], nothing, found.rise);
      edge.length = select(empty[k], nothing, edge.length);
      edge.end = select(empty[k], edge.start, edge.end);
      edge.end_x = select(empty[k], edge.start_x, edge.end_x);
      edge.end_y = select(empty[k], edge.start_y, edge.end_y);
    }
    sums.add(edge, found);
  }
  auto table = sums.finish();

  // Corners next to the tangent plane were taken to be on it: where the level is that small, at most this
  // part of the area, |G| is at most |h| level / w^2.
  const Pack range = max(eye.levels[0].value(), max(eye.levels[1].value(), eye.levels[2].value()));
  const Pack away = max(zero, farthest_out - its_error);
  const Pack least_square = fused(away, away, height * height);
  const Pack area(0.5 * edges_[0].length * apex_y_);
  const Pack undecided = Pack(4) * height * area * eye.undecided * min(Pack(1), eye.undecided / range) /
                         (least_square * least_square);

  const B whole = table[0][0];
  const Pack least = Pack(accuracy_) * max(zero, abs(whole.value()) - (whole.error() + undecided));
  if constexpr (degree > 0) {
    const B to_s = B::rounded(Pack(1 / edges_[0].length), 2);
    const B to_t = B(1) / stored(apex_y_, side);
    substitute(PlaneSubstitution<B>{.t_0 = p_y * to_t,
                                    .t_y = to_t,
                                    .s_0 = p_x * to_s,
                                    .s_x = to_s,
                                    .s_t = stored(-apex_x_, side) * to_s},
               degree, table);
  }
  PackMask good = less(zero, least);
  const std::vector<TriangleFunctions::Function>& functions = functions_->functions();
  for (std::size_t k = 0; k < functions.size(); ++k) {
    const TriangleFunctions::Function& q = functions[k];
    B sum = B::rounded(Pack(q.coefficients[0])) * whole;
    std::size_t place = 1;
    for (std::size_t n = 1; n <= static_cast<std::size_t>(degree); ++n) {
      for (std::size_t j = 0; j <= n; ++j) {
        const double c = q.coefficients[place++];
        if (c != 0) sum = sum + B::rounded(Pack(c)) * table[n - j][j];
      }
    }
    good = good & at_most(fused(Pack(q.bound), undecided, sum.error()), Pack(q.maximum) * least);
    values[k] = sum.value();
  }
  return good.lanes();
}

template <int degree>
unsigned PlaneTriangle::served(const Vector<Pack>& p, const Vector<Pack>& normal,
                               std::span<Pack> values) const {
  const Eye eye = look(p, normal);
  const unsigned unseen = eye.unseen.lanes();
  const unsigned cut = eye.cut.lanes();
  const unsigned whole = eye.usable.lanes() & ~cut;
  unsigned good = 0;
  if (whole != 0) good = closed_form<degree, false>(eye, values) & whole;
  if (cut != 0) {
    std::array<Pack, 16> others;
    const std::span<Pack> clipped(others.data(), values.size());
    const unsigned served = closed_form<degree, true>(eye, clipped) & cut;
    for (std::size_t k = 0; k < values.size(); ++k) {
      values[k] = whole == 0 ? clipped[k] : select(eye.cut, clipped[k], values[k]);
    }
    good |= served;
  }
  for (Pack& value : values) {
    for (std::size_t i = 0; i < Pack::lanes; ++i) {
      if ((good >> i & 1U) == 0) value.set_lane(i, 0);
    }
  }
  return good | unseen;
}

unsigned PlaneTriangle::integrals(const Vector<Pack>& p, const Vector<Pack>& normal,
                                  std::span<Pack> values) const {
  expects(values.size() == function_count(), "a value for every function", named("values", values.size()));
  if (!is_fair_) {
    std::fill(values.begin(), values.end(), Pack(0));
    return 0;
  }
  switch (functions_->degree()) {
    case 0: return served<0>(p, normal, values);
    case 1: return served<1>(p, normal, values);
    case 2: return served<2>(p, normal, values);
    default: return served<3>(p, normal, values);
  }
}

bool PlaneTriangle::integrals(const Vector<double>& p, const Vector<double>& normal,
                              std::span<double> values) const {
  expects(values.size() == function_count(), "a value for every function", named("values", values.size()));
  std::vector<Pack> block(values.size());
  const unsigned served = integrals(Vector<Pack>{Pack(p.x), Pack(p.y), Pack(p.z)},
                                    Vector<Pack>{Pack(normal.x), Pack(normal.y), Pack(normal.z)}, block);
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = block[k].lane(0);
  return (served & 1U) != 0;
}

}  // namespace radcert
