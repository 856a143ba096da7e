// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "radcert/scalar/ball.h"
#include "radcert/scalar/ball_precision.h"
#include "radcert/scalar/rational.h"
#include "radcert/scalar/real.h"

namespace radcert {

/// Judges of closed forms over plane polygons: enclosures that share nothing with the library but the
/// arithmetic of rationals and balls. Both cut the polygon by the tangent plane of P exactly, on their own.
namespace judge {

using Triple = std::array<Rational, 3>;
using Pair = std::array<Rational, 2>;
using Loop = std::vector<Pair>;

inline Rational dot(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Triple cross(const Triple& a, const Triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Triple minus(const Triple& a, const Triple& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// origin + s first + t second, (s, t) within the loops, outer ones counterclockwise, holes clockwise.
struct Polygon {
  Triple origin;
  Triple first;
  Triple second;
  std::vector<Loop> loops;

  [[nodiscard]] Triple point(const Pair& at) const {
    Triple result;
    for (std::size_t i = 0; i < 3; ++i) result[i] = origin[i] + at[0] * first[i] + at[1] * second[i];
    return result;
  }
};

inline Polygon triangle(const Triple& a, const Triple& b, const Triple& c) {
  return {a, minus(b, a), minus(c, a), {{{0, 0}, {1, 0}, {0, 1}}}};
}

/// What becomes of the part of a polygon behind the tangent plane.
enum class Behind { left_out, counted };

/// The loops where (Q - P) . n >= 0, or all of them.
inline std::vector<Loop> seen_loops(const Polygon& polygon, const Triple& p, const Triple& normal,
                                    Behind behind) {
  if (behind == Behind::counted) return polygon.loops;
  std::vector<Loop> result;
  for (const Loop& loop : polygon.loops) {
    Loop kept;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Pair& a = loop[k];
      const Pair& b = loop[(k + 1) % loop.size()];
      const Rational from = dot(minus(polygon.point(a), p), normal);
      const Rational to = dot(minus(polygon.point(b), p), normal);
      if (from.sign() >= 0) kept.push_back(a);
      if (from.sign() * to.sign() < 0) {
        const Rational share = from / (from - to);
        kept.push_back({a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])});
      }
    }
    if (kept.size() > 2) result.push_back(std::move(kept));
  }
  return result;
}

/// Int G dS by Lambert's formula in space: the angle that P sees of each edge, times the component along n_P
/// of the normal of the plane through P and the edge, halved; without 1/pi. P off the polygon's plane.
inline Ball lambert_integral(const Polygon& polygon, const Triple& p, const Triple& normal,
                             Behind behind = Behind::left_out) {
  Ball sum;
  for (const Loop& loop : seen_loops(polygon, p, normal, behind)) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Triple a = minus(polygon.point(loop[k]), p);
      const Triple b = minus(polygon.point(loop[(k + 1) % loop.size()]), p);
      const Triple across = cross(a, b);
      const Rational squared = dot(across, across);
      if (squared.sign() == 0) continue;
      const Ball length = sqrt(Ball(squared));
      const Rational along = dot(a, b);
      Ball angle = Ball::pi() / 2;
      if (along.sign() > 0) angle = atan(length / Ball(along));
      if (along.sign() < 0) angle = Ball::pi() - atan(length / Ball(-along));
      sum -= angle * Ball(dot(across, normal)) / length;
    }
  }
  return sum / (2 * sqrt(Ball(dot(normal, normal))));
}

/// Clenshaw and Curtis' rule on [-1, 1]: exact for the polynomial that interpolates in the extrema of a
/// Chebyshev polynomial.
struct ChebyshevRule {
  std::vector<Ball> nodes;
  std::vector<Ball> weights;

  explicit ChebyshevRule(int n) {
    for (int k = 0; k <= n; ++k) {
      nodes.push_back(cos(Ball::pi() * k / n));
      Ball sum = 1;
      for (int j = 1; j <= n / 2; ++j)
        sum -= Ball(j == n / 2 ? 1 : 2) / (4 * j * j - 1) * cos(Ball::pi() * (2 * j * k) / n);
      weights.push_back(sum * (k == 0 || k == n ? 1 : 2) / n);
    }
  }
  static const ChebyshevRule& of(int n) {
    thread_local std::map<std::pair<int, long>, ChebyshevRule> rules;
    const std::pair key{n, BallPrecision::current()};
    auto found = rules.find(key);
    if (found == rules.end()) found = rules.emplace(key, ChebyshevRule(n)).first;
    return found->second;
  }
};

