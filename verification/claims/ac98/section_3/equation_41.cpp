// SPDX-License-Identifier: GPL-3.0-or-later

// (39) to (51) are algebra: they hold for every linear K, on whatever space, and for every interpolation P_n
// = B R, where R takes the values at the nodes and B makes a function of them. The system (40) for the values
// v of u_n is (I - R K B) v = R E, and X is the inverse of its matrix. So with E, or with u and E = u - K u,
//     v = X R E,   u_n = B v,   hat u_n = E + K u_n,
// and each identity is one between sums of products of K, B, R and X. It is proved by rewriting: R B = I, as
// the interpolant has the values that it is made of, and (I - R K B) X = X (I - R K B) = I.
//
// Checked      (41) for that u_n, and that it has no other solution: I - P K has the inverse I + B X R K, and
//              X exists where I - P K has an inverse. (43) to (46) and (49), I - K P having the inverse I + K
//              B X R. The two identities after (50), for any K and P with these inverses. (51): R(u - hat
//              u_n) = X R K(u - P u). The inequalities (45), (47) and (51) are the norms of both sides of the
//              identities here, by |a + b| <= |a| + |b| and |A a| <= |A| |a|; c of (51) is the norm of X. In
//              each, arbitrary values at the nodes in place of the solution of (40) are rejected, and wrong
//              identities.
// Not checked  that c of (51), and the norms of the inverses, stay bounded as n grows: theorem_3_1_inverses,
//              equation_51_constant.

#include "verification/claims/operator_algebra.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

using Rules = std::vector<OperatorRelations::Rule>;

const Operator one(1);

Operator k() { return Operator("K"); }
Operator r() { return Operator("R"); }
Operator b() { return Operator("B"); }
Operator x() { return Operator("X"); }
Operator p() { return b() * r(); }

// (39), (40) and (42), as operators on what E is given by.
struct Solution {
  Operator emission;
  Operator node_values = x() * r() * emission;
  Operator u_n = b() * node_values;
  Operator iterated = emission + k() * u_n;
};

Solution of_emission() { return {.emission = one}; }
Solution of_u() { return {.emission = one - k()}; }  // E = u - K u

Rules interpolation() { return {{.product = "RB", .replacement = one}}; }
Rules inverse_of_the_system() {
  return {{.product = "RKBX", .replacement = x() - one}, {.product = "XRKB", .replacement = x() - one}};
}

OperatorRelations collocation() {
  Rules rules = interpolation();
  for (const OperatorRelations::Rule& rule : inverse_of_the_system()) rules.push_back(rule);
  return OperatorRelations(rules);
}
// X any matrix: arbitrary values at the nodes.
OperatorRelations arbitrary_values() { return OperatorRelations(interpolation()); }
// R B is not I: the function made of the values has others.
OperatorRelations arbitrary_functions() { return OperatorRelations(inverse_of_the_system()); }

// a = b for collocation, and not for arbitrary values at the nodes.
void require_identity(Finding& finding, const std::string& what, const Operator& left,
                      const Operator& right) {
  finding.require("words of " + what, IsExactly{0}, collocation().differing_words(left, right));
  finding.control("words of the same for arbitrary values at the nodes", IsExactly{0},
                  arbitrary_values().differing_words(left, right));
}

void reject_identity(Finding& finding, const std::string& what, const Operator& left, const Operator& right) {
  finding.control("words of " + what, IsExactly{0}, collocation().differing_words(left, right));
}

void require_inverse(Finding& finding, const std::string& what, const Operator& a, const Operator& inverse) {
  require_identity(finding, what + ", from the right, less I", a * inverse, one);
  require_identity(finding, what + ", from the left, less I", inverse * a, one);
}

Operator inverse_of_41() { return one + b() * x() * r() * k(); }
Operator inverse_of_46() { return one + k() * b() * x() * r(); }

// (49), of which (47) is the norm.
Finding error_of_the_iterated_solution() {
  const Solution s = of_u();
  Finding finding;
  require_identity(finding, "(I - K P)(u - hat u_n) - K(u - P u)", (one - k() * p()) * (one - s.iterated),
                   k() * (one - p()));
  require_inverse(finding, "(I - K P) with I + K B X R", one - k() * p(), inverse_of_46());
  require_identity(finding, "u - hat u_n - (I - K P)^-1 K(u - P u)", one - s.iterated,
                   inverse_of_46() * k() * (one - p()));
  reject_identity(finding, "u - u_n - (I - K P)^-1 K(u - P u)", one - s.u_n,
                  inverse_of_46() * k() * (one - p()));
  reject_identity(finding, "u - hat u_n - (I - P K)^-1 K(u - P u)", one - s.iterated,
                  inverse_of_41() * k() * (one - p()));
  return finding;
}

}  // namespace

