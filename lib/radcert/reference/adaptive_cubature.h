// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "radcert/reference/kernel_integrands.h"
#include "radcert/reference/kronrod_rule.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/reference/square_maps.h"

namespace radcert::reference {

/// A sum of integrals of G J u over parts of parameter planes, by adaptive Gauss-Kronrod cubature of one common tolerance.
/// Maths     sum over (map, integrand) of Int_[0,1]^2 f(w(x,y)) |det Dw(x,y)| dx dy; the region with the largest error is halved in the
///           direction of the larger one of its two errors, those of its profiles: f integrated along y, and along x
/// Source    global adaptive bisection; the rule and its estimate of the error: see KronrodRule
/// Requires  f finite, else ContractViolation; `integrand` one that add() has given; charts and density outlive this
/// Result    estimate(): see Estimate. It aims at 4e-14 of the integral of |f| or at the noise of the samples; the same bits everywhere
/// Limits    an estimate, no proof; 4000 regions, where what is left of the error goes into the radius
class AdaptiveCubature {
public:
  AdaptiveCubature();

  std::uint32_t add(const FlatIntegrand& f);
  std::uint32_t add(const CurvedIntegrand& f);
  std::uint32_t add(const ChordIntegrand& f);
  void add(const Collapse& map, std::uint32_t integrand);
  void add(const Sector& map, std::uint32_t integrand);
  void add(const Slab& map, std::uint32_t integrand);
  /// Adds the bound of an integral that is left out to the radius.
  void add_unseen(double bound);

  Estimate estimate();

private:
  struct Region {
    std::uint32_t map;
    std::uint32_t integrand;
    double x;
    double y;
    double width;
    double height;
    double value;
    double absolute;
    double noise;
    double error_x;
    double error_y;
    double priority;

    double error() const { return error_x + error_y; }
  };

  enum class MapKind : std::uint8_t { collapse, sector, slab };
  enum class IntegrandKind : std::uint8_t { flat, curved, chord };

  template <class Kind>
  struct Place {
    Kind kind;
    std::size_t index;
  };

  static const KronrodRule& rule();

  template <class Kind, class Item>
  static std::uint32_t add(std::vector<Place<Kind>>& places, std::vector<Item>& items, const Item& item,
                           Kind kind);
  void first(std::uint32_t map, std::uint32_t integrand);
  template <class Action>
  auto with_integrand(std::uint32_t integrand, const Action& action) const;
  void apply(Region& region) const;
  template <class Map, class Integrand>
  void apply(const Map& map, const Integrand& f, Region& region) const;

  const KronrodRule& rule_;
  std::vector<FlatIntegrand> flat_;
  std::vector<CurvedIntegrand> curved_;
  std::vector<ChordIntegrand> chord_;
  std::vector<Collapse> collapse_;
  std::vector<Sector> sector_;
  std::vector<Slab> slab_;
  std::vector<Place<IntegrandKind>> integrands_;
  std::vector<Place<MapKind>> maps_;
  std::vector<Region> regions_;
  double unseen_ = 0;
};

}  // namespace radcert::reference
