// SPDX-License-Identifier: GPL-3.0-or-later

// (39) to (51) are identities and inequalities of any linear K and any interpolation P_n; they are held to
// here by matrices of rational numbers, with the interpolation (34) itself.
//
// Checked      In exact arithmetic, three equations each for alpha = 1/6, 1/10 and 0. (41) from (40) by (39),
//              and the solution of (41) is that of (40): a solution lies in the range of P_n, and (41) at the
//              nodes is (40). (43), (44), (45) with its inequality, (46), (49), (47), the two identities
//              after (50), (51) with c = norm of (I - R K B)^-1.
// Not checked  that c of (51) stays bounded as n grows: theorem_3_1_inverses, equation_51. Operators on C(S).

#include <functional>

#include "verification/claims/ac98/collocation/collocation_model.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

// A statement on each of the equations, and what it must reject there.
void require_for_all(Finding& finding, const std::string& what,
                     const std::function<Rational(const CollocationModel&)>& count,
                     const std::string& instead,
                     const std::function<Rational(const CollocationModel&)>& rejected) {
  for (const Rational& alpha : {Rational(1, 6), Rational(1, 10), Rational(0)})
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const CollocationModel model = collocation_model(alpha, seed);
      const std::string at = ", alpha = " + alpha.to_text() + ", equation " + std::to_string(seed);
      finding.require(what + at, IsExactly{0}, count(model));
      if (seed == 1) finding.control(instead + at, IsExactly{0}, rejected(model));
    }
}

RationalMatrix one(const CollocationModel& m) { return identity(m.k.rows()); }
RationalMatrix inverse_of_41(const CollocationModel& m) { return inverse(one(m) - m.p * m.k); }
RationalMatrix inverse_of_46(const CollocationModel& m) { return inverse(one(m) - m.k * m.p); }
Rational fails(bool holds) { return {holds ? 0 : 1}; }

}  // namespace

Finding equation_41(const Bench&) {
  Finding finding;
  require_for_all(
      finding, "points where (I - P K) u_n differs from P E, u_n from (39) and (40)",
      [](const CollocationModel& m) {
        const RationalVector u_n = m.collocation_solution();
        return differing(u_n - m.p * (m.k * u_n), m.p * m.emission);
      },
      "points where it differs from E",
      [](const CollocationModel& m) {
        const RationalVector u_n = m.collocation_solution();
        return differing(u_n - m.p * (m.k * u_n), m.emission);
      });
  require_for_all(
      finding, "points where the solution of (41) differs from that of (39) and (40)",
      [](const CollocationModel& m) {
        return differing(inverse_of_41(m) * (m.p * m.emission), m.collocation_solution());
      },
      "points where the solution of (46) differs from it",
      [](const CollocationModel& m) {
        return differing(inverse_of_46(m) * m.emission, m.collocation_solution());
      });
  return finding;
}

Finding equation_43(const Bench&) {
  Finding finding;
  require_for_all(
      finding, "points where P hat u_n differs from u_n",
      [](const CollocationModel& m) {
        return differing(m.p * m.iterated_solution(), m.collocation_solution());
      },
      "points where hat u_n differs from u_n",
      [](const CollocationModel& m) { return differing(m.iterated_solution(), m.collocation_solution()); });
  require_for_all(
      finding, "nodes where hat u_n differs from u_n",
      [](const CollocationModel& m) {
        return differing(m.r * m.iterated_solution(), m.r * m.collocation_solution());
      },
      "nodes where hat u_n differs from u",
      [](const CollocationModel& m) { return differing(m.r * m.iterated_solution(), m.r * m.u); });
  return finding;
}

Finding equation_45(const Bench&) {
  Finding finding;
  require_for_all(
      finding, "points where u - u_n differs from (u - P u) + P (u - hat u_n)",
      [](const CollocationModel& m) {
        return differing(m.u - m.collocation_solution(),
                         (m.u - m.p * m.u) + m.p * (m.u - m.iterated_solution()));
      },
      "points where it differs from (u - P u) + (u - hat u_n)",
      [](const CollocationModel& m) {
        return differing(m.u - m.collocation_solution(), (m.u - m.p * m.u) + (m.u - m.iterated_solution()));
      });
  require_for_all(
      finding, "1 where the inequality of (45) fails",
      [](const CollocationModel& m) {
        return fails(norm(m.u - m.collocation_solution()) <=
                     norm(m.u - m.p * m.u) + norm(m.p) * norm(m.u - m.iterated_solution()));
      },
      "1 where it fails without its first term",
      [](const CollocationModel& m) {
        return fails(norm(m.u - m.collocation_solution()) <= norm(m.p) * norm(m.u - m.iterated_solution()));
      });
  return finding;
}

