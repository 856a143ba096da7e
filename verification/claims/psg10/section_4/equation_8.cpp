// SPDX-License-Identifier: GPL-3.0-or-later

// Section IV, for all elements and coefficients, however many: identities of rational functions in symbols
// for the values phi_i at a point, by induction on their number.
//
// Checked      Interpolation: phi_i(p_j) = delta_ij gives sum_i c_i phi_i(p_j) = c_j, one element after
//              another, and Shepard's closed form without a division by zero has it for any distances;
//              rejected for normalised elements that reach the next site. (8), (9): (11) of elements psi_i
//              >= 0 sums to 1 and has no negative coefficient; rejected: psi_i - 1/4, which is negative
//              somewhere, and what is not normalised. (10): with c_i = c_min + g_i, sum_i c_i phi_i = c_min
//              sum_i phi_i + sum_i g_i phi_i, so that f - c_min = sum_i g_i phi_i where the elements sum to
//              1, which has no negative coefficient, and c_max - f alike; rejected where the elements sum to
//              2, or one is negative. As printed, with c_min and c_max exchanged, the two margins sum to
//              c_min - c_max: it fails at each point unless all coefficients are equal. The library's (11)
//              and Shepard's form for one to four elements. (11) has no value where all elements are 0: (18)
//              beyond all radii, and all three bases where the normal is turned away from those of all
//              sites, for boxes of such points and normals. Rejected: elements less their mean, whose sum is
//              0 at a site too. Section III: Shepard's element, among any sites at any distances, is a
//              quotient of sums of products of squares, zero nowhere; Lehtinen's raw ones are, beyond the
//              radius; Gauss' uncut, enclosed on [0, 40], are rejected.
// Not checked  that elements are smooth. Gauss' elements as a basis: equation_17.

#include <string>
#include <vector>

#include "radcert/meshless/radial_element.h"
#include "verification/claims/psg10/ball_sites.h"
#include "verification/claims/psg10/element_lists.h"
#include "verification/claims/psg10/exact_sites.h"
#include "verification/claims/rational_function.h"
#include "verification/framework/check.h"

namespace radcert::verification::psg10 {
namespace {

using Function = RationalFunction;
using Row = std::vector<Function>;

constexpr std::size_t most_elements = 4;

Row symbols(const std::string& name, std::size_t count) {
  Row row;
  for (std::size_t i = 0; i < count; ++i) row.push_back(Function::variable(name + std::to_string(i)));
  return row;
}
Function sum_of(const Row& row) {
  Function sum(0);
  for (const Function& each : row) sum += each;
  return sum;
}
Function combined(const Row& values, const Row& coefficients) {
  Function sum(0);
  for (std::size_t i = 0; i < values.size(); ++i) sum += coefficients[i] * values[i];
  return sum;
}

/// What a statement leaves over for one, two, three and four elements together.
template <class Leftover>
Rational over_counts(const Leftover& leftover) {
  Rational total(0);
  for (std::size_t count = 1; count <= most_elements; ++count) total += leftover(count);
  return total;
}

enum class Bound { least, largest };

/// +g for c_min, -g for c_max.
Function away_from(Bound bound, const Function& gap) { return bound == Bound::least ? gap : -gap; }

/// Sums over any number of elements: of phi_i, of c_i phi_i and of g_i phi_i, c_i = c_min + g_i or c_max -
/// g_i.
struct Combination {
  Function elements;
  Function value;
  Function gaps;

