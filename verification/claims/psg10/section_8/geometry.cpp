// SPDX-License-Identifier: GPL-3.0-or-later

// What sphere and disk see of each other and of themselves, for all radii and heights: identities of
// polynomials.
//
// Checked      p = C + r n is on the sphere, C = (0,0,h), n.n = 1, q = (x,y,0) on the disk. Symmetry: the
//              kernel is made of n.(q - p), the height of p and |q - p|^2; each is the same for the azimuths
//              (theta, phi) and (theta - phi, 0), as c^2 + s^2 = 1 for either angle. Rejected where the
//              sphere's point stays. Visibility: the segment p + s (q - p) meets the sphere where a s^2 + 2 b
//              s + c = 0, with c = 0 and b = r n.(q - p): again at s = -2b/a, and it is cut off there if 0 <
//              s < 1. But a (1 - s) = a + 2b = |q - C|^2 - r^2, which is x^2 + y^2 + 2 r g + g^2 > 0 for h =
//              r + g, g > 0. So q is hidden exactly where n.(q - p) < 0, and a factor F that is 0 there makes
//              V needless; the disk, flat and below the sphere, hides nothing. Rejected for h = r - g. The
//              angle: s |q - p|^2 = 2 r n.(p - q), so that n and q -> p have an acute angle where q is
//              hidden, not an obtuse one. No light to itself: two points of the disk have n.(q - p) = 0; two
//              of the sphere have n.(q - p) = -|q - p|^2/(2r), never positive at either end. The product of
//              both is positive: it is the cut at 0 of each factor that matters. Rejected: inner normals.
// Not checked  light that passes through a surface.

#include <array>
#include <string>

#include "verification/claims/psg10/section_8/ray_on_sphere.h"
#include "verification/claims/rational_function.h"
#include "verification/framework/check.h"

namespace radcert::verification::psg10 {
namespace {

using Function = RationalFunction;
using Point = Vector<Function>;

Function symbol(const std::string& name) { return Function::variable(name); }

struct Angle {
  Function cosine;
  Function sine;
};
Angle angle(const std::string& name) { return {symbol("c_" + name), symbol("s_" + name)}; }
Angle difference(const Angle& a, const Angle& b) {
  return {a.cosine * b.cosine + a.sine * b.sine, a.sine * b.cosine - a.cosine * b.sine};
}
/// s^2 = 1 - c^2.
SquareRule of_angle(const std::string& name) {
  const Polynomial cosine = Polynomial::variable("c_" + name);
  return {"s_" + name, 1 - cosine * cosine};
}

/// A unit vector, and its rule z^2 = 1 - x^2 - y^2.
Point vector(const std::string& name) { return {symbol(name + "x"), symbol(name + "y"), symbol(name + "z")}; }
SquareRule of_unit_vector(const std::string& name) {
  const Polynomial x = Polynomial::variable(name + "x");
  const Polynomial y = Polynomial::variable(name + "y");
  return {name + "z", 1 - x * x - y * y};
}

Function radius() { return symbol("r"); }
Point centre(const Function& height) { return {0, 0, height}; }

/// What cos cos'/d^2 is made of: n.(q - p), the height of p, |q - p|^2.
std::array<Function, 3> parts_of_kernel(const Angle& on_sphere, const Angle& on_disk) {
  const Angle latitude = angle("zeta");
  const Point normal{latitude.cosine * on_sphere.cosine, latitude.cosine * on_sphere.sine, latitude.sine};
  const Point p = centre(symbol("h")) + radius() * normal;
  const Point q{symbol("u") * on_disk.cosine, symbol("u") * on_disk.sine, 0};
  return {dot(normal, q - p), p.z, dot(q - p, q - p)};
}

/// In how many terms the kernel at (theta, phi) differs from that at the azimuths (of the sphere, 0).
Rational changed_by_turning(const Angle& on_sphere) {
  const std::array<SquareRule, 2> rules{of_angle("theta"), of_angle("phi")};
  const auto here = parts_of_kernel(angle("theta"), angle("phi"));
  const auto there = parts_of_kernel(on_sphere, {1, 0});
  Rational terms(0);
  for (std::size_t k = 0; k < here.size(); ++k) terms += differing_terms(here[k], there[k], rules);
  return terms;
}

/// The segment from a point of the sphere to one of the disk.
struct Segment {
  Point normal = vector("n");
  Point q{symbol("x"), symbol("y"), 0};
  Point c;
  Point to_disk;  ///< q - p
  RayOnSphere<Function> equation;

