// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/psg10/exact_sites.h"

#include <algorithm>

namespace radcert::verification::psg10 {

std::vector<Site<Rational>> ExactSites::several_in_space(std::size_t count) {
  std::vector<Site<Rational>> sites;
  while (sites.size() < count) {
    const Site<Rational> next = in_space();
    if (std::none_of(sites.begin(), sites.end(),
                     [&](const Site<Rational>& site) { return site.point == next.point; }))
      sites.push_back(next);
  }
  return sites;
}

std::vector<Site<Rational>> ExactSites::several_on_axis(std::size_t count, bool flat) {
  std::vector<Site<Rational>> sites;
  for (std::size_t i = 0; i < count; ++i) {
    const Rational place = Rational(static_cast<long>(i)) + Rational(below(7) - 3, 8);
    sites.push_back({{place, 0, 0}, flat ? Vector<Rational>{0, 0, 1} : normal(1)});
  }
  return sites;
}

Site<Rational> ExactSites::on_axis(std::size_t count, bool flat) {
  const Rational place = Rational(below(16 * static_cast<long>(count + 1) + 1), 16) - Rational(1);
  return {{place, 0, 0}, flat ? Vector<Rational>{0, 0, 1} : normal(1)};
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

std::vector<Rational> normalised(std::vector<Rational> raw) {
  Rational sum(0);
  for (const Rational& value : raw) sum += value;
  if (sum.sign() == 0) return {};
  for (Rational& value : raw) value /= sum;
  return raw;
}

std::vector<Rational> shepard_elements(std::span<const Site<Rational>> sites, const Site<Rational>& p) {
  std::vector<Rational> raw;
  for (const Site<Rational>& site : sites) {
    const Vector<Rational> step = p.point - site.point;
    const Rational factor = normal_factor(p, site);
    const Rational square = dot(step, step);
    if (square.sign() == 0 && factor.sign() > 0) {
      std::vector<Rational> at_site(sites.size(), Rational(0));
      at_site[raw.size()] = 1;
      return at_site;
    }
    raw.push_back(factor.sign() == 0 ? Rational(0) : factor * factor / square);
  }
  return normalised(std::move(raw));
}

}  // namespace radcert::verification::psg10
