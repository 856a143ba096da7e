// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/certified/enclosed_near_entries.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "radcert/collocation/certified/certified_chart_entries.h"
#include "radcert/collocation/certified/exact_nodes.h"
#include "radcert/collocation/certified/exchanged_corners.h"
#include "radcert/collocation/certified/lagrange_on_elements.h"
#include "radcert/collocation/certified/plane_chart.h"
#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/quadrature/certified/certified_kernel_sums.h"

namespace radcert {

EnclosedNearEntries::EnclosedNearEntries(const std::vector<NearPair>& pairs, std::size_t leaves,
                                         std::size_t unknowns_of_leaf)
    : leaves_(leaves), unknowns_(unknowns_of_leaf), first_(leaves + 1) {
  std::vector<std::vector<std::uint32_t>> near(leaves);
  for (const NearPair& pair : pairs) {
    near[pair.a].push_back(pair.b);
    if (pair.a != pair.b) near[pair.b].push_back(pair.a);
  }
  for (std::size_t leaf = 0; leaf < leaves; ++leaf) {
    std::sort(near[leaf].begin(), near[leaf].end());
    sources_.insert(sources_.end(), near[leaf].begin(), near[leaf].end());
    first_[leaf + 1] = sources_.size();
  }
}

std::size_t EnclosedNearEntries::block(std::size_t target, std::size_t source) const {
  const auto list = sources_.begin() + static_cast<std::ptrdiff_t>(first_[target]);
  const auto list_end = sources_.begin() + static_cast<std::ptrdiff_t>(first_[target + 1]);
  const auto number = std::lower_bound(list, list_end, source) - sources_.begin();
  return static_cast<std::size_t>(number) * unknowns_ * unknowns_;
}

Outcome<void> EnclosedNearEntries::fill_on_planes(const std::vector<PlaneChart>& planes,
                                                  const Triangulation& triangulation,
                                                  const LagrangeFunctions& functions) {
  const std::size_t p = functions.size();
  std::vector<ExactTriangle> triangles;
  std::vector<bool> reversed;
  for (const ParameterTriangle& triangle : triangulation.triangles) {
    std::array<ParameterPoint<Rational>, 3> corners;
    for (std::size_t c = 0; c < 3; ++c)
      corners[c] = {Rational::exactly(triangle.vertices[c].s), Rational::exactly(triangle.vertices[c].t)};
    const PlaneChart element = planes[triangle.chart].over(corners);
    const Vector<Rational> second = element.origin + element.first;
    const Vector<Rational> third = element.origin + element.second;
    reversed.push_back(element.orientation == Orientation::against_the_cross_product);
    triangles.push_back(reversed.back() ? ExactTriangle{element.origin, third, second}
                                        : ExactTriangle{element.origin, second, third});
  }
  const auto exchanged = places_when_exchanged(functions);
  if (!exchanged && std::find(reversed.begin(), reversed.end(), true) != reversed.end())
    return because(
        "the nodes of the basis and their functions are not symmetric, which elements against the cross "
        "product ask");
  const Outcome<IntegralErrors> errors = IntegralErrors::of(functions);
  if (!errors) return because(errors.reason());
  const Outcome<ExactNodes> exact = exact_nodes(triangles, functions);
  if (!exact) return because(exact.reason());
  const std::vector<PlanePolynomial<Rational>> polynomials = by_monomials(functions);
  /// The place of node or function j of an element among those of its triangle.
  const auto place = [&](std::size_t k, std::size_t j) { return reversed[k] ? (*exchanged)[j] : j; };

  const std::size_t elements = unknowns_ / p;
  parallel_for(leaves_, 1, [&](std::size_t begin, std::size_t end) {
    std::vector<double> values(p);
    for (std::size_t source = begin; source < end; ++source)
      for (std::size_t e = 0; e < elements; ++e) {
        const std::size_t k = source * elements + e;
        const PlaneElement element = plane_element(triangles[k], exact->scale, polynomials);
        for (std::size_t s = first_[source]; s < first_[source + 1]; ++s) {
          const std::size_t target = sources_[s];
          const std::size_t entries = block(target, source);
          for (std::size_t i = 0; i < unknowns_; ++i) {
            const std::size_t of_row = target * elements + i / p;
            const ExactNode& node = exact->nodes[of_row * p + place(of_row, i % p)];
            element.integrals(node.point, node.normal, values);
            const double error = errors->bound(values);
            for (std::size_t j = 0; j < p; ++j) {
              const Approximation entry = certified_entry(1, values[place(k, j)], error);
              const std::size_t at = entries + (e * p + j) * unknowns_ + i;
              entries_[at] = entry.value;
              radii_[at] = entry.radius;
            }
          }
        }
      }
  });
  return {};
}

Outcome<void> EnclosedNearEntries::fill_on_charts(const Surface& surface, const Triangulation& triangulation,
                                                  const LagrangeFunctions& functions, double demand) {
  const std::size_t p = functions.size();
  const LagrangeOnElements on_elements(functions);
  const std::vector<SurfacePoint<Rational>> nodes = exact_collocation_nodes(triangulation, functions);
  const CertifiedKernelSums sums(surface, triangulation, on_elements, nodes, demand);
  const std::size_t elements = unknowns_ / p;
  std::vector<Outcome<void>> found(leaves_);
  parallel_for(leaves_, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t source = begin; source < end; ++source) {
      std::vector<std::uint32_t> points;
      for (std::size_t s = first_[source]; s < first_[source + 1]; ++s)
        for (std::size_t i = 0; i < unknowns_; ++i)
          points.push_back(static_cast<std::uint32_t>(sources_[s] * unknowns_ + i));
      std::vector<double> values(points.size() * p);
      std::vector<double> radius(values.size());
      for (std::size_t e = 0; e < elements && found[source]; ++e) {
        found[source] = sums.element(source * elements + e, points, values, radius);
        for (std::size_t j = 0; j < p; ++j)
          for (std::size_t i = 0; i < points.size(); ++i) {
            const std::size_t from = j * points.size() + i;
            const Approximation entry = certified_entry(1, values[from], radius[from]);
            const std::size_t at =
                block(points[i] / unknowns_, source) + (e * p + j) * unknowns_ + i % unknowns_;
            entries_[at] = entry.value;
            radii_[at] = entry.radius;
          }
      }
    }
  });
  for (const Outcome<void>& of_leaf : found)
    if (!of_leaf) return because(of_leaf.reason());
  if (!std::all_of(radii_.begin(), radii_.end(), [](double radius) { return std::isfinite(radius); }))
    return because("an entry near the diagonal is not enclosed in double");
  return {};
}

