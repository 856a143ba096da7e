// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/closed_form/polygon_to_polygon.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/geometry/vector.h"
#include "radcert/scalar/functions/dilogarithm.h"
#include "radcert/scalar/raised_precision.h"
#include "radcert/scalar/real.h"

// The integral over one pair of edges.
//
// P = P_0 + s a, Q = Q_0 + t b, 0 <= s, t <= 1, D = P - Q, w = |D|^2, D_st and w_st at the four pairs of
// ends. What enters is (a.b) Int Int log w ds dt. A constant that is added to log w, the same for all pairs
// of edges, changes nothing, since contours are closed; so the number -3 that both cases bring in is left
// out, and w is divided by one scale.
//
// Parallel edges, b = lambda a. r = |D x a| is the same all over. With x = D.a/a^2 and g = r/a^2 there is
// w = a^2 (x^2 + g^2), and
//   (a.b) Int Int log w = -a^2 Sum +- [ (x^2 - g^2)/2 log w + 2 g x atan(x/g) ],  + where s = t;
// the bracket is the second integral of log(x^2 + g^2) in x, but for 3/2 x^2.
//
// Other edges. n = a x b; the lines have the distance h = |D.n|/|n|, the same all over. The projection X of D
// on the plane of a, b runs over a parallelogram of area |n|, w = h^2 + |X|^2 and, by the theorem of Gauss
// with div(X log w) = 2 log w + 2 - 2 h^2/w,
//   |n| Int Int log w ds dt + 3 |n| = Sum over sides [ d/2 (tau log w + 2 rho atan(tau/rho)) + h^2 Lambda ].
// Here d is the signed distance of the origin from the side, tau runs along the side from the foot of the
// origin, rho^2 = d^2 + h^2, and with theta = atan(tau/|d|), kappa = (rho - |d|)/(rho + |d|)
//   Lambda = +-( theta log((rho + |d|)/h) + (Im Li_2(-e^(2 i theta)) - Im Li_2(-kappa e^(2 i theta)))/2 ),
// with the sign of d, is the integral of 1/w over the triangle between the origin and the side: in polar
// coordinates Int log(1 + d^2/(h cos x)^2)/2 dx, and cos^2 x + d^2/h^2 = |1 + kappa e^(2ix)|^2 / (4 kappa).
// A side through the origin has d = 0 and gives nothing, h = 0 takes Lambda away. Along the side parallel to
// a at the end t, with m = (D x a).n and r = |D x a|,
//   d = m/(|n||a|),  tau = D.a/|a|,  rho = r/|a|,  and the coefficients of log w are rational.

namespace radcert {

namespace {

using Point = Vector<Rational>;
using Contour = std::vector<Point>;

// The part of a closed polygonal line where normal.X >= offset, closed along the plane; empty unless it
// reaches above. A line that crosses the plane more than twice is closed by overlapping pieces, on which
// integrals along it cancel.
Contour part_in_front(const Contour& contour, const Vector<Rational>& normal, const Rational& offset) {
  Contour part;
  bool reaches_above = false;
  Rational here_height = dot(normal, contour.front()) - offset;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const Point& here = contour[i];
    const Point& next = contour[(i + 1) % contour.size()];
    const Rational next_height = dot(normal, next) - offset;
    if (here_height.sign() >= 0) part.push_back(here);
    if (here_height.sign() > 0) reaches_above = true;
    if (here_height.sign() * next_height.sign() < 0)
      part.push_back(here + (here_height / (here_height - next_height)) * (next - here));
    here_height = next_height;
  }
  if (!reaches_above) part.clear();
  return part;
}

// The contours of a polygon as far as they lie in front of the other.
std::vector<Contour> contours_in_front(const PlanePolygon& polygon, const PlanePolygon& other) {
  const Vector<Rational> normal = other.normal();
  const Rational offset = dot(normal, other.origin());
  std::vector<Contour> contours;
  for (const PolygonLoop& loop : polygon.loops()) {
    Contour contour;
    for (const ParameterPoint<Rational>& vertex : loop) contour.push_back(polygon.point(vertex));
    contour = part_in_front(contour, normal, offset);
    if (!contour.empty()) contours.push_back(std::move(contour));
  }
  return contours;
}

struct Edge {
  std::array<std::size_t, 2> ends;  ///< places of its end points in the list of vertices
  Vector<Rational> along;
  Rational squared_length;
};

struct Outline {
  explicit Outline(const std::vector<Contour>& contours) {
    for (const Contour& contour : contours) {
      const std::size_t first = vertices.size();
      vertices.insert(vertices.end(), contour.begin(), contour.end());
      for (std::size_t i = 0; i < contour.size(); ++i) {
        const std::array<std::size_t, 2> ends{first + i, first + (i + 1) % contour.size()};
        const Vector<Rational> along = vertices[ends[1]] - vertices[ends[0]];
        edges.push_back({ends, along, dot(along, along)});
      }
    }
  }

