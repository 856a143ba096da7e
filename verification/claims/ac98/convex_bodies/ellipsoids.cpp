// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/convex_bodies/ellipsoids.h"

#include <string>

#include "radcert/geometry/vector.h"
#include "verification/claims/ac98/surfaces/solid_angle.h"
#include "verification/claims/rational_function.h"

namespace radcert::verification::ac98 {
namespace {

using Function = RationalFunction;

Function symbol(const std::string& name) { return Function::variable(name); }
Vector<Function> vector(const std::string& name) {
  return {symbol(name + "x"), symbol(name + "y"), symbol(name + "z")};
}

// A v with the inverse squares of the half axes as symbols.
Vector<Function> times_form(const Vector<Function>& v) {
  return {symbol("A1") * v.x, symbol("A2") * v.y, symbol("A3") * v.z};
}
Function form(const Vector<Function>& v, const Vector<Function>& w) { return dot(v, times_form(w)); }

// Half axes a <= b <= c by what each exceeds the one before, and 1/a, 1/b, 1/c.
struct HalfAxes {
  Function a = symbol("a");
  Function b = a + symbol("b-a");
  Function c = b + symbol("c-b");
};

// A term of |e|^2/a^2 - e.Ae or of |AP|^2 - P.AP/c^2, for the axis `other`.
Function term_of_largest(const Function& least, const Function& other) {
  return 1 / (least * least) - 1 / (other * other);
}
Function term_of_smallest(const Function& other, const Function& largest) {
  const Function square = 1 / (other * other);
  return square * square - square / (largest * largest);
}

// Negative coefficients of these terms for all three axes, `least` and `largest` the ones that are said to
// be.
Rational negative_terms_of_bounds(const Function& least, const Function& largest) {
  const HalfAxes axes;
  Rational count(0);
  for (const Function& each : {axes.a, axes.b, axes.c})
    count += negative_terms(term_of_largest(least, each)) + negative_terms(term_of_smallest(each, largest));
  return count;
}

// Terms in which Q.AQ - P.AP differs from epsilon (2 w.AP + epsilon w.Aw) for Q = P + epsilon w, and w.AQ
// from -w.AP at the other point of the line, epsilon = -2 w.AP/w.Aw; or from w.AP with another sign.
Rational terms_along_a_line(int sign) {
  const Vector<Function> p = vector("P");
  const Vector<Function> w = vector("w");
  const Function epsilon = symbol("epsilon");
  const Vector<Function> q = p + epsilon * w;
  const Function other = Function(-2) * form(w, p) / form(w, w);
  return differing_terms(form(q, q) - form(p, p),
                         epsilon * (Function(2) * form(w, p) + epsilon * form(w, w))) +
         differing_terms(form(w, p + other * w), Function(-sign) * form(w, p));
}

// Terms in which AP.AQ differs from |AP|^2 + AP.A(Q-P), and negative coefficients of (m - s)/(m + s) - least,
// where m exceeds so many s by d >= 0.
Rational terms_of_turned_normals(const Rational& least, int so_many) {
  const Vector<Function> p = vector("P");
  const Vector<Function> h = vector("h");
  const Vector<Function> ap = times_form(p);
  const Function s = symbol("s");
  const Function m = Function(so_many) * s + symbol("d");
  return differing_terms(dot(ap, times_form(p + h)), dot(ap, ap) + dot(ap, times_form(h))) +
         negative_terms((m - s) / (m + s) - Function(least));
}

}  // namespace

void require_bounds_on_ellipsoids(Finding& finding) {
  const HalfAxes axes;
  require_convex_ellipsoids(finding);
  finding.require("negative coefficients of 1/a^2 - 1/a_i^2 and a_i^-4 - a_i^-2/c^2, all axes", IsExactly{0},
                  negative_terms_of_bounds(axes.a, axes.c));
  finding.control("the same with the middle axis for the shortest", IsExactly{0},
                  negative_terms_of_bounds(axes.b, axes.c));
  finding.control("the same with the middle axis for the longest", IsExactly{0},
                  negative_terms_of_bounds(axes.a, axes.b));
}

void require_small_balls_on_ellipsoids(Finding& finding) {
  require_bounds_on_ellipsoids(finding);
  finding.require("terms of Q.AQ - P.AP on a line from P, and of w.AQ + w.AP at its other end", IsExactly{0},
                  terms_along_a_line(1));
  finding.control("the same with w.AQ - w.AP", IsExactly{0}, terms_along_a_line(-1));
  finding.require("terms of AP.AQ - |AP|^2 - AP.Ah, negative ones of (m - s)/(m + s) - 1/2, m >= 3 s",
                  IsExactly{0}, terms_of_turned_normals(Rational(1, 2), 3));
  finding.control("the same for m >= 2 s", IsExactly{0}, terms_of_turned_normals(Rational(1, 2), 2));
}

}  // namespace radcert::verification::ac98