void EnclosedNearEntries::add(Part part, std::span<const double> x, std::span<BoundedDouble> y) const {
  expects(x.size() == leaves_ * unknowns_ && y.size() == x.size(), "a number for each unknown",
          named("size", x.size()));
  parallel_for(leaves_, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t leaf = begin; leaf < end; ++leaf)
      for (std::size_t number = first_[leaf]; number < first_[leaf + 1]; ++number)
        for (std::size_t j = 0; j < unknowns_; ++j) {
          const BoundedDouble factor = BoundedDouble::exactly(x[sources_[number] * unknowns_ + j]);
          const std::size_t column = (number * unknowns_ + j) * unknowns_;
          for (std::size_t i = 0; i < unknowns_; ++i) {
            const double entry = entries_[column + i];
            BoundedDouble& to = y[leaf * unknowns_ + i];
            to = to +
                 BoundedDouble(part == Part::entries ? entry : std::abs(entry), radii_[column + i]) * factor;
          }
        }
  });
}

void EnclosedNearEntries::count(MemoryPlan& plan) const {
  plan.add("enclosed near entries", sources_.size() * unknowns_ * unknowns_, 2 * sizeof(double));
}

Outcome<EnclosedNearEntries> enclosed_near_entries(const Surface& surface, const Triangulation& triangulation,
                                                   const LagrangeFunctions& functions,
                                                   const std::vector<NearPair>& pairs,
                                                   std::size_t unknowns_of_leaf, double demand,
                                                   std::uint64_t memory_limit) {
  const std::size_t unknowns = triangulation.triangles.size() * functions.size();
  EnclosedNearEntries result(pairs, unknowns / unknowns_of_leaf, unknowns_of_leaf);
  MemoryPlan plan;
  result.count(plan);
  plan.require(memory_limit);
  const std::size_t places = result.sources_.size() * unknowns_of_leaf * unknowns_of_leaf;
  result.entries_.assign(places, 0.0);
  result.radii_.assign(places, 0.0);
  std::vector<PlaneChart> planes;
  for (std::size_t j = 0; j < surface.chart_count(); ++j) {
    std::optional<PlaneChart> plane = plane_chart(surface, j);
    if (plane) planes.push_back(*std::move(plane));
  }
  const Outcome<void> filled = planes.size() == surface.chart_count()
                                   ? result.fill_on_planes(planes, triangulation, functions)
                                   : result.fill_on_charts(surface, triangulation, functions, demand);
  if (!filled) return because(filled.reason());
  return result;
}

}  // namespace radcert
