// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "radcert/continuous/elements/graded_elements.h"
#include "radcert/continuous/elements/sector.h"
#include "radcert/continuous/elements/tensor_legendre.h"

namespace radcert {

/// A part of an element.
struct PartOfElement {
  std::size_t element = 0;
  SectorBox box;
};

/// A part of which observers see any share, from nothing to all.
struct ShadedPart {
  PartOfElement part;
  double mass = 0;  ///< of T 1, at most, if it were seen
};

/// What observers see of a panel: some parts, and of others any share.
struct SeenPanel {
  std::vector<PartOfElement> whole;
  std::vector<ShadedPart> shaded;
};

/// What is seen of a whole panel from the convex hull of points of another.
[[nodiscard]] PanelView view_of_panel(const SectorScene& scene, std::size_t panel,
                                      std::span<const Vector<double>> hull, std::size_t other);

/// What a cell's observers see of the elements.
/// Maths     parts of which nothing is known are halved until they are half as large as the cell, or send no
///           more than least_mass. Half of what is left is counted: T w = F + sum over the shaded parts p of
///           (1/pi) Int_p (V - 1/2) G w, F = sum of T w over what is seen and half of that over the shaded
///           parts. For any numbers c_k, T w_k = F_k + c_k (1 - F 1) + the same sum with w_k - c_k, since T 1
///           = 1: it is at most 1/2 sum of mass sup_p |w_k - c_k|
/// Requires  the scene, the elements and the functions outlive it
class Penumbra {
public:
  Penumbra(const SectorScene& scene, std::span<const SectorElement> elements, const SectorFunctions& w);

  /// Of another panel, from the convex hull of points of a panel; all of it is whole where view_of_panel is.
  [[nodiscard]] SeenPanel seen(std::size_t panel, std::span<const Vector<double>> hull, std::size_t other,
                               double least_mass) const;
  /// All elements that may be shaded from somewhere in a panel.
  [[nodiscard]] std::vector<PartOfElement> may_be_shaded(std::size_t panel) const;
  /// What of these parts, in the order of their panels, is shaded from a convex hull of points of a panel.
  [[nodiscard]] std::vector<ShadedPart> shaded(std::size_t panel, std::span<const Vector<double>> hull,
                                               std::span<const PartOfElement> parts, double least_mass) const;

  /// Numbers c_k near what shaded parts send, and what is left.
  struct Rest {
    std::vector<double> constants;  ///< c_k, by function
    std::vector<double> bounds;     ///< of |T w_k - F_k - c_k (1 - F 1)|
  };
  [[nodiscard]] Rest rest(std::span<const ShadedPart> shaded) const;
  /// The same where c_k is w_k on a part of the edge of an element, t = 0.
  [[nodiscard]] Rest rest_at_edge(std::span<const ShadedPart> shaded, std::size_t element,
                                  const SectorBox& part) const;
  /// A bound of |w_k| on an element.
  [[nodiscard]] double size(std::size_t element, std::size_t k) const {
    return size_[element * w_.count() + k];
  }

private:
  /// w in the middle of parts, and how far it may be from that elsewhere; by part, function.
  struct Values {
    std::vector<double> middle;
    std::vector<double> spread;
    void add(const Penumbra& of, std::size_t element, const PartOfInterval& in_s, const PartOfInterval& in_t);
  };
  [[nodiscard]] SeenPanel look(std::size_t panel, std::span<const Vector<double>> hull, std::size_t other,
                               std::span<const PartOfElement> parts, double least_mass) const;
  [[nodiscard]] std::size_t panel_of(const PartOfElement& part) const {
    return scene_.sectors()[elements_[part.element].sector].panel;
  }
  [[nodiscard]] Values values(std::span<const ShadedPart> shaded) const;
  [[nodiscard]] Rest rest(std::span<const ShadedPart> shaded, const Values& values,
                          std::vector<double> constants, std::span<const double> spread) const;

  const SectorScene& scene_;
  std::span<const SectorElement> elements_;
  const SectorFunctions& w_;
  std::vector<double> slope_s_;  ///< by element, function: of |dw/dx|, x in [-1,1]
  std::vector<double> slope_t_;
  std::vector<double> size_;                ///< by element, function: of |w|
  std::vector<std::size_t> first_element_;  ///< of each panel, and the number of all
};

}  // namespace radcert
