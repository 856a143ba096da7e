// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "radcert/core/outcome.h"
#include "radcert/meshless/meshless_choice.h"
#include "radcert/meshless/site.h"

namespace radcert {

/// The elements that are not zero at a site, and room to compute them.
/// Maths     (i, phi_i(p)) for the i in reach
/// Requires  filled by RadialBasis::evaluate
/// Result    sites()[k] is the place of the site whose element has values()[k]; in an order of the basis'
///           own, the same in every run
/// Limits    one a thread
class BasisValues {
public:
  [[nodiscard]] std::span<const std::size_t> sites() const { return std::span(sites_).first(count_); }
  [[nodiscard]] std::span<const double> values() const { return std::span(values_).first(count_); }
  [[nodiscard]] std::size_t size() const { return count_; }

private:
  friend class RadialBasis;
  std::size_t count_ = 0;  ///< how much of the arrays is in use
  std::vector<std::size_t> sites_;
  std::vector<double> values_;
  std::vector<double> distances_;  ///< relative: ||p, p_i|| / alpha_i
  std::vector<double> factors_;    ///< max{0, p->.p_i->}
};

/// A generalized radial basis on sites.
/// Maths     phi_1, ..., phi_n from psi_i(p) = Phi(||p, p_i|| / alpha_i)
/// Source    [psg10, sections V and VI]
/// Result    immutable, shared by threads; every number the same bits as basis_values<double>, but for the
///           order of the normalising sum
/// Limits    elements beyond the mother function's support are not looked at; without a support all are
class RadialBasis {
public:
  /// Refused, by name: fewer sites than neighbours + 1; two sites at distance zero from each other; a site
  /// with fewer than m others at a finite distance, unless the rule takes the farthest; a mother function
  /// that is infinite at 0 and not normalised; a neighbour 0.
  [[nodiscard]] static Outcome<RadialBasis> make(SiteSet sites, RadialBasisChoice choice);

  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] const SiteSet& sites() const;
  [[nodiscard]] const RadialBasisChoice& choice() const;
  /// alpha_i, in the order of the sites.
  [[nodiscard]] std::span<const double> radii() const;
  /// Whether phi_i(p_j) = delta_ij: the mother function is infinite at 0 and the basis normalised.
  [[nodiscard]] bool interpolates() const;

  /// The elements at p. False, and nothing in `out`, where p has no site in reach, and where a normalised
  /// basis has no value because the sum of the elements is not a positive number. At a site of an
  /// interpolating basis: that site alone, with 1; where several sites are at distance zero (which their
  /// normals keep apart from each other, not from p), equal shares.
  [[nodiscard]] bool evaluate(const Site<double>& p, BasisValues& out) const;

  /// sum_i c_i phi_i(p); nothing where evaluate() is false. ContractViolation unless there are n
  /// coefficients.
  [[nodiscard]] std::optional<double> at(const Site<double>& p, std::span<const double> coefficients) const;
  /// The same at many sites, on all threads; the bits do not depend on their number.
  [[nodiscard]] std::vector<std::optional<double>> at(std::span<const Site<double>> points,
                                                      std::span<const double> coefficients) const;

private:
  struct Parts;
  explicit RadialBasis(std::shared_ptr<const Parts> parts);
  std::shared_ptr<const Parts> parts_;
};

/// The nominal radii of sites.
/// Maths     alpha_i: the m-th smallest ||p_i, p_j|| over j != i; the Euclidean distance unless it is
///           normal_sensitive
/// Source    [psg10, section V and after (18)]
/// Result    rounded distances of the right neighbours: the search goes on until the Euclidean distance, a
///           lower bound, exceeds the m-th. Refused, by name: m = 0, fewer than m + 1 sites, a site with
///           fewer than m others at a finite distance, unless the farthest of them will do and there is one;
///           a radius of zero
/// Limits    where normals differ much the search sees many sites
[[nodiscard]] Outcome<std::vector<double>> neighbour_radii(
    const SiteSet& sites, SiteDistance distance, std::size_t m,
    TooFewNeighbours too_few = TooFewNeighbours::refuse);

}  // namespace radcert
