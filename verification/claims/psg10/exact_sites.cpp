// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/psg10/exact_sites.h"

#include "radcert/meshless/radial_element.h"

namespace radcert::verification::psg10 {

std::vector<Site<Rational>> ExactSites::several_on_axis(std::size_t count) {
  std::vector<Site<Rational>> sites;
  for (std::size_t i = 0; i < count; ++i) {
    const Rational place = Rational(static_cast<long>(i)) + Rational(below(7) - 3, 8);
    sites.push_back({{place, 0, 0}, {0, 0, 1}});
  }
  return sites;
}

Rational normal_factor(const Site<Rational>& p, const Site<Rational>& q) {
  const Rational cosine = dot(p.normal, q.normal);
  return cosine.sign() > 0 ? cosine : Rational(0);
}

std::vector<Rational> raw_lehtinen(std::span<const Site<Rational>> sites, const Rational& alpha,
                                   const Site<Rational>& p) {
  std::vector<Rational> values;
  for (const Site<Rational>& site : sites)
    values.push_back(spline_bell(Rational(abs(p.point.x - site.point.x) / alpha)) * normal_factor(p, site));
  return values;
}

std::vector<Rational> shepard_elements(std::span<const Site<Rational>> sites, const Site<Rational>& p) {
  std::vector<std::size_t> near;
  std::vector<Rational> squares;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    if (normal_factor(p, sites[i]).sign() == 0) continue;
    near.push_back(i);
    squares.push_back(squared_site_distance(p, sites[i]));
  }
  if (near.empty()) return {};
  const std::vector<Rational> of_near = shepard_values<Rational>(squares);
  std::vector<Rational> values(sites.size(), Rational(0));
  for (std::size_t k = 0; k < near.size(); ++k) values[near[k]] = of_near[k];
  return values;
}

}  // namespace radcert::verification::psg10
