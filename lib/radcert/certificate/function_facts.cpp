// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/function_facts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/geometry/plane.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert::certificate {
namespace {

using Corners = std::vector<Vector<Rational>>;

/// The different corners of all faces.
Corners vertices_of(const PolyhedronCertificate& c) {
  Corners out;
  for (const Face& face : c.faces)
    for (const Vector<Rational>& corner : face.corners)
      if (std::find(out.begin(), out.end(), corner) == out.end()) out.push_back(corner);
  return out;
}

Rational squared_distance(const Vector<Rational>& p, const Vector<Rational>& q) { return dot(p - q, p - q); }

/// phi(x) of VertexMass, from x^2.
Ball half_cone(const Rational& square) {
  if (square > Rational(1)) return Ball(1);
  if (square == Rational(1)) return Ball(Rational(1, 2));
  const Ball sine = sqrt(Ball(square));
  const Ball cosine = sqrt(Ball(Rational(1) - square));
  return (atan(sine / cosine) - sine * cosine) / Ball::pi();
}

/// At most the square of the distance from its nearest vertex that a point of the element has: max over the
/// element, which is convex, of the distance from one vertex is taken at a corner.
Rational farthest_square(const PolyhedronCertificate& c, const Element& x, const Corners& vertices) {
  const Corners& corners = c.faces[x.face].corners;
  Vector<Rational> centre{0, 0, 0};
  for (const Vector<Rational>& corner : corners) centre = centre + corner;
  centre = Rational(1, static_cast<long>(corners.size())) * centre;
  const Vector<Rational>& a = corners[x.side];
  const Vector<Rational> along = corners[(x.side + 1) % corners.size()] - a;
  Corners own;
  for (const double s : {x.s0, x.s1})
    for (const double t : {x.t0, x.t1})
      own.push_back(a + (Rational::exactly(s) * (Rational(1) - Rational::exactly(t))) * along +
                    Rational::exactly(t) * (centre - a));
  Rational least;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    Rational most = 0;
    for (const Vector<Rational>& corner : own) most = std::max(most, squared_distance(corner, vertices[v]));
    least = v == 0 ? most : std::min(least, most);
  }
  return least;
}

/// R_m of function_fault.
std::vector<double> claims_by_distance(const PolyhedronCertificate& c) {
  const Corners vertices = vertices_of(c);
  std::vector<double> out(c.by_distance.size());
  for (std::size_t e = 0; e < c.elements.size(); ++e) {
    const Rational farthest = farthest_square(c, c.elements[e], vertices);
    for (std::size_t m = 0; m < out.size(); ++m)
      if (farthest >= c.by_distance[m].outside * c.by_distance[m].outside)
        out[m] = std::max(out[m], c.claims[e].largest);
  }
  return out;
}

/// masses[m][k - m - 1] >= T 1_B(r_(k-1)) on shell m, k > m.
std::vector<std::vector<Ball>> masses_of(const PolyhedronCertificate& c) {
  const VertexMass mass(c);
  std::vector<std::vector<Ball>> out(c.by_distance.size());
  for (std::size_t m = 0; m < out.size(); ++m)
    for (std::size_t k = m + 1; k < out.size(); ++k)
      out[m].push_back(mass(c.by_distance[k - 1].outside, c.by_distance[m].outside));
  return out;
}

Rational largest_reflectivity(const PolyhedronCertificate& c) {
  Rational largest = 0;
  for (const Face& face : c.faces) largest = std::max(largest, face.reflectivity);
  return largest;
}

std::string pointer_to(std::size_t m, const char* what) {
  return "/function/by_distance/" + std::to_string(m) + "/" + what;
}

/// Whether distances descend to 0 and bounds ascend, one of them at the distance that the width is of.
std::optional<Refusal> order_fault(const PolyhedronCertificate& c) {
  for (std::size_t m = 1; m < c.by_distance.size(); ++m) {
    if (!(c.by_distance[m].outside < c.by_distance[m - 1].outside))
      return Refusal{pointer_to(m, "outside"), "is not less than the one before"};
    if (c.by_distance[m].sup < c.by_distance[m - 1].sup)
      return Refusal{pointer_to(m, "sup"), "is less than the one before"};
  }
  if (c.by_distance.back().outside.sign() != 0)
    return Refusal{pointer_to(c.by_distance.size() - 1, "outside"), "is not 0, and is the last one"};
  for (const BoundAtDistance& bound : c.by_distance)
    if (bound.outside == c.outside)
      return Rational(2) * bound.sup > c.width
                 ? std::optional(Refusal{"/width", "is less than twice the bound at the distance `outside`"})
                 : std::nullopt;
  return Refusal{"/function/outside", "is not one of the distances at which bounds are stated"};
}

}  // namespace