  static Function bound() { return Function::variable("c"); }
  static Combination none() { return {0, 0, 0}; }
  static Combination of(Bound which, const Function& elements) {
    const Function gaps = Function::variable("gaps");
    return {elements, elements * bound() + away_from(which, gaps), gaps};
  }
  static Combination any(Bound which) { return of(which, Function::variable("phis")); }
  [[nodiscard]] Combination with(Bound which, const Function& phi) const {
    const Function gap = Function::variable("g");
    return {elements + phi, value + (bound() + away_from(which, gap)) * phi, gaps + gap * phi};
  }
};

/// Terms in which sum c_i phi_i differs from c sum phi_i plus or minus sum g_i phi_i, for any number of
/// elements, and in which f - c_min or c_max - f then differs from sum g_i phi_i, the elements of a given
/// sum.
Rational margins_otherwise(const Function& sum) {
  Rational terms(0);
  for (const Bound which : {Bound::least, Bound::largest}) {
    terms += left_over_by_induction(
        Combination::none(), Combination::any(which),
        [&](const Combination& before) { return before.with(which, Function::variable("phi")); },
        [&](const Combination& all) {
          return differing_terms(all.value, all.elements * Combination::bound() + away_from(which, all.gaps));
        });
    const Combination all = Combination::of(which, sum);
    const Function margin = away_from(which, all.value - Combination::bound());
    terms += differing_terms(margin, all.gaps);
  }
  return terms;
}
/// Negative coefficients of sum g_i phi_i for any number of elements, one of which has a sign.
Rational negative_margins(int sign) {
  return left_over_by_induction(
      Combination::none(), Combination::any(Bound::least),
      [&](const Combination& before) {
        return before.with(Bound::least, Function(sign) * Function::variable("phi"));
      },
      [](const Combination& all) { return negative_terms(all.gaps); });
}

/// At a site p_j, sums over any number of elements: of phi_j, 0 or 1 of which is among them, and of c_i
/// phi_i.
struct AtSite {
  Function own;
  Function value;
};
/// Terms in which the value differs from c_j times the own elements among any number of them, the own element
/// and the others at p_j given.
Rational not_interpolated(const Function& own, const Function& other) {
  const Function coefficient = Function::variable("c_j");
  const Function among = Function::variable("own");
  const AtSite none{0, 0};
  const AtSite any{among, among * coefficient};
  const auto leftover = [&](const AtSite& all) { return differing_terms(all.value, all.own * coefficient); };
  const auto with_another = [&](const AtSite& before) {
    return AtSite{before.own, before.value + Function::variable("c_i") * other};
  };
  const auto with_own = [&](const AtSite& before) {
    return AtSite{before.own + 1, before.value + coefficient * own};
  };
  return left_over_by_induction(none, any, with_another, leftover) +
         left_over_by_induction(none, any, with_own, leftover);
}
/// The same for the library's form of Shepard's basis, one to four elements.
Rational not_interpolated_by_library() {
  return over_counts([](std::size_t count) {
    const Row coefficients = symbols("c", count);
    Rational terms(0);
    for (std::size_t j = 0; j < count; ++j) {
      Row squares = symbols("d", count);
      squares[j] = 0;
      terms += differing_terms(combined(shepard_values<Function>(squares), coefficients), coefficients[j]);
    }
    return terms;
  });
}

/// psi among any number of others whose sum is a symbol, by (11), each less a number.
Function normalised_less(const Rational& lowered_by) {
  const Function psi = Function::variable("psi") - Function(lowered_by);
  return normalised(Row{psi, Function::variable("others")}).front();
}
/// Terms in which the library's (11) does not sum to 1, one to four elements.
Rational not_one_by_library() {
  return over_counts(
      [](std::size_t count) { return differing_terms(sum_of(normalised(symbols("psi", count))), 1); });
}

/// 1 where the raw element of the upright site, radius 5/2, is 0 at all points of a box.
Rational vanishes(const RadialBasisChoice& choice, const Site<Ball>& at) {
  return certainly_zero(raw_element(choice, at, upright_site(), Ball(Rational(5, 2)))) ? 1 : 0;
}
/// Farther than the radius, with the site's normal.
Site<Ball> beyond_the_radius() { return {{hull(Ball(3), Ball(1000)), 0, 0}, {0, 0, 1}}; }
/// 1 where it is at all points with a normal at 90 degrees or more.
Rational vanishes_turned_away(const RadialBasisChoice& choice) {
  Rational all(1);
  for (const Ball& cosine : cosines_turned_away()) all = all * vanishes(choice, sites_with_cosine(cosine));
  return all;
}

}  // namespace

Finding section_4_interpolation(const Bench&) {
  const Function square = Function::variable("u");
  // p_j is at the distance 0 from its own site, whose raw element is infinite and takes no part.
  const OtherSites with_own = OtherSites::any().with(0, Function::variable("psi_j"));
  const Function own = shepard_element(0, OtherSites::any());
  const Function other = shepard_element(square, with_own);
  // 1 at the own site, and any values at the others.
  const Function reaching = normalised(Row{Function::variable("psi"), 1, Function::variable("others")})[0];
  Finding finding;
  finding.require("terms in which Shepard's element at its site is not 1, among any number of others",
                  IsExactly{0}, differing_terms(own, 1));
  finding.require("terms in which Shepard's element at another site is not 0, among any number of others",
                  IsExactly{0}, differing_terms(other, 0));
  finding.require("terms in which Shepard's combination at a site is not the coefficient, any number of them",
                  IsExactly{0}, not_interpolated(own, other));
  finding.require("the same in the library's form, one to four elements", IsExactly{0},
                  not_interpolated_by_library());
  finding.control("the same for normalised elements that reach the next site", IsExactly{0},
                  not_interpolated(1, reaching));
  finding.control("the same for an element of height 1/2 at its site", IsExactly{0},
                  not_interpolated(Rational(1, 2), 0));
  return finding;
}

Finding equation_10(const Bench&) {
  // With c_max = c_min + g: what the two margins sum to.
  const Function least = Function::variable("c");
  const Function most = least + Function::variable("g");
  const Function f = Function::variable("f");
  Finding finding;
  finding.require(
      "negative coefficients of (c_min - f) + (f - c_max), the margins as printed, c_max = c_min + g",
      IsExactly{0}, negative_terms((least - f) + (f - most)));
  finding.instead("terms in which f - c_min, c_max - f differ from sums of g_i phi_i", IsExactly{0},
                  margins_otherwise(1));
  finding.instead("negative coefficients of these sums", IsExactly{0}, negative_margins(1));
  finding.control("terms in which f - c_min, c_max - f differ from sums of g_i phi_i, elements that sum to 2",
                  IsExactly{0}, margins_otherwise(2));
  return finding;
}

Finding section_4_smoothing(const Bench&) {
  Finding finding;
  finding.require("terms in which f - c_min, c_max - f differ from sums of g_i phi_i", IsExactly{0},
                  margins_otherwise(1));
  finding.control("the same, elements that sum to 2", IsExactly{0}, margins_otherwise(2));
  finding.require("negative coefficients of these sums", IsExactly{0}, negative_margins(1));
  finding.control("the same, the first element negative", IsExactly{0}, negative_margins(-1));
  return finding;
}

Finding equation_11(const Bench&) {
  // Elements less their mean: they have both signs.
  const auto without_value = [](bool centred) {
    ExactSites random(42);
    const std::vector<Site<Rational>> sites = random.several_on_axis(6);
    std::vector<Rational> raw = raw_lehtinen(sites, Rational(5, 2), sites.front());
    Rational mean(0);
    for (const Rational& value : raw) mean += value / Rational(static_cast<long>(raw.size()));
    if (centred)
      for (Rational& value : raw) value -= mean;
    return Rational(normalised(std::move(raw)).empty() ? 1 : 0);
  };
  Finding finding;
  finding.require("whether all elements (18) are 0 beyond all radii", IsExactly{0},
                  vanishes(lehtinen_basis(), beyond_the_radius()));
  for (const auto& [name, choice] :
       {std::pair("(16)", shepard_basis()), {"(17)", gaussian_basis()}, {"(18)", lehtinen_basis()}})
    finding.require("whether all elements " + std::string(name) + " are 0 where all sites are turned away",
                    IsExactly{0}, vanishes_turned_away(choice));
  finding.instead("whether (11) is 0/0 at a site of six, (18)", IsExactly{0}, without_value(false));
  finding.control("whether (11) is 0/0 at a site of six, elements less their mean", IsExactly{0},
                  without_value(true));
  return finding;
}

Finding section_4_normalised(const Bench&) {
  Finding finding;
  finding.require("terms in which any number of elements (11) do not sum to 1", IsExactly{0},
                  not_divided(DividedElements::total()));
  finding.control("the same, not normalised", IsExactly{0}, not_divided(1));
  finding.require("the same in the library's form, one to four elements", IsExactly{0}, not_one_by_library());
  finding.require("negative coefficients of an element (11) among any number of others", IsExactly{0},
                  negative_terms(normalised_less(0)));
  finding.control("the same of psi - 1/4", IsExactly{0}, negative_terms(normalised_less(Rational(1, 4))));
  return finding;
}

Finding section_3_compact(const Bench&) {
  // Shepard's element of any squared distances is positive: no coefficient is negative, and it is not 0.
  const Function of_shepard = shepard_element(Function::variable("u"), OtherSites::any());
  const bool is_positive =
      negative_terms(of_shepard) == Rational(0) && differing_terms(of_shepard, 0) != Rational(0);
  constexpr long cells_a_unit = 16;
  bool gauss_is_positive = true;
  for (long k = 0; k < 40 * cells_a_unit; ++k) {
    const Ball r = hull(Ball(Rational(k, cells_a_unit)), Ball(Rational(k + 1, cells_a_unit)));
    gauss_is_positive = gauss_is_positive && certainly_positive(gaussian_bell(r));
  }
  Finding finding;
  finding.require("whether a raw element of Lehtinen's is not 0 somewhere beyond its radius", IsExactly{0},
                  Rational(1) - vanishes(lehtinen_basis(), beyond_the_radius()));
  finding.require("whether Shepard's element is positive at all distances", IsExactly{0},
                  is_positive ? 1 : 0);
  finding.control("whether Gauss' uncut element is positive up to 40 radii", IsExactly{0},
                  gauss_is_positive ? 1 : 0);
  return finding;
}

}  // namespace radcert::verification::psg10
