// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/meshless/meshless_choice.h"
#include "radcert/meshless/site.h"

namespace radcert {

/// The square of the normal-sensitive site distance.
/// Maths     |p^ - q^|^2 / (p->.q->)^2
/// Source    [psg10, (15)]
/// Requires  p->.q-> > 0: elsewhere the distance is infinite
/// Result    as R rounds; exact in Rational
template <Field R>
R squared_site_distance(const Site<R>& p, const Site<R>& q) {
  const Vector<R> step = p.point - q.point;
  const R cosine = dot(p.normal, q.normal);
  return dot(step, step) / (cosine * cosine);
}

/// A raw element.
/// Maths     psi(p) = Phi(||p, q|| / alpha), times max{0, p->.q->} where the distance says so; 0 where the
///           distance is infinite
/// Source    [psg10, (16)-(18)]
/// Requires  alpha > 0
/// Result    as R rounds; enclosed in balls, also where the sign of p->.q-> is open, if the mother function
///           has a name
/// Limits    Shepard's is unbounded at p = q: infinite in double, a failure in balls; see shepard_values
template <Real R>
R raw_element(const RadialBasisChoice& choice, const Site<R>& p, const Site<R>& centroid, const R& radius) {
  const R length = norm(p.point - centroid.point);
  if (choice.distance == SiteDistance::euclidean) return choice.mother.value(R(length / radius));
  const R cosine = dot(p.normal, centroid.normal);
  if (certainly_at_most(cosine, R(0))) return R(0);
  if (choice.distance == SiteDistance::euclidean_with_normal_factor)
    return choice.mother.value(R(length / radius)) * larger_of(cosine, R(0));
  if constexpr (Enclosing<R>) {
    // ||p, q|| >= |p^ - q^|, and Phi decreases.
    if (!certainly_positive(cosine) && choice.mother.is_monotone())
      return hull(R(0), choice.mother.value(R(length / radius)));
  }
  return choice.mother.value(R(length / (radius * cosine)));
}

/// All elements of a basis at a site, by the formula alone.
/// Maths     phi_i(p), i = 1, ..., n
/// Source    [psg10, (11), (16)-(18)]
/// Requires  as many radii as sites, all positive
/// Result    values in the order of the sites, zeros included; as R rounds, enclosed in balls
/// Limits    n operations and no search: RadialBasis is the fast way in double. A normalised basis has no
///           value where no element has one: not a number in double, a failure in balls. Shepard's has its
///           limit at a site: see shepard_values
template <Real R>
std::vector<R> basis_values(const RadialBasisChoice& choice, std::span<const Site<R>> sites,
                            std::span<const R> radii, const Site<R>& p) {
  expects(sites.size() == radii.size(), "a radius for each site", named("sites", sites.size()),
          named("radii", radii.size()));
  std::vector<R> values;
  values.reserve(sites.size());
  R sum(0);
  for (std::size_t i = 0; i < sites.size(); ++i) {
    values.push_back(raw_element(choice, p, sites[i], radii[i]));
    sum = sum + values.back();
  }
  if (choice.normalise == Normalisation::partition_of_unity)
    for (R& value : values) value = value / sum;
  return values;
}

/// Shepard's basis without a division by zero at the sites.
/// Maths     phi_i = prod_{j != i} d_j^2 / sum_k prod_{j != k} d_j^2, which is d_i^-2 / sum_k d_k^-2 where no
///           d_k is 0
/// Source    [psg10, (16)], multiplied by all d_j^2
/// Requires  at least one distance, at most one of them zero
/// Result    as R rounds; exact in Rational. At d_i = 0: phi_i = 1, all others 0
/// Limits    products of many distances leave the range of a double: for Rational and balls
template <Field R>
std::vector<R> shepard_values(std::span<const R> squared_distances) {
  expects(!squared_distances.empty(), "at least one distance");
  const std::size_t n = squared_distances.size();
  std::vector<R> values(n, R(1));
  R before(1);
  R behind(1);
  for (std::size_t i = 0; i < n; ++i) {
    values[i] = values[i] * before;
    before = before * squared_distances[i];
    values[n - 1 - i] = values[n - 1 - i] * behind;
    behind = behind * squared_distances[n - 1 - i];
  }
  R sum(0);
  for (const R& value : values) sum = sum + value;
  for (R& value : values) value = value / sum;
  return values;
}

}  // namespace radcert
