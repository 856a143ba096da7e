// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/psg10/exact_sites.h"

#include "radcert/meshless/radial_element.h"

namespace radcert::verification::psg10 {

Vector<Rational> ExactSites::normal_within(const Rational& least) {
  constexpr long chances = 1L << 30;
  for (;;) {
    const Rational s(below(129) - 64, 64);
    const Rational t(below(129) - 64, 64);
    const Rational q = s * s + t * t;
    const Rational scale = Rational(1) / (Rational(1) + q);
    const Vector<Rational> normal{Rational(2) * s * scale, Rational(2) * t * scale,
                                  (Rational(1) - q) * scale};
    if (least < normal.z && Rational(below(chances), chances) < scale * scale) return normal;
  }
}

Vector<Rational> ExactSites::point_of_disk(long radius) {
  for (;;) {
    const Rational x = eighths(radius);
    const Rational y = eighths(radius);
    const Rational square = x * x + y * y;
    if (square.sign() > 0 && square <= Rational(radius * radius)) return {x, y, 0};
  }
}

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
