// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "radcert/reference/cubature/adaptive_cubature.h"
#include "radcert/reference/polygon.h"
#include "radcert/reference/tangent_plane.h"

namespace radcert::reference {

/// How slabs spread a peak that is long in s: about t = centre, of width delta.
struct Spread {
  double centre = 0;
  double delta = 0;  // 0: not at all
};

/// How sectors treat the apex.
struct Polar {
  double delta = 0;         // 0: the integrand is analytic in r from 0 on
  double inner_radius = 0;  // nothing nearer than that is integrated
  double bound = 0;         // of |G u| there
  bool graded = false;      // s^a in the integrand and the apex on s = 0
  double margin =
      0;  // > 0: a singular line lies this far, as a length, beyond the vertices with the smallest s
  double bend = 0;       // of the chart: roughness that comes from its shape, over the whole polygon
  bool analytic = true;  // see Roughness
};

/// The integral over a polygon, part by part, added to a cubature.
/// Maths     triangles from vertex 0; slabs between the s of neighbouring vertices, s = z^4 if graded;
///           sectors from the apex to each side, in polar coordinates of the tangent plane; r there, and t in
///           slabs, by the substitution sinh where there is a delta
/// Source    see Collapse, Slab, Sector and Spacing
/// Requires  a convex polygon; the apex is that of the integrand, in the polygon for sectors and vertex 0 for
///           triangles
/// Result    the parts cover the polygon once, up to rounding; sectors leave out the disk of radius
///           polar.inner_radius and add the integral of polar.bound over it to the radius; add_sectors gives
///           the width of the widest strip beside a side through the apex that is left out or covered twice,
///           a rounding
/// Limits    a side through the apex, to rounding, has no sector; `roughness` is a guess of the caller, see
///           Roughness
void add_triangles(AdaptiveCubature& cubature, std::size_t integrand, const Polygon& polygon,
                   const Roughness& roughness);
void add_slabs(AdaptiveCubature& cubature, std::size_t integrand, const Polygon& polygon,
               const Parameters& apex, bool graded, const Spread& spread, const Roughness& roughness);
double add_sectors(AdaptiveCubature& cubature, std::size_t integrand, const Polygon& polygon,
                   const Parameters& apex, const TangentPlane& plane, const Polar& polar);

}  // namespace radcert::reference
