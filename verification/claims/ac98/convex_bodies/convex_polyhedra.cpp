// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/convex_bodies/convex_polyhedra.h"

#include <string>

#include "radcert/geometry/vector.h"
#include "verification/claims/rational_function.h"

namespace radcert::verification::ac98 {
namespace {

using Function = RationalFunction;

// Symbols that are positive.
Function symbol(const std::string& name) { return Function::variable(name); }

// 1 unless f is positive wherever its symbols are: a coefficient that is negative, or none at all.
Rational not_positive(const Function& f) {
  return negative_terms(f) == Rational(0) && differing_terms(f, 0) != Rational(0) ? 0 : 1;
}

Vector<Function> vector(const std::string& name) {
  return {symbol(name + "x"), symbol(name + "y"), symbol(name + "z")};
}

// Any affine form.
Vector<Function> gradient() { return vector("m"); }
Function affine(const Vector<Function>& x) { return dot(gradient(), x) + symbol("b"); }

// Terms in which an affine l(P + r w) differs from l(P) + r s, s its slope along w.
Rational not_along_the_ray() {
  const Vector<Function> p = vector("P");
  const Vector<Function> w = vector("w");
  const Function r = symbol("r");
  return differing_terms(affine(p + r * w), affine(p) + r * dot(gradient(), w));
}

// Terms in which l((1-t) P + t Q) differs from (1-t) l(P) + t l(Q), the weights having a given sum, and
// (Q-P).m from l(Q) - l(P).
Rational not_along_the_segment(const Function& sum_of_weights) {
  const Vector<Function> p = vector("P");
  const Vector<Function> q = vector("Q");
  const Function t = symbol("t");
  const Function other = sum_of_weights - t;
  return differing_terms(affine(other * p + t * q), other * affine(p) + t * affine(q)) +
         differing_terms(dot(q - p, gradient()), affine(q) - affine(p));
}

// A form that is positive at P, and at Q positive, zero, or, to be rejected, negative, between them: t and u
// = 1 - t are positive.
Rational not_positive_between(const Function& at_q) {
  return not_positive(symbol("u") * symbol("alpha") + symbol("t") * at_q);
}

// One more face of slope s_i = -t, where the faces before are left at R: its own exit is alpha/t, so much
// beyond R or before it.
enum class Exit { beyond, before };
Rational wrong_exits_with_one_more(Exit exit) {
  const Function t = symbol("t");
  const Function gap = symbol("gap");
  const Function e = symbol("e");
  const Function others = exit == Exit::beyond ? symbol("R") : symbol("R") + gap;
  const Function own = exit == Exit::beyond ? others + gap : symbol("R");
  const Function alpha = t * own;
  const Function first = exit == Exit::beyond ? others : own;
  const auto form = [&](const Function& r) { return alpha - r * t; };
  // Before the first exit the new face is in front; it alone is looked at, as the others are.
  Rational wrong = not_positive(form(first - e));
  // Beyond its own exit it is left.
  wrong += not_positive(-form(own + e));
  // The first exit is not beyond that of the others.
  return wrong + (exit == Exit::before ? not_positive(others - first) : differing_terms(others, first));
}

// One more face of slope s >= 0, P being so much in front of it.
Rational never_left(const Function& in_front, int sign) {
  return not_positive(in_front + Function(sign) * symbol("r") * symbol("s"));
}

}  // namespace

void require_rays_leave_polyhedra_once(Finding& finding) {
  finding.require("terms of l(P + r w) - l(P) - r s", IsExactly{0}, not_along_the_ray());
  finding.require("signs that are wrong with one more face, left beyond the others' exit", IsExactly{0},
                  wrong_exits_with_one_more(Exit::beyond));
  finding.require("signs that are wrong with one more face, left before the others' exit", IsExactly{0},
                  wrong_exits_with_one_more(Exit::before));
  finding.require("signs that are wrong with one more face, never left", IsExactly{0},
                  never_left(symbol("alpha"), 1));
  finding.control("the same for a face with P in its plane, on an edge, and a ray to its back", IsExactly{0},
                  never_left(0, -1));
}

void require_segments_in_polyhedra(Finding& finding) {
  finding.require("terms of l(X) - (1-t) l(P) - t l(Q) and (Q-P).m - l(Q) + l(P)", IsExactly{0},
                  not_along_the_segment(1));
  finding.control("the same for weights that sum to 2", IsExactly{0}, not_along_the_segment(2));
  finding.require("forms that are not positive between P and Q, positive or zero at Q", IsExactly{0},
                  not_positive_between(symbol("beta")) + not_positive_between(0));
  finding.control("the same for a Q behind the face, as of a body that is not convex", IsExactly{0},
                  not_positive_between(-symbol("beta")));
}

}  // namespace radcert::verification::ac98
