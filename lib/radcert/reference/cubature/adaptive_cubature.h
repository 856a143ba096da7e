// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "radcert/reference/cubature/kernel_integrands.h"
#include "radcert/reference/cubature/region.h"
#include "radcert/reference/cubature/roughness.h"
#include "radcert/reference/cubature/square_maps.h"
#include "radcert/reference/density.h"
#include "radcert/reference/operator_integral.h"

namespace radcert::reference {

/// A sum of integrals of G J u over parts of parameter planes, by adaptive Gauss cubature of one common
/// tolerance.
/// Maths     sum over (map, integrand) of Int_[0,1]^2 f(w(y,x)) |det Dw(y,x)| dy dx; the region with the
///           largest error is halved in the direction of the larger one of its two errors, those of its
///           profiles: f integrated along x, and along y. Where the coefficients fall so fast that fewer
///           points than in two halves do, it gets these instead
/// Source    global adaptive refinement; the rules and their estimate of the error: see GaussRule
/// Requires  f finite, else ContractViolation; `integrand` one that add() has given; charts and density
///           outlive this
/// Result    estimate(): aims at 4e-14 of the integral of |f| or at the noise of the samples; the same bits
///           everywhere
/// Limits    an estimate, no proof; 4000 regions, where what is left of the error goes into the radius
class AdaptiveCubature {
public:
  using OfChart = std::function<Integrand(std::size_t chart)>;

  /// `far`: makes the integrand, with the apex (0,0), of a chart whose part was added with a known region.
  explicit AdaptiveCubature(const Density& u, OfChart far = {}) : density_(u), far_(std::move(far)) {}

  std::size_t add(const Integrand& f);
  void add(const Map& map, const Spacing& spacing, const Roughness& roughness, std::size_t integrand);
  /// A part, evenly spaced, whose figures on the unit square are known already; its integrand is made only if
  /// they must be refined.
  void add(const Map& map, std::size_t chart, Region known);
  /// Adds the bound of an integral that is left out to the radius.
  void add_unseen(double bound) { unseen_ += bound; }

  Approximation estimate();

private:
  struct Part {
    Map map;
    Spacing spacing;
    std::optional<std::size_t> integrand;
    std::size_t far_chart;  // where there is none yet
    bool analytic;
  };

  void apply(Region& region);
  template <class OfMap, class OfIntegrand>
  void apply(const OfMap& map, const Part& part, const OfIntegrand& f, Region& region) const;
  void refine();

  const Density& density_;
  OfChart far_;
  std::vector<Integrand> integrands_;
  std::vector<Part> parts_;
  std::vector<Region> regions_;
  double unseen_ = 0;
};

}  // namespace radcert::reference
