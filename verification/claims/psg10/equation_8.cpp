// SPDX-License-Identifier: GPL-3.0-or-later

// Section IV, exactly. Sites and points lie on a line, their normals within 90 degrees of each other or not,
// all coordinates rational: there every |p - q|, and with it (15), (16) and (18), is rational.
//
// Checked      Interpolation: f = sum_i c_i phi_i has the values c_i at the sites for Shepard's basis, by
//              the closed form without a division by zero, which equation_16 compares with the formula.
//              Lehtinen's, whose supports reach beyond the next site, is rejected. (8), (9): (11) makes of
//              elements that are not negative a basis with (8) and (9) wherever their sum is positive.
//              Elements less 1/4, which are negative somewhere, are rejected. For all p of Gamma there is no
//              such basis of compact supports: where no element reaches (11) is 0/0. (10): c_min <= sum_i c_i
//              phi_i <= c_max for coefficients between -1 and 1. As printed, with c_min and c_max exchanged,
//              it fails unless the coefficients are equal. (11): a value at sites, none where no element
//              reaches; elements less their mean, whose sum is 0, are rejected. Section III: Shepard's
//              elements (16) are not zero at any distance; Lehtinen's are beyond the radius; Gauss' uncut,
//              enclosed, are rejected.
// Not checked  sites off a line for Lehtinen's basis, whose distances are roots. Gauss' elements otherwise:
// they are in equation_17.

#include <algorithm>
#include <functional>
#include <string>

#include "verification/claims/psg10/exact_sites.h"
#include "verification/framework/check.h"