  explicit Segment(const Function& height)
      : c(centre(height)),
        to_disk(q - (c + radius() * normal)),
        equation(c + radius() * normal, to_disk, c, radius()) {}

  /// s of the other end of the chord, times a = |q - p|^2.
  [[nodiscard]] Function chord() const { return -(equation.b + equation.b); }
  /// |q - C|^2 - r^2.
  [[nodiscard]] Function outside() const { return dot(q - c, q - c) - radius() * radius(); }
};

}  // namespace

Finding section_8_symmetry(const Bench&) {
  Finding finding;
  finding.require("terms in which n.(q - p), the height of p and |q - p|^2 depend on more than theta - phi",
                  IsExactly{0}, changed_by_turning(difference(angle("theta"), angle("phi"))));
  finding.control("the same, the disk's point alone turned", IsExactly{0},
                  changed_by_turning(angle("theta")));
  return finding;
}

Finding section_8_visibility(const Bench&) {
  const Function beyond = symbol("g");
  const Segment segment(radius() + beyond);
  const std::array<SquareRule, 1> unit{of_unit_vector("n")};
  const Function nearer = segment.equation.a - segment.chord();
  Finding finding;
  finding.require("terms of the constant of the segment's equation: p is on the sphere", IsExactly{0},
                  differing_terms(segment.equation.c, 0, unit));
  finding.require("terms in which b differs from r n.(q - p)", IsExactly{0},
                  differing_terms(segment.equation.b, radius() * dot(segment.normal, segment.to_disk)));
  finding.require("terms in which |q - p|^2 (1 - s) differs from |q - C|^2 - r^2", IsExactly{0},
                  differing_terms(nearer, segment.outside(), unit));
  finding.control("the same where n is no unit vector", IsExactly{0},
                  differing_terms(nearer, segment.outside()));
  finding.require("negative coefficients of |q - C|^2 - r^2, h = r + g", IsExactly{0},
                  negative_terms(segment.outside()));
  finding.control("the same, h = r - g: the sphere dips into the disk", IsExactly{0},
                  negative_terms(Segment(radius() - beyond).outside()));
  return finding;
}

Finding section_8_angle(const Bench&) {
  const Segment segment(symbol("h"));
  const auto differing = [&](const Function& cosine) {
    return differing_terms(segment.chord(), -(radius() + radius()) * cosine);
  };
  Finding finding;
  finding.require("terms in which s |q - p|^2 differs from -2 r n.(p - q): obtuse with q -> p where 0 < s",
                  IsExactly{0}, differing(dot(segment.normal, -segment.to_disk)));
  finding.instead("terms in which s |q - p|^2 differs from -2 r n.(q - p): obtuse with p -> q", IsExactly{0},
                  differing(dot(segment.normal, segment.to_disk)));
  finding.control("the same, p -> q held against the axis", IsExactly{0}, differing(segment.to_disk.z));
  return finding;
}

Finding section_8_no_self_light(const Bench&) {
  const std::array<SquareRule, 2> unit{of_unit_vector("n"), of_unit_vector("m")};
  // 2 r n.(q - p) + |q - p|^2 for p = C + r n and q = C + r m, outer normals or inner ones.
  const auto on_sphere = [&](const Function& side) {
    const Point step = radius() * (vector("m") - vector("n"));
    return differing_terms((radius() + radius()) * dot(side * vector("n"), step), -dot(step, step), unit);
  };
  const auto on_disk = [](const Function& height) {
    const Point step{symbol("x"), symbol("y"), height};
    return differing_terms(dot(Point{0, 0, 1}, step), 0);
  };
  Finding finding;
  finding.require("terms of n.(q - p), two points of the disk", IsExactly{0}, on_disk(0));
  finding.control("the same, a disk with a dent", IsExactly{0}, on_disk(-symbol("g")));
  finding.require("terms in which 2 r n.(q - p) differs from -|q - p|^2, two points of the sphere",
                  IsExactly{0}, on_sphere(1));
  finding.control("the same with inner normals", IsExactly{0}, on_sphere(-1));
  return finding;
}

}  // namespace radcert::verification::psg10
