// SPDX-License-Identifier: GPL-3.0-or-later

// Section IV, for all elements and coefficients: identities of polynomials in symbols for the values phi_i at
// a point.
//
// Checked      One to four elements; each sum has one term of the same kind for each element, so that more
//              elements add terms that agree like these. Interpolation: phi_i(p_j) = delta_ij, as Shepard's
//              closed form without a division by zero has it for any distances, gives sum_i c_i phi_i(p_j) =
//              c_j; rejected for normalised elements that reach the next site. (8), (9): (11) of elements
//              psi_i >= 0 sums to 1 and has no negative coefficient; rejected: psi_i - 1/4, which is negative
//              somewhere, and what is not normalised. (10): with c_i = c_min + g_i and sum_i phi_i = 1, f -
//              c_min = sum_i g_i phi_i, which has no negative coefficient, and c_max - f alike; rejected
//              where the elements sum to 2, or one is negative. As printed, with c_min and c_max exchanged,
//              the two margins sum to c_min - c_max: it fails at each point unless all coefficients are
//              equal. (11) has no value where all elements are 0: (18) beyond all radii, and all three bases
//              where the normal is turned away from those of all sites, for boxes of such points and normals.
//              Rejected: elements less their mean, whose sum is 0 at a site too. Section III: Shepard's first
//              element, with any distances, is a quotient of sums of products of squares, zero nowhere;
//              Lehtinen's raw ones are, beyond the radius; Gauss' uncut, enclosed on [0, 40], are rejected.
// Not checked  that elements are smooth. Gauss' elements as a basis: equation_17.

#include <string>
#include <vector>

#include "radcert/meshless/radial_element.h"
#include "verification/claims/psg10/algebra/rational_function.h"
#include "verification/claims/psg10/ball_sites.h"
#include "verification/claims/psg10/exact_sites.h"
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
/// Symbols for elements of a given sum: the last one is what the others leave.
Row elements_of_sum(const Function& sum, std::size_t count) {
  Row elements = symbols("phi", count);
  elements.back() = Function(0);
  elements.back() = sum - sum_of(elements);
  return elements;
}

/// What a statement leaves over for one, two, three and four elements together.
template <class Leftover>
Rational over_counts(const Leftover& leftover) {
  Rational total(0);
  for (std::size_t count = 1; count <= most_elements; ++count) total += leftover(count);
  return total;
}

enum class Bound { least, largest };

/// c_min + g_i, or c_max - g_i.
Row coefficients_from(Bound bound, std::size_t count) {
  Row coefficients;
  for (const Function& gap : symbols("g", count))
    coefficients.push_back(bound == Bound::least ? Function::variable("c") + gap
                                                 : Function::variable("c") - gap);
  return coefficients;
}
/// f - c_min, or c_max - f.
Function margin(Bound bound, const Row& elements) {
  const Function f = combined(elements, coefficients_from(bound, elements.size()));
  const Function c = Function::variable("c");
  return bound == Bound::least ? f - c : c - f;
}

/// Terms in which a margin differs from sum_i g_i phi_i, the elements of a given sum.
Rational margins_otherwise(const Function& sum) {
  return over_counts([&](std::size_t count) {
    const Row elements = elements_of_sum(sum, count);
    const Function meant = combined(elements, symbols("g", count));
    return differing_terms(margin(Bound::least, elements), meant) +
           differing_terms(margin(Bound::largest, elements), meant);
  });
}
/// Negative coefficients of sum_i g_i phi_i, the first element with a sign.
Rational negative_margins(int sign) {
  return over_counts([&](std::size_t count) {
    Row elements = symbols("phi", count);
    elements.front() = Function(sign) * elements.front();
    return negative_terms(combined(elements, symbols("g", count)));
  });
}

/// Terms in which sum_i c_i phi_i(p_j) differs from c_j, the elements at p_j given.
template <class ElementsAt>
Rational not_interpolated(const ElementsAt& elements_at) {
  return over_counts([&](std::size_t count) {
    const Row coefficients = symbols("c", count);
    Rational terms(0);
    for (std::size_t j = 0; j < count; ++j)
      terms += differing_terms(combined(elements_at(j, count), coefficients), coefficients[j]);
    return terms;
  });
}

/// Terms in which the sum of the elements differs from 1.
template <class Elements>
Rational not_one(const Elements& elements) {
  return over_counts([&](std::size_t count) { return differing_terms(sum_of(elements(count)), 1); });
}

/// (11) of psi_i less a number.
auto normalised_less(const Rational& lowered_by) {
  return [lowered_by](std::size_t count) {
    Row raw = symbols("psi", count);
    for (Function& value : raw) value = value - Function(lowered_by);
    return normalised(std::move(raw));
  };
}
template <class Elements>
Rational negative_elements(const Elements& elements) {
  return over_counts([&](std::size_t count) {
    Rational terms(0);
    for (const Function& element : elements(count)) terms += negative_terms(element);
    return terms;
  });
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
  const auto of_shepard = [](std::size_t j, std::size_t count) {
    Row squares = symbols("d", count);
    squares[j] = 0;
    return shepard_values<Function>(squares);
  };
  // 1 at the own site, and any values at the others.
  const auto reaching_the_next = [](std::size_t j, std::size_t count) {
    Row raw = symbols("psi", count);
    raw[j] = 1;
    return normalised(std::move(raw));
  };
  Finding finding;
  finding.require("terms in which Shepard's combination at a site is not the coefficient", IsExactly{0},
                  not_interpolated(of_shepard));
  finding.control("the same for normalised elements that reach the next site", IsExactly{0},
                  not_interpolated(reaching_the_next));
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
  const auto raw = [](std::size_t count) { return symbols("psi", count); };
  Finding finding;
  finding.require("terms in which the elements (11) do not sum to 1", IsExactly{0},
                  not_one(normalised_less(0)));
  finding.control("the same, not normalised", IsExactly{0}, not_one(raw));
  finding.require("negative coefficients of the elements (11)", IsExactly{0},
                  negative_elements(normalised_less(0)));
  finding.control("the same of psi_i - 1/4", IsExactly{0},
                  negative_elements(normalised_less(Rational(1, 4))));
  return finding;
}

Finding section_3_compact(const Bench&) {
  // Shepard's element of any squared distances is positive: no coefficient is negative, and it is not 0.
  const Function of_shepard = shepard_values<Function>(symbols("d", most_elements)).front();
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
