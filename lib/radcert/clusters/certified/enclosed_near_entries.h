// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "radcert/clusters/cluster_pairs.h"
#include "radcert/collocation/certified/plane_chart.h"
#include "radcert/core/memory_plan.h"
#include "radcert/core/outcome.h"
#include "radcert/polynomial/lagrange_functions.h"
#include "radcert/scalar/bounded_double.h"
#include "radcert/surface/surface.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

/// The entries of the collocation matrix between leaves that are near each other, proved, with the
/// reflectivity 1.
/// Maths     |entry(i, k p + j) - 1/pi Int_{Delta_k} G(v_i,Q) l_j(Q) dS_Q| <= its radius, for v_i and Delta_k
///           in near leaves
/// Source    PlaneElement, as certified_entries, where all charts are plane, else CertifiedKernelSums
/// Result    made by enclosed_near_entries: a dense block a pair of leaves. Products with running errors; the
///           same bits for any number of threads
class EnclosedNearEntries {
public:
  EnclosedNearEntries(const std::vector<NearPair>& pairs, std::size_t leaves, std::size_t unknowns_of_leaf);

  enum class Part { entries, sizes };
  /// y_i += sum_j entry(i, j) x_j, or sum_j |entry(i, j)| x_j, enclosed for all entries within their radii.
  void add(Part part, std::span<const double> x, std::span<BoundedDouble> y) const;

  [[nodiscard]] std::size_t size() const { return entries_.size(); }
  void count(MemoryPlan& plan) const;

private:
  friend Outcome<EnclosedNearEntries> enclosed_near_entries(const Surface& surface,
                                                            const Triangulation& triangulation,
                                                            const LagrangeFunctions& functions,
                                                            const std::vector<NearPair>& pairs,
                                                            std::size_t unknowns_of_leaf, double demand,
                                                            std::uint64_t memory_limit);
  Outcome<void> fill_on_planes(const std::vector<PlaneChart>& planes, const Triangulation& triangulation,
                               const LagrangeFunctions& functions);
  Outcome<void> fill_on_charts(const Surface& surface, const Triangulation& triangulation,
                               const LagrangeFunctions& functions, double demand);
  /// The place of the first entry of a block. Nearness is mutual, so that each of two near leaves stands in
  /// the list of the other.
  [[nodiscard]] std::size_t block(std::size_t target, std::size_t source) const;

  std::size_t leaves_;
  std::size_t unknowns_;
  std::vector<std::size_t> first_;      ///< by target leaf: the place of its first source
  std::vector<std::uint32_t> sources_;  ///< by target leaf, ascending: the leaves near it; one block each
  std::vector<double> entries_;         ///< by block, by column, by row
  std::vector<double> radii_;
};

/// Integrates the entries.
/// Requires  an unoccluded surface, its uniform triangulation, near pairs of leaves of so many unknowns;
///           functions of degree at most 8; 0 < demand
/// Result    where all charts are plane, radii as those of certified_entries; else radii of which those of a
///           row sum up to about the demand, or what roundings in double make wider. Refused in words where
///           an entry is not enclosed: see exact_nodes, IntegralErrors and CertifiedKernelSums; a plane chart
///           against the cross product with functions that are not symmetric. InputError where more memory
///           would be taken than the limit; Interrupted when asked to stop
[[nodiscard]] Outcome<EnclosedNearEntries> enclosed_near_entries(
    const Surface& surface, const Triangulation& triangulation, const LagrangeFunctions& functions,
    const std::vector<NearPair>& pairs, std::size_t unknowns_of_leaf, double demand,
    std::uint64_t memory_limit = static_cast<std::uint64_t>(-1));

}  // namespace radcert
