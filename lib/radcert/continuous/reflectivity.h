// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "radcert/continuous/elements/graded_elements.h"
#include "radcert/continuous/elements/panel_reflectivity.h"
#include "radcert/continuous/elements/sector.h"
#include "radcert/continuous/elements/tensor_legendre.h"

namespace radcert {

/// The reflectivity of a polyhedron.
/// Maths     rho >= 0, a polynomial on each panel. A polynomial of degree d on the panel has at most the
///           degree d in each parameter of a sector
class Reflectivity {
public:
  /// Constants, by panel.
  Reflectivity(std::vector<double> by_panel)  // NOLINT(google-explicit-constructor): the same numbers
      : largest_(std::move(by_panel)) {}
  /// Requires  as many as there are panels
  explicit Reflectivity(const std::vector<PanelReflectivity>& by_panel);

  /// In each parameter of a sector.
  [[nodiscard]] int degree() const { return degree_; }
  /// Of one panel: a constant rounded to the nearest, else at least sup rho.
  [[nodiscard]] double largest(std::size_t panel) const { return largest_[panel]; }
  /// The exact polynomials by panel; none where all are constants.
  [[nodiscard]] const std::vector<PlanePolynomial<Rational>>* polynomials() const {
    return polynomials_.get();
  }

private:
  std::vector<double> largest_;
  int degree_ = 0;
  std::shared_ptr<const std::vector<PlanePolynomial<Rational>>> polynomials_;
};

/// Products of the reflectivity and polynomials on elements.
/// Maths     rho = sum c_ab P_a P_b on an element, each coefficient rounded to the nearest. P_a P_i = sum_l
///           g_ail P_l with g >= 0 and sum_l g_ail = 1, so that the coefficients of rho f sum to no more than
///           |rho| |f|, |.| the sum of the sizes of the coefficients
class ElementReflectivity {
public:
  ElementReflectivity(const Reflectivity& reflectivity, const SectorScene& scene,
                      std::span<const SectorElement> elements);

  [[nodiscard]] int degree() const { return functions_.degree(); }
  /// At least sup rho on an element; a constant rounded to the nearest.
  [[nodiscard]] double largest(std::size_t element) const { return largest_[element]; }
  /// rho itself, on elements.
  [[nodiscard]] const SectorFunctions& functions() const { return functions_; }

  /// to += rho f on an element; coefficients of f, and of `to`, whose degree is larger by degree().
  /// Result    by at most rounding(...) off in the sum of the sizes
  void add_product(std::size_t element, std::span<const double> f, std::span<double> to) const;
  /// What rounding does to E + rho f in the sum of the coefficients' sizes, rho and E being rounded too.
  /// Maths     for each a and l at most r + 1 of the g_ail are not 0, r the degree of rho: sums over b and j,
  ///           and then over a and i, have (r+1)^2 terms at most. With the roundings of c, g, products and E:
  ///           (2 (r+1)^2 + 8) u (|E| + |rho| |f|)
  [[nodiscard]] double rounding(std::size_t element, std::span<const double> emission,
                                std::span<const double> f) const;

private:
  /// The g_ail by a, i, l.
  [[nodiscard]] static std::vector<double> linearisation(std::size_t of_rho, std::size_t of_f);

  SectorFunctions functions_;
  std::vector<double> largest_;
  /// For f with as many powers as is its place.
  std::vector<std::vector<double>> linearisations_;
};

}  // namespace radcert
