// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/meshless/radial_basis.h"
#include "radcert/meshless/radial_element.h"
#include "radcert/meshless/site.h"

namespace radcert::laws {

/// All elements of a basis at a site, zeros included, in the order of the sites; nothing where the basis has
/// no value.
using Elements = std::function<std::optional<std::vector<double>>(const Site<double>&)>;

/// How a basis comes of its sites.
using ElementsOf = std::function<Elements(const SiteSet&)>;

inline Elements elements_of(const RadialBasis& basis) {
  return [basis](const Site<double>& p) -> std::optional<std::vector<double>> {
    BasisValues room;
    if (!basis.evaluate(p, room)) return std::nullopt;
    std::vector<double> all(basis.size(), 0.0);
    for (std::size_t k = 0; k < room.size(); ++k) all[room.sites()[k]] = room.values()[k];
    return all;
  };
}

/// ContractViolation, with the reason, where these sites are refused.
inline ElementsOf elements_by(const RadialBasisChoice& choice) {
  return [choice](const SiteSet& sites) { return elements_of(RadialBasis::make(sites, choice).value()); };
}

/// A point of the unit sphere with rational coordinates, on the stereographic image of (a/b, c/b).
inline Vector<Rational> rational_direction(const Rational& s, const Rational& t) {
  const Rational q = s * s + t * t;
  const Rational scale = Rational(1) / (Rational(1) + q);
  return {Rational(2) * s * scale, Rational(2) * t * scale, (Rational(1) - q) * scale};
}

/// Sites in a cube of edge 1 whose coordinates are multiples of 1/64 and whose normals are about `towards_z`
/// or anywhere, from a fixed stream.
inline std::vector<Site<Rational>> random_sites(std::uint64_t seed, std::size_t count, bool towards_z) {
  std::mt19937_64 random(seed);
  const auto small = [&random](int range) {
    return Rational(static_cast<int>(random() % static_cast<unsigned>(2 * range + 1)) - range, 64);
  };
  std::vector<Site<Rational>> sites;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector<Rational> point{small(32), small(32), small(32)};
    const int range = towards_z ? 16 : 128;
    sites.push_back({point, rational_direction(small(range), small(range))});
  }
  return sites;
}

inline Site<double> in_double(const Site<Rational>& site) {
  const auto number = [](const Vector<Rational>& v) {
    return Vector<double>{v.x.to_double(), v.y.to_double(), v.z.to_double()};
  };
  return {number(site.point), number(site.normal)};
}

inline SiteSet in_double(std::span<const Site<Rational>> sites) {
  SiteSet set;
  for (const Site<Rational>& site : sites) set.add(in_double(site), {});
  return set;
}

namespace detail {

inline std::string text(const Vector<double>& v) {
  return "(" + description(v.x) + ", " + description(v.y) + ", " + description(v.z) + ")";
}

inline std::string text(const Site<double>& p) { return text(p.point) + " with normal " + text(p.normal); }

inline ::testing::AssertionResult without_value(const Site<double>& p) {
  return ::testing::AssertionFailure() << "no value at " << text(p);
}

}  // namespace detail

/// phi_i(p_j) = delta_ij.
inline ::testing::AssertionResult interpolates(const Elements& elements, const SiteSet& sites,
                                               double tolerance) {
  for (std::size_t j = 0; j < sites.size(); ++j) {
    const auto values = elements(sites[j]);
    if (!values) return detail::without_value(sites[j]);
    for (std::size_t i = 0; i < sites.size(); ++i)
      if (!(std::abs((*values)[i] - (i == j ? 1 : 0)) <= tolerance))
        return ::testing::AssertionFailure()
               << "element " << i << " is " << description((*values)[i]) << " at site " << j;
  }
  return ::testing::AssertionSuccess();
}

/// phi_i(p) >= 0.
inline ::testing::AssertionResult is_nonnegative(const Elements& elements,
                                                 std::span<const Site<double>> points) {
  for (const Site<double>& p : points)
    if (const auto values = elements(p))
      for (std::size_t i = 0; i < values->size(); ++i)
        if (!((*values)[i] >= 0))
          return ::testing::AssertionFailure()
                 << "element " << i << " is " << description((*values)[i]) << " at " << detail::text(p);
  return ::testing::AssertionSuccess();
}