namespace radcert::verification::psg10 {
namespace {

constexpr std::size_t site_count = 6;
constexpr int site_sets = 40;
constexpr int points_a_set = 10;
const Rational& wide() {
  static const Rational alpha(5, 2);
  return alpha;
}

using Sites = std::vector<Site<Rational>>;
/// All elements at a point; empty where they have no value.
using Basis = std::function<std::vector<Rational>(const Sites&, const Site<Rational>&)>;

std::vector<Rational> lehtinen_raw(const Sites& sites, const Site<Rational>& p) {
  return raw_lehtinen(sites, wide(), p);
}
std::vector<Rational> lehtinen(const Sites& sites, const Site<Rational>& p) {
  return normalised(lehtinen_raw(sites, p));
}
std::vector<Rational> shepard(const Sites& sites, const Site<Rational>& p) {
  return shepard_elements(sites, p);
}
/// (11) of elements that are negative where the raw ones of (18) are below 1/4.
std::vector<Rational> lowered(const Sites& sites, const Site<Rational>& p) {
  std::vector<Rational> raw = lehtinen_raw(sites, p);
  for (Rational& value : raw) value -= Rational(1, 4);
  return normalised(std::move(raw));
}
/// (11) of the elements (18) less their mean: they have both signs.
std::vector<Rational> centred(const Sites& sites, const Site<Rational>& p) {
  std::vector<Rational> raw = lehtinen_raw(sites, p);
  Rational mean(0);
  for (const Rational& value : raw) mean += value / Rational(static_cast<long>(raw.size()));
  for (Rational& value : raw) value -= mean;
  return normalised(std::move(raw));
}

Rational combined(const std::vector<Rational>& values, const std::vector<Rational>& coefficients) {
  Rational sum(0);
  for (std::size_t i = 0; i < values.size(); ++i) sum += values[i] * coefficients[i];
  return sum;
}

/// What happens at one point of one set of sites.
using Event = std::function<bool(const Sites&, const Site<Rational>&, const std::vector<Rational>&)>;

/// How often it does, over all sets and points, half of the sets flat.
Rational count(const Event& event) {
  ExactSites random(41);
  long total = 0;
  for (int k = 0; k < site_sets; ++k) {
    const bool flat = k % 2 == 0;
    const Sites sites = random.several_on_axis(site_count, flat);
    for (int i = 0; i < points_a_set; ++i) {
      const Site<Rational> p = random.on_axis(site_count, flat);
      std::vector<Rational> coefficients;
      for (std::size_t j = 0; j < site_count; ++j) coefficients.push_back(random.eighths(1));
      if (event(sites, p, coefficients)) ++total;
    }
  }
  return total;
}

/// Points where (8) or (9) fails; nothing is asked where the basis has no value.
Rational not_partitions(const Basis& basis) {
  return count([&](const Sites& sites, const Site<Rational>& p, const std::vector<Rational>&) {
    const std::vector<Rational> values = basis(sites, p);
    if (values.empty()) return false;
    Rational sum(0);
    for (const Rational& value : values) sum += value;
    return sum != Rational(1) ||
           std::any_of(values.begin(), values.end(), [](const Rational& value) { return value.sign() < 0; });
  });
}

/// Sites where the combination with coefficients c_i is not c_i.
Rational not_interpolated(const Basis& basis) {
  return count([&](const Sites& sites, const Site<Rational>&, const std::vector<Rational>& coefficients) {
    for (std::size_t j = 0; j < sites.size(); ++j)
      if (combined(basis(sites, sites[j]), coefficients) != coefficients[j]) return true;
    return false;
  });
}

/// Points where the combination is outside [c_min, c_max], or, as printed, not between c_max and c_min in
/// that order.
Rational outside(const Basis& basis, bool as_printed) {
  return count([&](const Sites& sites, const Site<Rational>& p, const std::vector<Rational>& coefficients) {
    const std::vector<Rational> values = basis(sites, p);
    if (values.empty()) return false;
    const Rational f = combined(values, coefficients);
    const auto [least, most] = std::minmax_element(coefficients.begin(), coefficients.end());
    return as_printed ? !(*least >= f && f >= *most) : !(*least <= f && f <= *most);
  });
}

}  // namespace

Finding section_4_interpolation(const Bench&) {
  Finding finding;
  finding.require("sites where Shepard's combination is not the coefficient, sets of sites", IsExactly{0},
                  not_interpolated(shepard));
  finding.control("the same for Lehtinen's basis, radius 5/2", IsExactly{0}, not_interpolated(lehtinen));
  return finding;
}

Finding equation_10(const Bench&) {
  Finding finding;
  finding.require("points where (10) as printed fails, Shepard's basis", IsExactly{0},
                  outside(shepard, true));
  finding.require("points where (10) as printed fails, Lehtinen's basis", IsExactly{0},
                  outside(lehtinen, true));
  finding.instead("points where c_min <= f <= c_max fails, Shepard's basis", IsExactly{0},
                  outside(shepard, false));
  finding.instead("points where c_min <= f <= c_max fails, Lehtinen's basis", IsExactly{0},
                  outside(lehtinen, false));
  finding.control("points where (10) as printed fails, elements that are not normalised", IsExactly{0},
                  outside(lehtinen_raw, true));
  return finding;
}

Finding section_4_smoothing(const Bench&) {
  Finding finding;
  finding.require("points where c_min <= f <= c_max fails, Shepard's basis", IsExactly{0},
                  outside(shepard, false));
  finding.require("points where c_min <= f <= c_max fails, Lehtinen's basis", IsExactly{0},
                  outside(lehtinen, false));
  finding.control("the same for elements that are not normalised", IsExactly{0},
                  outside(lehtinen_raw, false));
  return finding;
}

Finding equation_11(const Bench&) {
  // Far from all sites, with a normal turned away from theirs, and at the first site.
  const auto without_value = [](const Basis& basis, const Site<Rational>& p) {
    ExactSites random(42);
    return Rational(basis(random.several_on_axis(site_count, true), p).empty() ? 1 : 0);
  };
  const Site<Rational> far{{1000, 0, 0}, {0, 0, 1}};
  const Site<Rational> turned{{1, 0, 0}, {0, 0, -1}};
  Finding finding;
  finding.require("whether (11) is 0/0 at a distance of 1000, Lehtinen's basis", IsExactly{0},
                  without_value(lehtinen, far));
  finding.require("whether (11) is 0/0 at a normal turned away, Shepard's basis", IsExactly{0},
                  without_value(shepard, turned));
  ExactSites random(42);
  const Site<Rational> site = random.several_on_axis(site_count, true).front();
  finding.instead("whether (11) is 0/0 at a site, Lehtinen's basis", IsExactly{0},
                  without_value(lehtinen, site));
  finding.instead("whether (11) is 0/0 at a site, Shepard's basis", IsExactly{0},
                  without_value(shepard, site));
  finding.control("whether (11) is 0/0 at a site, elements less their mean", IsExactly{0},
                  without_value(centred, site));
  return finding;
}

Finding section_4_normalised(const Bench&) {
  Finding finding;
  finding.require("points where (8) or (9) fails, Shepard's basis", IsExactly{0}, not_partitions(shepard));
  finding.require("points where (8) or (9) fails, Lehtinen's basis", IsExactly{0}, not_partitions(lehtinen));
  finding.control("points where (8) or (9) fails, (11) of elements with both signs", IsExactly{0},
                  not_partitions(lowered));
  finding.control("points where (8) or (9) fails, elements that are not normalised", IsExactly{0},
                  not_partitions(lehtinen_raw));
  return finding;
}

Finding section_3_compact(const Bench&) {
  // How many of the distances 10, 100, ..., 10^6 the first element is not zero at.
  const auto reached = [](const Basis& basis) {
    ExactSites random(43);
    const Sites sites = random.several_on_axis(site_count, true);
    long total = 0;
    for (int k = 1; k <= 6; ++k) {
      const std::vector<Rational> values = basis(sites, {{power(Rational(10), k), 0, 0}, {0, 0, 1}});
      if (!values.empty() && values.front().sign() != 0) ++total;
    }
    return Rational(total);
  };
  Finding finding;
  finding.require("distances up to 10^6 at which an element is not zero, Lehtinen's", IsExactly{0},
                  reached(lehtinen_raw));
  finding.require("distances up to 10^6 at which an element is not zero, Shepard's", IsExactly{0},
                  reached(shepard));
  long reached_by_gauss = 0;
  for (int k = 1; k <= 6; ++k)
    if (certainly_positive(gaussian_bell(Ball(power(Rational(10), k))))) ++reached_by_gauss;
  finding.control("distances up to 10^6 at which an element is not zero, Gauss' uncut", IsExactly{0},
                  Rational(reached_by_gauss));
  return finding;
}

}  // namespace radcert::verification::psg10