VertexMass::VertexMass(const PolyhedronCertificate& c) {
  const Corners vertices = vertices_of(c);
  for (std::size_t v = 0; v < vertices.size(); ++v)
    for (std::size_t w = 0; w < v; ++w) {
      const Rational square = squared_distance(vertices[v], vertices[w]);
      if (least_square_.sign() == 0 || square < least_square_) least_square_ = square;
    }
  for (const Face& face : c.faces) {
    const Plane plane(face.corners[0], face.corners[1] - face.corners[0], face.corners[2] - face.corners[0]);
    AtPlane at;
    for (const Vector<Rational>& vertex : vertices) {
      const Rational height = dot(plane.normal(), vertex - face.corners[0]);
      if (height.sign() == 0)
        ++at.vertices;
      else
        at.inverse_squares += dot(plane.normal(), plane.normal()) / (height * height);
    }
    planes_.push_back(at);
  }
}

Ball VertexMass::operator()(const Rational& radius, const Rational& distance) const {
  expects(radius.sign() >= 0 && distance.sign() > 0, "0 <= radius, 0 < distance");
  const Rational square = radius * radius;
  const Rational from_nearest = distance * distance;
  const Ball nearest = half_cone(square / from_nearest);
  const Ball others = half_cone(Rational(4) * square / std::max(Rational(4) * from_nearest, least_square_));
  Ball most(0);
  for (const AtPlane& at : planes_)
    most = max(most, nearest + Ball(at.vertices - 1) * others + Ball(square * at.inverse_squares));
  return min(most, Ball(1));
}

std::optional<Refusal> function_fault(const PolyhedronCertificate& c) {
  if (std::optional<Refusal> fault = order_fault(c)) return fault;
  const std::vector<double> claims = claims_by_distance(c);
  const std::vector<std::vector<Ball>> masses = masses_of(c);
  const Ball s(largest_reflectivity(c));
  for (std::size_t m = 0; m < claims.size(); ++m) {
    // Y_m takes the place of Y_0 and what is added up to shell m, where B holds the shell.
    Ball sum(c.by_distance[m].sup);
    for (std::size_t k = m + 1; k < claims.size(); ++k)
      sum += Ball(c.by_distance[k].sup - c.by_distance[k - 1].sup) * masses[m][k - m - 1];
    const Ball needed = Ball(claims[m]) + s * sum;
    if (!certainly_at_most(needed, Ball(c.by_distance[m].sup)))
      return Refusal{pointer_to(m, "sup"), "is less than the claims prove, " + needed.to_text(12)};
  }
  return std::nullopt;
}

std::vector<Rational> bounds_by_distance(const PolyhedronCertificate& c) {
  const std::vector<double> claims = claims_by_distance(c);
  std::vector<std::vector<double>> masses;
  for (const std::vector<Ball>& row : masses_of(c)) {
    masses.emplace_back();
    for (const Ball& mass : row) masses.back().push_back(mass.upper_double());
  }
  const double gap = (Rational(1) - largest_reflectivity(c)).to_double();
  // Bounds that are so much larger than they need be stay bounds when each is rounded up by less.
  const double more = std::min(1e-6, 0.25 * gap);
  const double s = 1 - gap;
  std::vector<double> y(claims.size(), (1 + more) * claims.back() / (1 - s * (1 + more)) * (1 + 0x1p-40));
  constexpr int most_steps = 10000;
  constexpr double worth_a_step = 1e-4;
  for (int step = 0; step < most_steps; ++step) {
    std::vector<double> next(y.size());
    double change = 0;
    for (std::size_t m = 0; m < y.size(); ++m) {
      double sum = y[m];
      for (std::size_t k = m + 1; k < y.size(); ++k) sum += (y[k] - y[k - 1]) * masses[m][k - m - 1];
      next[m] = std::min(y[m], (1 + more) * (claims[m] + s * sum));
      if (y[m] > 0) change = std::max(change, 1 - next[m] / y[m]);
    }
    y = std::move(next);
    if (change < worth_a_step) break;
  }
  const int digits = std::min(17, static_cast<int>(std::ceil(-std::log10(more))) + 2);
  std::vector<Rational> out;
  for (const double bound : y)
    out.push_back(Rational::parse(upper_text(bound, DecimalForm::general(digits))).value());
  return out;
}

}  // namespace radcert::certificate