/// [psg10, (8)-(9)] at the points where the basis has a value; at least one must.
inline ::testing::AssertionResult is_partition_of_unity(const Elements& elements,
                                                        std::span<const Site<double>> points,
                                                        double tolerance) {
  if (auto nonnegative = is_nonnegative(elements, points); !nonnegative) return nonnegative;
  bool any = false;
  for (const Site<double>& p : points) {
    const auto values = elements(p);
    if (!values) continue;
    any = true;
    const double sum = std::accumulate(values->begin(), values->end(), 0.0);
    if (!(std::abs(sum - 1) <= tolerance))
      return ::testing::AssertionFailure()
             << "the elements sum to " << description(sum) << " at " << detail::text(p);
  }
  if (!any) return ::testing::AssertionFailure() << "no point has a value";
  return ::testing::AssertionSuccess();
}

/// [psg10, (10)] with its bounds in order: c_min <= sum_i c_i phi_i(p) <= c_max, for coefficients from a
/// fixed stream.
inline ::testing::AssertionResult stays_between_coefficients(const Elements& elements,
                                                             std::span<const Site<double>> points,
                                                             std::uint64_t seed, double tolerance) {
  std::mt19937_64 random(seed);
  for (const Site<double>& p : points) {
    const auto values = elements(p);
    if (!values) continue;
    std::vector<double> c(values->size());
    for (double& number : c) number = static_cast<double>(random() % 2001) / 1000 - 1;
    const double sum = std::inner_product(c.begin(), c.end(), values->begin(), 0.0);
    const auto [low, high] = std::minmax_element(c.begin(), c.end());
    if (!(*low - tolerance <= sum && sum <= *high + tolerance))
      return ::testing::AssertionFailure()
             << "the sum is " << description(sum) << " at " << detail::text(p) << ", coefficients are from "
             << description(*low) << " to " << description(*high);
  }
  return ::testing::AssertionSuccess();
}

/// The site distance as its definition has it: infinite where the normals are not within 90 degrees, unless
/// it is Euclidean alone.
inline double site_distance(SiteDistance distance, const Site<double>& p, const Site<double>& q) {
  const double length = norm(p.point - q.point);
  if (distance == SiteDistance::euclidean) return length;
  const double cosine = dot(p.normal, q.normal);
  if (!(cosine > 0)) return std::numeric_limits<double>::infinity();
  return distance == SiteDistance::normal_sensitive ? length / cosine : length;
}

/// phi_i(p) = 0 where ||p, p_i|| > support alpha_i.
inline ::testing::AssertionResult is_local(const Elements& elements, const SiteSet& sites,
                                           std::span<const double> radii, SiteDistance distance,
                                           double support, std::span<const Site<double>> points) {
  for (const Site<double>& p : points) {
    const auto values = elements(p);
    if (!values) continue;
    for (std::size_t i = 0; i < sites.size(); ++i) {
      const double reach = support * radii[i] * (1 + 0x1p-40);
      if ((*values)[i] != 0 && site_distance(distance, p, sites[i]) > reach)
        return ::testing::AssertionFailure() << "element " << i << " is " << description((*values)[i])
                                             << " at " << detail::text(p) << ", beyond its support";
    }
  }
  return ::testing::AssertionSuccess();
}

/// Two routes to the elements: relative to the largest of them.
inline ::testing::AssertionResult agree(const Elements& first, const Elements& second,
                                        std::span<const Site<double>> points, double tolerance) {
  for (const Site<double>& p : points) {
    const auto a = first(p);
    const auto b = second(p);
    if (a.has_value() != b.has_value())
      return ::testing::AssertionFailure() << "only one of them has a value at " << detail::text(p);
    if (!a) continue;
    const double scale = std::max(*std::max_element(a->begin(), a->end()), 1e-300);
    for (std::size_t i = 0; i < a->size(); ++i)
      if (!(std::abs((*a)[i] - (*b)[i]) <= tolerance * scale))
        return ::testing::AssertionFailure() << "element " << i << " is " << description((*a)[i]) << " and "
                                             << description((*b)[i]) << " at " << detail::text(p);
  }
  return ::testing::AssertionSuccess();
}