Finding equation_41(const Bench&) {
  const Solution s = of_emission();
  Finding finding;
  require_identity(finding, "(I - P K) u_n - P E", (one - p() * k()) * s.u_n, p() * s.emission);
  require_inverse(finding, "(I - P K) with I + B X R K", one - p() * k(), inverse_of_41());
  require_identity(finding, "(I - P K)^-1 P E - u_n", inverse_of_41() * p() * s.emission, s.u_n);
  reject_identity(finding, "(I - P K) u_n - E", (one - p() * k()) * s.u_n, s.emission);
  // Without an inverse: (I - P K) B v - P E = B [(I - R K B) v - R E], B v = 0 only for v = R B v = 0, and a
  // solution of (41) is B v with v = R (E + K u).
  const Operator of_40 = one - r() * k() * b();
  finding.require("words of (I - P K) B - B (I - R K B)", IsExactly{0},
                  arbitrary_values().differing_words((one - p() * k()) * b(), b() * of_40));
  finding.require("words of R (I - P K) B - (I - R K B)", IsExactly{0},
                  arbitrary_values().differing_words(r() * (one - p() * k()) * b(), of_40));
  finding.control("words of the same where the function of the values has others at the nodes", IsExactly{0},
                  OperatorRelations(Rules{}).differing_words(r() * (one - p() * k()) * b(), of_40));
  // The other way: Y, the inverse of I - P K, makes one of the matrix of (40).
  const Operator y("Y");
  const OperatorRelations solvable(
      Rules{{.product = "BRKY", .replacement = y - one}, {.product = "YBRK", .replacement = y - one}});
  const Operator system = one - r() * k() * b();
  const Operator inverse = one + r() * k() * y * b();
  finding.require("words of (I - R K B) with I + R K (I - P K)^-1 B, from the right, less I", IsExactly{0},
                  solvable.differing_words(system * inverse, one));
  finding.require("words of the same from the left, less I", IsExactly{0},
                  solvable.differing_words(inverse * system, one));
  finding.control("words of (I - R K B) with I + R (I - P K)^-1 B, less I", IsExactly{0},
                  solvable.differing_words(system * (one + r() * y * b()), one));
  return finding;
}

Finding equation_43(const Bench&) {
  const Solution s = of_emission();
  Finding finding;
  require_identity(finding, "P hat u_n - u_n", p() * s.iterated, s.u_n);
  reject_identity(finding, "hat u_n - u_n", s.iterated, s.u_n);
  return finding;
}

Finding equation_44(const Bench&) {
  const Solution s = of_emission();
  Finding finding;
  require_identity(finding, "hat u_n - u_n at the nodes", r() * s.iterated, r() * s.u_n);
  finding.control("words of the same where the function of the values has others at the nodes", IsExactly{0},
                  arbitrary_functions().differing_words(r() * s.iterated, r() * s.u_n));
  reject_identity(finding, "hat u_n - u", of_u().iterated, one);
  return finding;
}

Finding equation_45(const Bench&) {
  const Solution s = of_u();
  Finding finding;
  require_identity(finding, "u - u_n - (u - P u) - P(u - hat u_n)", one - s.u_n,
                   (one - p()) + p() * (one - s.iterated));
  reject_identity(finding, "u - u_n - (u - P u) - (u - hat u_n)", one - s.u_n,
                  (one - p()) + (one - s.iterated));
  return finding;
}

Finding equation_46(const Bench&) {
  const Solution s = of_emission();
  Finding finding;
  require_identity(finding, "(I - K P) hat u_n - E", (one - k() * p()) * s.iterated, s.emission);
  reject_identity(finding, "(I - P K) hat u_n - E", (one - p() * k()) * s.iterated, s.emission);
  return finding;
}

Finding equation_47(const Bench&) { return error_of_the_iterated_solution(); }

Finding equation_49(const Bench&) { return error_of_the_iterated_solution(); }

Finding equation_50_inverses(const Bench&) {
  // P any linear operator.
  const Operator any("P");
  const Operator y("Y");
  const Operator z("Z");
  const OperatorRelations::Rule right_inverse{.product = "PKY", .replacement = y - one};
  const OperatorRelations of_pk(Rules{right_inverse, {.product = "YPK", .replacement = y - one}});
  const OperatorRelations of_kp(
      Rules{{.product = "KPZ", .replacement = z - one}, {.product = "ZKP", .replacement = z - one}});
  const auto differing = [](const OperatorRelations& relations, const Operator& a) {
    return relations.differing_words(a, one);
  };
  const Operator first = one + k() * y * any;
  const Operator second = one + any * z * k();
  Finding finding;
  finding.require("words of (I - K P) with I + K (I - P K)^-1 P, from the right, less I", IsExactly{0},
                  differing(of_pk, (one - k() * any) * first));
  finding.require("words of the same from the left, less I", IsExactly{0},
                  differing(of_pk, first * (one - k() * any)));
  finding.require("words of (I - P K) with I + P (I - K P)^-1 K, from the right, less I", IsExactly{0},
                  differing(of_kp, (one - any * k()) * second));
  finding.require("words of the same from the left, less I", IsExactly{0},
                  differing(of_kp, second * (one - any * k())));
  finding.control("words of (I - K P) with I + K (I - P K)^-1, less I", IsExactly{0},
                  differing(of_pk, (one - k() * any) * (one + k() * y)));
  finding.control("words of (I - P K) with I + (I - K P)^-1 K, less I", IsExactly{0},
                  differing(of_kp, (one - any * k()) * (one + z * k())));
  finding.control("words of the first from the left, where Y is an inverse of I - P K from the right alone",
                  IsExactly{0},
                  differing(OperatorRelations(Rules{right_inverse}), first * (one - k() * any)));
  return finding;
}

Finding equation_51(const Bench&) {
  const Solution s = of_u();
  const Operator source = r() * k() * (one - p());
  Finding finding;
  require_identity(finding, "(I - R K B) R(u - hat u_n) - R K(u - P u)",
                   (one - r() * k() * b()) * r() * (one - s.iterated), source);
  require_identity(finding, "R(u - hat u_n) - X R K(u - P u)", r() * (one - s.iterated), x() * source);
  reject_identity(finding, "R(u - hat u_n) - R K(u - P u)", r() * (one - s.iterated), source);
  finding.control(
      "words of R(u - u_n) - X R K(u - P u) where the function of the values has others at the nodes",
      IsExactly{0}, arbitrary_functions().differing_words(r() * (one - s.u_n), x() * source));
  return finding;
}

}  // namespace radcert::verification::ac98
