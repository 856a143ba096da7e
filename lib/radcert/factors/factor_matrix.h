// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "radcert/core/files/result_store.h"
#include "radcert/core/memory_plan.h"
#include "radcert/core/ranks/ranks.h"
#include "radcert/factors/facet_scene.h"

namespace radcert {

/// The surfaces between which factors are asked for, as unions of triangles.
struct FactorUnits {
  std::vector<std::size_t> of_triangle;
  std::vector<std::string> names;
};

/// The accuracy demanded of a matrix of configuration factors, and how it is to be computed.
struct FactorDemand {
  bool certified = false;      ///< each radius proved
  double accuracy = 1e-5;      ///< of each row's sum, for what occlusion leaves to adaptive integration
  bool open_to_space = false;  ///< the scene is open: what a row's sum lacks goes to space
};

/// The direct exchange area of two triangles, and how it was found.
struct PairExchange {
  Approximation area = Approximation::exact(0);
  PairSight sight = PairSight::nothing;
};

/// A configuration factor that is not exactly zero.
struct ConfigurationFactor {
  std::size_t from = 0;
  std::size_t to = 0;
  Approximation factor;
};

/// A row of the matrix as a whole; the area in the square of a length of 1, whatever the scene's unit.
struct FactorRow {
  Approximation area = Approximation::exact(0);
  Approximation sum = Approximation::exact(0);
  std::optional<Approximation> to_space;
};

/// The configuration factors of a scene.
/// Maths     F_IJ = E_IJ / A_I, E_IJ = sum of the direct exchange areas of the triangles of I and J, A_I the
///           sum of their areas; to_space = 1 - sum_J F_IJ
/// Result    entries by rows, then columns. Each E_ij with i < j is computed once, so that A_I F_IJ = A_J
///           F_JI by construction, and nothing is adjusted afterwards: closure, |sum_J F_IJ - 1| in a closed
///           scene, is a check. guaranteed: radii are proved
struct FactorMatrix {
  bool guaranteed = false;
  std::vector<ConfigurationFactor> entries;
  std::vector<FactorRow> rows;
  std::size_t whole_pairs = 0;  ///< of triangles
  std::size_t hidden_pairs = 0;
  std::size_t mixed_pairs = 0;
  std::uint64_t rays = 0;           ///< of ray_factors; then pairs are not counted
  std::size_t entry_count = 0;      ///< of entries, or of those that were given to FactorProgress::row
  double largest_given_radius = 0;  ///< of them
  double largest_reciprocity_defect =
      0;  ///< bounds |A_I F_IJ - A_J F_JI| / sqrt(A_I A_J) of the doubles as given, rounded up
  [[nodiscard]] double largest_radius() const;
  /// The row whose sum is farthest from 1.
  [[nodiscard]] std::size_t worst_row() const;
  [[nodiscard]] double closure_defect(std::size_t row) const;
  /// The next row: kept in entries, or given to the sink where there is one.
  void take(std::span<const ConfigurationFactor> row, double reciprocity_defect,
            const std::function<void(std::span<const ConfigurationFactor>)>& sink);
};

/// Where a computation of a matrix reports its progress and keeps finished rows.
struct FactorProgress {
  /// Called between blocks of pairs with the fraction of pairs done.
  std::function<void(double)> at = [](double) {};
  std::string key{};  ///< all that the scene depends on; demand, and units where they count, are added
  ResultStore* store = nullptr;  ///< finished blocks of pairs are kept there and not computed again
  /// Called with the factors of one row after the other; where it is set, FactorMatrix::entries stays empty.
  std::function<void(std::span<const ConfigurationFactor>)> row{};
  /// Who share the blocks of pairs, each with a store of its own or all with one: see factor_matrix.
  const Ranks* ranks = &one_rank();
};

/// Whether a matrix holds its factors, or gives them away row by row.
enum class FactorsKept { all, none };

/// An estimate of the time that a matrix will take, found by computing some of its pairs.
struct FactorPlan {
  MemoryPlan memory;
  double seconds = 0;  ///< on the threads there are
  std::uint64_t pairs = 0;
  double radius = 0;  ///< of the row sums, the mean by area, as the pairs that were computed have it
};

/// Pairs evenly spread over the matrix are timed, those between which light passes until their mean is known
/// to a tenth, or for 3 seconds or a hundredth of the whole; what they take on average is taken for all.
[[nodiscard]] FactorPlan factor_plan(const FacetScene& scene, const FactorUnits& units,
                                     const FactorDemand& demand, FactorsKept kept);

/// The direct exchange area of two triangles of a scene.
/// Maths     A_i F_ij
/// Source    exchange_area, visible_exchange_area; certified: certified_exchange_area
/// Requires  triangles that are there
/// Result    mixed pairs: to accuracy A_i A_j / A, A the scene's area, which gives each row a radius of about
///           `accuracy`, unless cells or work are used up: then a wider one. Exactly 0 with radius 0 where
///           nothing is seen. certified: the radius is proved, however wide; a shadow is driven to the same
///           accuracy, or to its limit of work
[[nodiscard]] PairExchange pair_exchange(const FacetScene& scene, std::size_t first, std::size_t second,
                                         const FactorDemand& demand);

/// All factors between units.
/// Maths     FactorMatrix
/// Requires  of_triangle has a unit below names.size() for each triangle, each unit a triangle, accuracy > 0,
///           else ContractViolation
/// Result    the same bits for any number of threads, and whether rows came from the store or not;
///           Interrupted where the user asked to stop: finished blocks of pairs are in the store. Of several
///           ranks, which call this together, the first is given the matrix, with the bits that it has
///           without others, and the others an empty one
/// Limits    holds two doubles for each pair of units, and each factor unless FactorProgress::row takes it
[[nodiscard]] FactorMatrix factor_matrix(const FacetScene& scene, const FactorUnits& units,
                                         const FactorDemand& demand, const FactorProgress& progress);

/// The factor of an exchange area, such that A_I F_IJ = A_J F_JI but for rounding.
[[nodiscard]] Approximation exchange_over_area(const Approximation& exchange, const Approximation& area);

/// A bound of |A_I F_IJ - A_J F_JI| / sqrt(A_I A_J) for these doubles: in double the products of which it is
/// the difference would be rounded to the same number.
[[nodiscard]] double reciprocity_defect(double area, double factor, double other_area, double back);

}  // namespace radcert
