// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "radcert/continuous/elements/graded_elements.h"
#include "radcert/continuous/elements/sector.h"
#include "radcert/continuous/elements/tensor_legendre.h"
#include "radcert/continuous/occlusion/penumbra.h"

namespace radcert {

/// Points of one panel, close together.
/// Requires  none on an edge of the polyhedron
struct ObserverGroup {
  std::size_t panel = 0;
  std::vector<Vector<double>> points;
  std::vector<Vector<double>> hull = {};  ///< points of the panel that have these in their convex hull
  double least_mass = 0;                  ///< of a shaded part that is worth halving
  bool by_points = false;                 ///< what is shaded is asked for each point alone
};

/// Of shaded parts, where no bound is wanted.
inline constexpr double negligible_mass = 0x1p-13;

/// T f at points, T = (1/pi) Int G V . dS, for functions that are polynomials on elements.
/// Maths     tensor Gauss rules on dyadic parts of the elements, each as large as its RuleChoice says, for as
///           many points together as are close beside the distance. Where panels hide each other: F of
///           Penumbra, and the parts that are shaded from somewhere in the hull
/// Requires  the scene, the elements and the functions outlive it; a hull where panels hide each other
/// Result    the radius holds for all functions: truncation, rounding of points, of the kernel, of the
///           functions and of the sums. It is infinite nearer to another panel than least_kernel_distance
/// Limits    the tolerance is relative to the sizes of the functions, which should be alike; what is reached
///           is the radius
class Transport {
public:
  Transport(const SectorScene& scene, std::span<const SectorElement> elements,
            const SectorFunctions& functions);

  struct Values {
    std::vector<double> values;  ///< by point, function
    double radius = 0;
    std::vector<ShadedPart> shaded = {};  ///< of which half is in the values; the radius is not for them
  };
  /// The panel `without` is left out.
  [[nodiscard]] Values operator()(const ObserverGroup& group, double tolerance,
                                  std::optional<std::size_t> without = std::nullopt) const;

  /// The elements that send anything to points of a panel, where no panel hides another.
  [[nodiscard]] std::vector<PartOfElement> sources(std::size_t panel,
                                                   std::optional<std::size_t> without = std::nullopt) const;
  /// T f from parts of some of these, in their order.
  [[nodiscard]] Values from(std::span<const PartOfElement> sources, const ObserverGroup& group,
                            double tolerance) const;

  [[nodiscard]] const SectorScene& scene() const { return scene_; }
  [[nodiscard]] std::span<const SectorElement> elements() const { return elements_; }
  [[nodiscard]] std::size_t count() const { return count_; }
  /// A bound of |f| for all functions, everywhere and on an element.
  [[nodiscard]] double size() const { return size_; }
  [[nodiscard]] double size(std::size_t element) const { return element_size_[element]; }

private:
  class Sum;
  [[nodiscard]] bool reaches(std::size_t panel, std::size_t to) const;
  [[nodiscard]] Values taken(Sum& sum, std::size_t points) const;

  const SectorScene& scene_;
  std::span<const SectorElement> elements_;
  std::size_t powers_;  ///< degree + 1
  std::size_t count_;
  std::size_t stride_;                      ///< count, filled up to whole packs; 1 of one function
  std::vector<double> coefficients_;        ///< by element, i, j, function; of one by element, j, i
  std::vector<PolynomialSizes> sizes_;      ///< of each element
  std::vector<double> element_size_;        ///< sup |f|
  std::vector<std::size_t> first_element_;  ///< of each panel, and the number of all
  double size_ = 0;
  Penumbra penumbra_;
};

}  // namespace radcert