  std::vector<Point> vertices;
  std::vector<Edge> edges;
};

Ball ball(const Rational& value) { return Ball(value); }

// The sum over all pairs of edges.
class EdgePairs {
public:
  EdgePairs(const Outline& first, const Outline& second)
      : first_(first), second_(second), coefficients_(first.vertices.size() * second.vertices.size()) {
    for (const Edge& a : first_.edges)
      for (const Edge& b : second_.edges) add(a, b);
    add_logarithms();
  }

  const Ball& sum() const { return sum_; }

private:
  // D_st and what is needed of it.
  struct Difference {
    Vector<Rational> vector;
    Rational* log_coefficient;
  };
  using Differences = std::array<std::array<Difference, 2>, 2>;  ///< [s][t]

  void add(const Edge& a, const Edge& b) {
    const Rational product = dot(a.along, b.along);
    if (product.sign() == 0) return;
    Differences d;
    for (std::size_t s = 0; s < 2; ++s)
      for (std::size_t t = 0; t < 2; ++t)
        d[s][t] = {first_.vertices[a.ends[s]] - second_.vertices[b.ends[t]],
                   &coefficients_[a.ends[s] * second_.vertices.size() + b.ends[t]]};
    const Vector<Rational> n = cross(a.along, b.along);
    if (n == Vector<Rational>{}) {
      add_parallel(d, a);
      return;
    }
    const Rational height = dot(d[0][0].vector, n);
    const Lines lines{n, dot(n, n), abs(height), product};
    for (std::size_t end = 0; end < 2; ++end) {
      // Counterclockwise about n the sides are run through: t = 1 along a, t = 0 against it, s = 1 along b, s
      // = 0 against it.
      const int sign = end == 1 ? 1 : -1;
      add_side(lines, a, {d[0][end], d[1][end]}, sign);
      add_side(lines, b, {d[end][1], d[end][0]}, sign);
    }
  }

  void add_parallel(const Differences& d, const Edge& a) {
    const Vector<Rational> across = cross(d[0][0].vector, a.along);
    const Rational squared_r = dot(across, across);
    const bool one_line = squared_r.sign() == 0;
    const Ball r = sqrt(ball(squared_r));
    for (std::size_t s = 0; s < 2; ++s)
      for (std::size_t t = 0; t < 2; ++t) {
        const int sign = s == t ? -1 : 1;
        const Rational forward = dot(d[s][t].vector, a.along);
        *d[s][t].log_coefficient += sign * (forward * forward - squared_r) / (2 * a.squared_length);
        if (one_line || forward.sign() == 0) continue;
        sum_ += ball(2 * sign * forward / a.squared_length) * r * atan(ball(forward) / r);
      }
  }

  struct Lines {
    Vector<Rational> n;
    Rational squared_n;
    Rational height;   ///< h |n|
    Rational product;  ///< a.b
  };