/// Int G s^i t^j dS, i + j <= degree, by polar coordinates about the foot F of P: every edge AB spans a
/// triangle with F, of which F + lambda E(x), E(x) = A + x (B - A), runs over the points. With the kernel's
/// level l_F + lambda l_E(x), h the height and v = |E|^2 / h^2, the integral over lambda is a sum of K_m(v) =
/// Int_0^1 lambda^m / (1 + lambda^2 v)^2, in closed form. That over x is taken by the Chebyshev rule of n + 1
/// points on intervals about x_c so short that v changes by at most half of 1 + v(x_c) on the ellipse with
/// the sum of half axes 3: there |1 + lambda^2 v| is at least half of its value in x_c, |K_m| at most four
/// times K_m(v(x_c)), and a function bounded by M is off by at most 8 M 3^-n / 2 from its interpolant,
/// integrated over [-1, 1] (Trefethen, Approximation Theory and Approximation Practice, 2013, theorem 8.2).
class PolarIntegral {
public:
  PolarIntegral(const Polygon& polygon, const Triple& p, const Triple& normal, int degree, int points,
                Behind behind = Behind::left_out)
      : degree_(degree), points_(points) {
    const Triple plane_normal = cross(polygon.first, polygon.second);
    const Rational squared = dot(plane_normal, plane_normal);
    const Triple offset = minus(p, polygon.origin);
    const Rational height = dot(offset, plane_normal);
    foot_ = {dot(cross(offset, polygon.second), plane_normal) / squared,
             dot(cross(polygon.first, offset), plane_normal) / squared};
    squared_height_ = height * height / squared;
    gram_ = {dot(polygon.first, polygon.first), dot(polygon.first, polygon.second),
             dot(polygon.second, polygon.second)};
    level_ = {-height * dot(plane_normal, normal) / squared, dot(polygon.first, normal),
              dot(polygon.second, normal)};
    table_.resize(static_cast<std::size_t>((degree + 1) * (degree + 1)));
    if (height.sign() == 0) return;
    for (const Loop& loop : seen_loops(polygon, p, normal, behind)) {
      for (std::size_t k = 0; k < loop.size(); ++k)
        add_edge(about_foot(loop[k]), about_foot(loop[(k + 1) % loop.size()]));
    }
    const Ball factor = Ball(height / (squared_height_ * squared_height_)) / sqrt(Ball(dot(normal, normal)));
    for (Ball& entry : table_) entry = entry * factor;
  }

  /// Int G s^i t^j dS.
  [[nodiscard]] Ball moment(int i, int j) const {
    Ball sum;
    for (int a = 0; a <= i; ++a)
      for (int b = 0; b <= j; ++b)
        sum += Ball(binomial(i, a) * binomial(j, b) * power(foot_[0], i - a) * power(foot_[1], j - b)) *
               at(a, b);
    return sum;
  }

private:
  static Rational binomial(int n, int k) {
    Rational product = 1;
    for (int i = 1; i <= k; ++i) product = product * Rational(n - k + i) / Rational(i);
    return product;
  }
  [[nodiscard]] std::size_t place(int i, int j) const {
    return static_cast<std::size_t>(i * (degree_ + 1) + j);
  }
  [[nodiscard]] const Ball& at(int i, int j) const { return table_[place(i, j)]; }
  [[nodiscard]] Pair about_foot(const Pair& a) const { return {a[0] - foot_[0], a[1] - foot_[1]}; }

  /// v = curvature (x - lowest)^2 + least along the edge.
  struct Edge {
    std::array<Ball, 2> start;
    std::array<Ball, 2> along;
    Ball curvature;
    Ball lowest;
    Ball least;
    Ball weight;
    Ball level_start;
    Ball level_along;
  };

  void add_edge(const Pair& a, const Pair& b) {
    const Rational turn = a[0] * b[1] - a[1] * b[0];
    if (turn.sign() == 0) return;
    const Pair along{b[0] - a[0], b[1] - a[1]};
    const auto product = [this](const Pair& x, const Pair& y) {
      return x[0] * y[0] * gram_[0] + (x[0] * y[1] + x[1] * y[0]) * gram_[1] + x[1] * y[1] * gram_[2];
    };
    const Rational square = product(along, along);
    const Rational lowest = -product(a, along) / square;
    const Rational least = product(a, a) - square * lowest * lowest;
    Edge edge;
    for (std::size_t i = 0; i < 2; ++i) {
      edge.start[i] = Ball(a[i]);
      edge.along[i] = Ball(along[i]);
    }
    edge.curvature = Ball(square / squared_height_);
    edge.lowest = Ball(lowest);
    edge.least = Ball(least / squared_height_);
    edge.weight = Ball(turn);
    edge.level_start = Ball(level_[1] * a[0] + level_[2] * a[1]);
    edge.level_along = Ball(level_[1] * along[0] + level_[2] * along[1]);
    struct Part {
      Rational low;
      Rational high;
    };
    std::vector<Part> left{{0, 1}};
    constexpr std::size_t most = 2000;
    for (std::size_t done = 0; !left.empty(); ++done) {
      const Part part = left.back();
      left.pop_back();
      const Rational centre = (part.low + part.high) / Rational(2);
      const Rational half = (part.high - part.low) / Rational(2);
      const Ball v = value(edge, Ball(centre));
      const Ball reach = Ball(half) * 5 / 3;
      const Ball change =
          2 * edge.curvature * abs(Ball(centre) - edge.lowest) * reach + edge.curvature * reach * reach;
      if (certainly_at_most(change, (1 + v) / 2) || done > most) {
        add_part(edge, Ball(centre), Ball(half), v, done > most);
        continue;
      }
      left.push_back({part.low, centre});
      left.push_back({centre, part.high});
    }
  }