Finding equation_46(const Bench&) {
  Finding finding;
  require_for_all(
      finding, "points where (I - K P) hat u_n differs from E",
      [](const CollocationModel& m) {
        const RationalVector hat = m.iterated_solution();
        return differing(hat - m.k * (m.p * hat), m.emission);
      },
      "points where (I - P K) hat u_n differs from E",
      [](const CollocationModel& m) {
        const RationalVector hat = m.iterated_solution();
        return differing(hat - m.p * (m.k * hat), m.emission);
      });
  return finding;
}

Finding equation_47(const Bench&) {
  Finding finding;
  require_for_all(
      finding, "1 where norm of (u - hat u_n) > norm of (I - K P)^-1 times norm of K(u - P u)",
      [](const CollocationModel& m) {
        return fails(norm(m.u - m.iterated_solution()) <=
                     norm(inverse_of_46(m)) * norm(m.k * (m.u - m.p * m.u)));
      },
      "1 where norm of (u - u_n) exceeds it",
      [](const CollocationModel& m) {
        return fails(norm(m.u - m.collocation_solution()) <=
                     norm(inverse_of_46(m)) * norm(m.k * (m.u - m.p * m.u)));
      });
  return finding;
}

Finding equation_49(const Bench&) {
  Finding finding;
  require_for_all(
      finding, "points where u - hat u_n differs from (I - K P)^-1 K (u - P u)",
      [](const CollocationModel& m) {
        return differing(m.u - m.iterated_solution(), inverse_of_46(m) * (m.k * (m.u - m.p * m.u)));
      },
      "points where it differs from (I - P K)^-1 K (u - P u)",
      [](const CollocationModel& m) {
        return differing(m.u - m.iterated_solution(), inverse_of_41(m) * (m.k * (m.u - m.p * m.u)));
      });
  return finding;
}

Finding equation_50_inverses(const Bench&) {
  Finding finding;
  require_for_all(
      finding, "entries where (I - K P)^-1 differs from I + K (I - P K)^-1 P",
      [](const CollocationModel& m) {
        return differing(inverse_of_46(m), one(m) + m.k * (inverse_of_41(m) * m.p));
      },
      "entries where it differs from I + K (I - P K)^-1",
      [](const CollocationModel& m) { return differing(inverse_of_46(m), one(m) + m.k * inverse_of_41(m)); });
  require_for_all(
      finding, "entries where (I - P K)^-1 differs from I + P (I - K P)^-1 K",
      [](const CollocationModel& m) {
        return differing(inverse_of_41(m), one(m) + m.p * (inverse_of_46(m) * m.k));
      },
      "entries where it differs from I + (I - K P)^-1 K",
      [](const CollocationModel& m) { return differing(inverse_of_41(m), one(m) + inverse_of_46(m) * m.k); });
  return finding;
}

Finding equation_51(const Bench&) {
  Finding finding;
  const auto right_side = [](const CollocationModel& m) { return m.r * (m.k * (m.u - m.p * m.u)); };
  const auto of_nodes = [](const CollocationModel& m) {
    return inverse(identity(m.nodes.size()) - m.r * (m.k * m.b));
  };
  require_for_all(
      finding, "nodes where (I - R K B) R(u - hat u_n) differs from R K(u - P u)",
      [=](const CollocationModel& m) {
        const RationalVector error = m.r * (m.u - m.iterated_solution());
        return differing(error - m.r * (m.k * (m.b * error)), right_side(m));
      },
      "nodes where R(u - hat u_n) itself differs from it",
      [=](const CollocationModel& m) {
        return differing(m.r * (m.u - m.iterated_solution()), right_side(m));
      });
  require_for_all(
      finding, "1 where (51) fails with c = norm of (I - R K B)^-1",
      [=](const CollocationModel& m) {
        return fails(norm(m.r * (m.u - m.iterated_solution())) <= norm(of_nodes(m)) * norm(right_side(m)));
      },
      "1 where it fails with c/100",
      [=](const CollocationModel& m) {
        return fails(norm(m.r * (m.u - m.iterated_solution())) <=
                     norm(of_nodes(m)) * norm(right_side(m)) / 100);
      });
  return finding;
}

}  // namespace radcert::verification::ac98
