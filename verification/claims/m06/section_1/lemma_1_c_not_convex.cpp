// SPDX-License-Identifier: GPL-3.0-or-later

// The integral is that of a divergence (Gauss): it needs a bounded body, not a convex one, as long as G keeps
// its sign where P is behind Q or Q behind P, and V is left out. Convexity is what (b) needs: on these bodies
// G < 0 for some pairs.
//
// Checked      Int_S G = pi: the L-shaped room and the dented octahedron, at a point of each face, to 30
//              digits by the closed form of a polygon; the torus (1, 1/2) at a point of its outer and one of
//              its inner half, by enclosed integrals over the charts. G < 0 for a pair of points of each,
//              exactly or in balls. That the part behind the tangent plane of P gives 0.
// Not checked  other points: the proof is that of [ac98, (8)-(12)], in which convexity gives no more than the
// sign of G.

#include <algorithm>
#include <string>

#include "radcert/enclosure/kernel_integral.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/surface/catalogue/torus.h"
#include "verification/claims/m06/section_1/non_convex_bodies.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

void require_on(Finding& finding, const NonConvexBody& body) {
  const BallPrecision precision(192);
  const Rational radius = Rational(1) / power(Rational(10), 31);
  const AgreesWith pi{.value = Ball::pi(), .within = 1e-30};
  for (std::size_t face = 0; face < body.faces.size(); ++face)
    finding.require(
        "signed integral of G, " + body.name + ", face " + std::to_string(face), pi,
        signed_total(body, face, point_of_face(body, face, 0), BehindTangentPlane::counted, radius));
}

Ball torus_total(std::size_t chart, double radius) {
  const Rational third(1, 3);
  return known(kernel_integral(ExactObserver::on_surface({{.chart = chart, .at = {third, Rational(2, 5)}}}),
                               torus(1, Rational(1, 2)), unit_density(), {.radius = radius}));
}

/// The least G between points of two faces, times the lengths of their normals, which are positive.
Rational least_scaled_kernel(const NonConvexBody& body) {
  Rational least = 1;
  for (std::size_t p = 0; p < body.faces.size(); ++p)
    for (std::size_t q = 0; q < body.faces.size(); ++q) {
      if (p == q) continue;
      const std::size_t corners = body.faces[q].loops().front().size() == 3 ? 3 : 1;
      for (std::size_t corner = 0; corner < corners; ++corner)
        least = std::min(least, geometric_kernel(point_of_face(body, p, 0), body.faces[p].normal(),
                                                 point_of_face(body, q, corner), body.faces[q].normal()));
    }
  return least;
}

/// G between (R + r, 0, 0) and (-(R - r), 0, 0), where patch_pp_pp and patch_mp_mp begin.
Ball torus_kernel() {
  const Surface surface = torus(1, Rational(1, 2));
  const Frame<Ball> p = surface.charts.at(0).in<Ball>().frame({Ball(0), Ball(0)});
  const Frame<Ball> q = surface.charts.at(5).in<Ball>().frame({Ball(0), Ball(0)});
  return geometric_kernel(p.point, unit_normal(p), q.point, unit_normal(q));
}

}  // namespace

Finding lemma_1_c_not_convex(const Bench& bench) {
  Finding finding;
  const NonConvexBody room = l_shaped_room();
  const NonConvexBody octahedron = dented_octahedron();
  require_on(finding, room);
  require_on(finding, octahedron);
  const BallPrecision precision(128);
  const double radius = bench.budget == Budget::quick ? 1e-8 : 1e-12;
  const AgreesWith pi{.value = Ball::pi(), .within = 2 * radius};
  // patch_pp_pp is of the outer half of the tube, patch_pp_mp of the inner one.
  for (const std::size_t chart : {std::size_t{0}, std::size_t{1}})
    finding.require("signed integral of G, the torus (1, 1/2), chart " + std::to_string(chart), pi,
                    torus_total(chart, radius));
  const Rational little = Rational(1) / power(Rational(10), 31);
  {
    const BallPrecision more(192);
    NonConvexBody open = room;
    open.faces.pop_back();
    finding.control("the integral over the L-shaped room without one wall",
                    AgreesWith{.value = Ball::pi(), .within = 1e-30},
                    signed_total(open, 0, point_of_face(open, 0, 0), BehindTangentPlane::counted, little));
    // The part behind is closed by the tangent plane, on which G = 0: its own total is that of a body without
    // P.
    finding.require("the same without what is behind the tangent plane, L-shaped room",
                    AgreesWith{.value = Ball::pi(), .within = 1e-30},
                    signed_total(room, 5, point_of_face(room, 5, 0), BehindTangentPlane::left_out, little));
  }
  // G < 0 strictly: G = 0, as on a plane, is not enough.
  const AtMost negative{.value = -0x1p-20, .slack = 0, .why = ""};
  for (const NonConvexBody& body : {room, octahedron})
    finding.require("the least G between points of faces, times a positive number, " + body.name, negative,
                    proved(Ball(least_scaled_kernel(body))));
  finding.require("G between the outermost and the opposite innermost point of the torus", negative,
                  proved(torus_kernel()));
  finding.control("G between floor and ceiling of the L-shaped room", negative,
                  proved(Ball(geometric_kernel(point_of_face(room, 0, 0), room.faces[0].normal(),
                                               point_of_face(room, 1, 0), room.faces[1].normal()))));
  finding.show(proved(torus_kernel()));
  return finding;
}

}  // namespace radcert::verification::m06