/// A rotation about the axis (1, 2, 2)/3 by the angle with the cosine 7/25, moved by (1/2, -1/4, 1/8).
inline Site<double> moved(const Site<double>& p) {
  const Vector<double> axis{1.0 / 3, 2.0 / 3, 2.0 / 3};
  constexpr double cosine = 7.0 / 25;
  constexpr double sine = 24.0 / 25;
  const auto rotated = [&](const Vector<double>& v) {
    return cosine * v + sine * cross(axis, v) + ((1 - cosine) * dot(axis, v)) * axis;
  };
  return {rotated(p.point) + Vector<double>{0.5, -0.25, 0.125}, rotated(p.normal)};
}

/// The basis of moved sites at moved points is the basis at the points.
inline ::testing::AssertionResult is_invariant_under_motions(const ElementsOf& elements_of_sites,
                                                             const SiteSet& sites,
                                                             std::span<const Site<double>> points,
                                                             double tolerance) {
  SiteSet there;
  for (std::size_t i = 0; i < sites.size(); ++i) there.add(moved(sites[i]), sites.at[i]);
  const Elements elements = elements_of_sites(there);
  return agree(
      elements_of_sites(sites), [&elements](const Site<double>& p) { return elements(moved(p)); }, points,
      tolerance);
}

/// The basis of reordered sites is the reordered basis.
inline ::testing::AssertionResult follows_permutations(const ElementsOf& elements_of_sites,
                                                       const SiteSet& sites,
                                                       std::span<const Site<double>> points,
                                                       std::uint64_t seed, double tolerance) {
  std::vector<std::size_t> place(sites.size());
  std::iota(place.begin(), place.end(), std::size_t{0});
  std::mt19937_64 random(seed);
  for (std::size_t i = place.size(); i > 1; --i) std::swap(place[i - 1], place[random() % i]);
  SiteSet reordered;
  for (const std::size_t i : place) reordered.add(sites[i], sites.at[i]);
  const Elements elements = elements_of_sites(reordered);
  const auto back = [&](const Site<double>& p) {
    auto values = elements(p);
    if (!values) return values;
    std::vector<double> in_order(values->size());
    for (std::size_t k = 0; k < place.size(); ++k) in_order[place[k]] = (*values)[k];
    return std::optional(in_order);
  };
  return agree(elements_of_sites(sites), back, points, tolerance);
}

/// Three sites on a line whose normals turn by the angle with the cosine 4/5 from one to the next.
/// Maths     ||p, q|| = ||q, r|| = 5/4, ||p, r|| = 2 / (7/25) = 50/7 > 5/2
inline std::array<Site<Rational>, 3> triple_against_the_triangle_inequality() {
  const Rational zero(0);
  return {{{{zero, zero, zero}, {zero, zero, Rational(1)}},
           {{Rational(1), zero, zero}, {Rational(3, 5), zero, Rational(4, 5)}},
           {{Rational(2), zero, zero}, {Rational(24, 25), zero, Rational(7, 25)}}}};
}

/// ||p, q|| + ||q, r|| < ||p, r|| in the normal-sensitive distance (15), decided without rounding.
/// Maths     with the squares A, B of the left and C of the right: sqrt A + sqrt B < sqrt C if and only if C
///           - A - B > 0 and 4 A B < (C - A - B)^2
inline bool breaks_the_triangle_inequality(const std::array<Site<Rational>, 3>& sites) {
  const auto& [p, q, r] = sites;
  const Rational a = squared_site_distance(p, q);
  const Rational b = squared_site_distance(q, r);
  const Rational rest = squared_site_distance(p, r) - a - b;
  return rest > Rational(0) && Rational(4) * a * b < rest * rest;
}

}  // namespace radcert::laws