  // One side of the parallelogram, parallel to `edge`, from its first end to its last.
  void add_side(const Lines& lines, const Edge& edge, const std::array<Difference, 2>& ends, int sign) {
    const Vector<Rational> across = cross(ends[0].vector, edge.along);
    const Rational m = dot(across, lines.n);
    if (m.sign() == 0) return;
    const Rational weight = sign * lines.product * m / (lines.squared_n * edge.squared_length);
    const Ball r = sqrt(ball(dot(across, across)));
    Ball angles = 0;
    for (std::size_t k = 0; k < 2; ++k) {
      const int end_sign = k == 1 ? 1 : -1;
      const Rational forward = dot(ends[k].vector, edge.along);
      *ends[k].log_coefficient += end_sign * weight * forward / 2;
      angles += end_sign * atan(ball(forward) / r);
    }
    sum_ += ball(weight) * r * angles;
    if (lines.height.sign() == 0) return;
    const Ball length_n = sqrt(ball(lines.squared_n));
    const Rational depth = abs(m);
    // h/(rho + |d|), the square root of kappa.
    const Ball root =
        sqrt(ball(lines.height * lines.height * edge.squared_length)) / (r * length_n + ball(depth));
    const Ball kappa = root * root;
    const Ball logarithm = -log(root);
    Ball triangle = 0;
    for (std::size_t k = 0; k < 2; ++k) {
      const int end_sign = k == 1 ? 1 : -1;
      const Ball theta = atan(ball(dot(ends[k].vector, edge.along) / depth) * length_n);
      const Ball turned = 2 * theta + Ball::pi();
      triangle += end_sign * (theta * logarithm +
                              (dilogarithm_imaginary(1, turned) - dilogarithm_imaginary(kappa, turned)) / 2);
    }
    sum_ += ball(sign * m.sign() * lines.product * lines.height * lines.height / lines.squared_n) / length_n *
            triangle;
  }

  void add_logarithms() {
    const std::size_t columns = second_.vertices.size();
    std::vector<Rational> squared_distances;
    Rational scale = 0;
    for (const Point& p : first_.vertices)
      for (const Point& q : second_.vertices) {
        squared_distances.push_back(dot(p - q, p - q));
        scale = std::max(scale, squared_distances.back());
      }
    for (std::size_t k = 0; k < first_.vertices.size() * columns; ++k) {
      // The coefficient of log 0 is 0: tau = 0, or x = g = 0.
      if (coefficients_[k].sign() == 0 || squared_distances[k].sign() == 0) continue;
      sum_ += ball(coefficients_[k]) * log(ball(squared_distances[k] / scale));
    }
  }

  const Outline& first_;
  const Outline& second_;
  std::vector<Rational> coefficients_;  ///< of log w for each pair of vertices
  Ball sum_ = 0;
};

}  // namespace

Ball polygon_to_polygon(const PlanePolygon& from, const PlanePolygon& to) {
  const Outline first(contours_in_front(from, to));
  const Outline second(contours_in_front(to, from));
  if (first.edges.empty() || second.edges.empty()) return 0;
  const Ball area = norm(Vector<Ball>{ball(from.normal().x), ball(from.normal().y), ball(from.normal().z)}) *
                    ball(from.parameter_area());
  return EdgePairs(first, second).sum() / (4 * Ball::pi() * area);
}

Outcome<Ball> polygon_to_polygon_within(const PlanePolygon& from, const PlanePolygon& to,
                                        const Rational& radius) {
  expects(radius.sign() > 0, "radius > 0", named("radius", radius));
  constexpr long first_bits = 128;  // fewer cost hardly less
  return at_raised_precision(
      std::min(first_bits, most_raised_bits.value()), most_raised_bits.value(),
      [&] { return polygon_to_polygon(from, to); },
      [&](const Ball& factor) { return certainly_at_most(factor.radius_ball(), Ball(radius)); });
}

}  // namespace radcert
