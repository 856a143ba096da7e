// SPDX-License-Identifier: GPL-3.0-or-later

// Lemma 1 (b). The lemma as it is printed asks of S no more than smoothness and the divergence theorem: then
// it fails. With the V = 1 of section 1.1, "the case that we will consider here", it holds for every S that
// bounds a body: let G(P,Q) < 0, so that one of (Q-P).n_P and (P-Q).n_Q is positive and the other one
// negative, say the first positive. n_P points inwards: the open segment from P to Q is inside the body near
// P and outside near Q. So it meets S, and V(P,Q) = 0.
//
// Checked      lemma_1_b: G = -1/4 between the points (3/2,0,0) and (-1/2,0,0) of the torus of radius 1 and
//              tube radius 1/2, a smooth closed surface that bounds a body, exactly; G >= 0 for the pairs of
//              a grid of the unit sphere, which lies in the boundary of a convex body as the paper's
//              unoccluded surfaces do. lemma_1_b_unoccluded: for the pairs of points of faces of the L-shaped
//              room and the dented octahedron, all that have G < 0 have a face between them, exactly; the
//              segment of the torus meets it in (1/2,0,0). Pairs with G > 0 need not.
// Not checked  other bodies and points, but by the proof above.

#include <algorithm>

#include "radcert/kernel/geometric_kernel.h"
#include "verification/claims/m06/section_1/non_convex_bodies.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

constexpr AtMost never_negative{};

// -G as a proved number.
Approximation minus_kernel(const Vector<Rational>& p, const Vector<Rational>& normal_p,
                           const Vector<Rational>& q, const Vector<Rational>& normal_q) {
  // Exact: G is a dyadic fraction for the points that are used.
  return {
      .value = 0 - geometric_kernel(p, normal_p, q, normal_q).to_double(), .radius = 0, .guaranteed = true};
}

Vector<Rational> on_the_sphere(long a, long b) {
  const Rational squares = Rational(a * a + b * b);
  return {Rational(2 * a) / (squares + 1), Rational(2 * b) / (squares + 1), (squares - 1) / (squares + 1)};
}

Rational negative_pairs_on_the_sphere() {
  constexpr long range = 4;
  long count = 0;
  for (long a = -range; a <= range; ++a)
    for (long b = -range; b <= range; ++b)
      for (long c = -range; c <= range; ++c) {
        const Vector<Rational> p = on_the_sphere(a, b);
        const Vector<Rational> q = on_the_sphere(c, 7);
        if (geometric_kernel(p, -p, q, -q) < 0) ++count;
      }
  return {count};
}

// Whether the open segment from p to q meets a face in one point.
bool crosses(const PlanePolygon& face, const Vector<Rational>& p, const Vector<Rational>& q) {
  const Rational falling = dot(q - p, face.normal());
  if (falling == 0) return false;
  const Rational part = dot(face.origin() - p, face.normal()) / falling;
  if (part <= 0 || 1 <= part) return false;
  // The parameters of the point: (X - origin) = s first + t second, by Cramer's rule.
  const Vector<Rational> x = p + part * (q - p) - face.origin();
  const Rational a = dot(face.first(), face.first());
  const Rational b = dot(face.first(), face.second());
  const Rational c = dot(face.second(), face.second());
  const Rational f = dot(x, face.first());
  const Rational g = dot(x, face.second());
  const Rational determinant = a * c - b * b;
  const ParameterPoint<Rational> at{(f * c - g * b) / determinant, (a * g - b * f) / determinant};
  return contains(face.loops().front(), at);
}

// Points of faces in pairs, by the sign of G and by whether a face lies between them.
struct Pairs {
  long negative = 0;
  long negative_and_open = 0;
  long positive_and_open = 0;
};

Pairs pairs_of(const NonConvexBody& body) {
  constexpr std::size_t most_corners = 4;  // of a face that is convex, so that all its points can be taken
  const auto points = [&body](std::size_t face) {
    const std::size_t corners = body.faces[face].loops().front().size();
    std::vector<Vector<Rational>> all;
    for (std::size_t i = 0; i < (corners <= most_corners ? corners : 1); ++i)
      all.push_back(point_of_face(body, face, i));
    return all;
  };
  Pairs count;
  for (std::size_t i = 0; i < body.faces.size(); ++i)
    for (std::size_t j = 0; j < body.faces.size(); ++j) {
      if (i == j) continue;
      for (const Vector<Rational>& p : points(i))
        for (const Vector<Rational>& q : points(j)) {
          const Rational g = geometric_kernel(p, body.faces[i].normal(), q, body.faces[j].normal());
          const bool open = std::none_of(body.faces.begin(), body.faces.end(),
                                         [&](const PlanePolygon& face) { return crosses(face, p, q); });
          if (g < 0) ++count.negative;
          if (g < 0 && open) ++count.negative_and_open;
          if (g > 0 && open) ++count.positive_and_open;
        }
    }
  return count;
}

// 0 on the torus of radius 1 and tube radius 1/2, for points with y = 0.
Rational torus_equation(const Rational& x, const Rational& z) {
  const Rational from_circle = abs(x) - 1;
  return from_circle * from_circle + z * z - Rational(1, 4);
}

}  // namespace

Finding lemma_1_b(const Bench&) {
  Finding finding;
  const Rational half(1, 2);
  const Rational three_halves(3, 2);
  finding.require("-G between two points of the torus of radius 1 and tube radius 1/2", never_negative,
                  minus_kernel({three_halves, 0, 0}, {-1, 0, 0}, {-half, 0, 0}, {-1, 0, 0}));
  finding.instead("pairs of a grid of the unit sphere with G < 0", IsExactly{0},
                  negative_pairs_on_the_sphere());
  finding.instead("-G between floor and ceiling of the unit cube, a convex body", never_negative,
                  minus_kernel({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, -1}));
  finding.control("-G between floor and ceiling of the unit cube, one of the normals outwards",
                  never_negative, minus_kernel({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}));
  return finding;
}

Finding lemma_1_b_unoccluded(const Bench&) {
  const IsExactly none{0};
  Finding finding;
  for (const NonConvexBody& body : {l_shaped_room(), dented_octahedron()}) {
    const Pairs pairs = pairs_of(body);
    finding.require("pairs of points of faces with G < 0 and no face between them, " + body.name, none,
                    Rational(pairs.negative_and_open));
    // Otherwise the line above would say nothing.
    finding.require("whether there is no pair with G < 0 at all, " + body.name, none,
                    pairs.negative == 0 ? 1 : 0);
    finding.control("pairs of points of faces with G > 0 and no face between them, " + body.name, none,
                    Rational(pairs.positive_and_open));
  }
  // From (3/2,0,0) to (-1/2,0,0) the middle is (1/2,0,0).
  const Rational middle = (Rational(3, 2) - Rational(1, 2)) / 2;
  finding.require("equation of the torus at the middle between its two points", none,
                  torus_equation(middle, 0));
  finding.control("equation of the torus at a quarter of the way", none, torus_equation(1, 0));
  return finding;
}

}  // namespace radcert::verification::m06