  static Ball value(const Edge& edge, const Ball& x) {
    return edge.curvature * power(x - edge.lowest, 2) + edge.least;
  }

  /// K_1, ..., K_count at [1], ...
  static std::vector<Ball> radial(const Ball& v, std::size_t count) {
    std::vector<Ball> k(count + 1);
    if (certainly_less(v, Ball(1) / 4)) {
      for (std::size_t m = 1; m <= count; ++m) {
        // Alternating, with terms that fall below a third of the one before.
        Ball sum;
        Ball power_of_v = 1;
        const long terms = BallPrecision::current() / 2 + 8;
        long n = 0;
        for (; n < terms && !certainly_zero(power_of_v); ++n) {
          sum += (n % 2 == 0 ? 1 : -1) * (n + 1) * power_of_v /
                 static_cast<long>(m + 1 + 2 * static_cast<std::size_t>(n));
          power_of_v *= v;
          if (power_of_v.upper_double() < 1e-300 && n > 4) break;
        }
        k[m] = widened(sum, (n + 2) * power_of_v);
      }
      return k;
    }
    const Ball root = sqrt(v);
    std::vector<Ball> line(count + 1);
    line[0] = atan(root) / root;
    if (count >= 1) line[1] = log(1 + v) / (2 * v);
    for (std::size_t m = 2; m <= count; ++m) line[m] = (1 / Ball(static_cast<long>(m - 1)) - line[m - 2]) / v;
    if (count >= 1) k[1] = 1 / (2 * (1 + v));
    if (count >= 2) k[2] = (line[0] - 1 / (1 + v)) / (2 * v);
    for (std::size_t m = 3; m <= count; ++m) k[m] = (line[m - 2] - k[m - 2]) / v;
    return k;
  }

  void add_part(const Edge& edge, const Ball& centre, const Ball& half, const Ball& v, bool failed) {
    const auto count = static_cast<std::size_t>(degree_) + 2;
    const ChebyshevRule& rule = ChebyshevRule::of(points_);
    std::vector<Ball> sums(table_.size());
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
      const Ball x = centre + half * rule.nodes[k];
      const std::vector<Ball> radials = radial(value(edge, x), count);
      add_products({edge.start[0] + x * edge.along[0], edge.start[1] + x * edge.along[1]}, Ball(level_[0]),
                   edge.level_start + x * edge.level_along, radials, rule.weights[k], sums);
    }
    const Ball reach = half * 5 / 3;
    std::vector<Ball> bounds(table_.size());
    const auto largest = [&](const Ball& start, const Ball& along) {
      return abs(start + centre * along) + reach * abs(along);
    };
    add_products({largest(edge.start[0], edge.along[0]), largest(edge.start[1], edge.along[1])},
                 abs(Ball(level_[0])), largest(edge.level_start, edge.level_along), radial(v, count), Ball(4),
                 bounds);
    const Ball tail = failed ? Ball::failed("too many intervals") : 4 * power(Ball(3), -points_);
    for (std::size_t k = 0; k < table_.size(); ++k)
      table_[k] += edge.weight * half * widened(sums[k], bounds[k] * tail);
  }

  void add_products(const std::array<Ball, 2>& e, const Ball& level, const Ball& level_e,
                    const std::vector<Ball>& radials, const Ball& weight, std::vector<Ball>& sums) const {
    Ball row = weight;
    for (int i = 0; i <= degree_; ++i) {
      Ball product = row;
      for (int j = 0; i + j <= degree_; ++j) {
        const auto m = static_cast<std::size_t>(i + j);
        sums[place(i, j)] += product * (level * radials[m + 1] + level_e * radials[m + 2]);
        product *= e[1];
      }
      row *= e[0];
    }
  }

  int degree_;
  int points_;
  Pair foot_;
  Rational squared_height_;
  std::array<Rational, 3> gram_;
  std::array<Rational, 3> level_;  ///< at the foot, and along first and second
  std::vector<Ball> table_;        ///< about the foot
};

}  // namespace judge
}  // namespace radcert
