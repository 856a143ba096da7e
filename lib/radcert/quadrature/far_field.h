// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "radcert/quadrature/collocation_point_block.h"
#include "radcert/quadrature/kernel_sums.h"
#include "radcert/quadrature/samples.h"

namespace radcert {

/// The sums of a rule over one far element for a block of collocation points, one a lane.
/// Maths     value_j = sum_q g_q l_j(x_q),  size = sum_q |g_q|,  g_q = G(P,Q_q) times area element and weight
/// Source    [ac98, (40)]
/// Result    rounded lane by lane
template <Real R>
struct FarSums {
  using B = typename Block<R>::Type;
  std::array<B, KernelSums<R>::most_functions> value;
  B size;
};

/// The sums of one rule for a block of collocation points.
/// Maths     see FarSums; first all g_q, then their products with the basis: two short loops that stay in
///           registers
/// Requires  no collocation point among the samples
/// Result    each lane the same bits as if it were alone; `g` is scratch
/// Limits    about 28 operations and one division an evaluation of G at degree 1
template <Real R>
void far_sums(const CollocationPointBlock<R>& observers, const Samples<R>& samples,
              std::vector<typename Block<R>::Type>& g, FarSums<R>& sums);

/// Bounds of G over a whole element, seen from afar.
/// Maths     area = Int dS, normal = Int n_Q dS / area, spread_i = max |n_Q - normal|_i by components,
///           rise = max |(Q-c).n_Q|, height = max |(Q-c).normal|, c the centre;  share[j] = Int |l_j| dS
/// Result    from the points of one rule: the maxima are those of its points
template <Real R>
struct FarView {
  R area{};
  Vector<R> normal;
  Vector<R> spread;
  R rise{};
  R height{};
  std::array<R, KernelSums<R>::most_functions> share{};

  FarView() = default;
  FarView(const Samples<R>& samples, const Vector<R>& centre);
};

/// Bounds for one far element and a block of collocation points.
/// Maths     with R = |P-c|, r the radius of the element's ball, n_P = a normal + t, t orthogonal to normal:
///           |(Q-P).n_P| <= |(c-P).n_P| + |a| height + r |t|,  |(P-Q).n_Q| <= |(P-c).normal| + sum_i |P-c|_i
///           spread_i + rise, |P-Q| >= R - r; from these largest >= |G| and lean >= X ((|(Q-P).n_P| + 8 u X)
///           |n_Q| + |(P-Q).n_Q|) / |P-Q|^4, |n_Q| by components at most sqrt 3; solid_angle = area
///           |(P-c).normal| / R^3
/// Source    see KernelSums
/// Requires  R > r
/// Result    rounded
template <Real R>
struct FarBounds {
  using B = typename Block<R>::Type;
  B largest;
  B lean;
  B solid_angle;

  FarBounds(const CollocationPointBlock<R>& observers, const FarView<R>& view, const Vector<R>& centre,
            const R& radius, const R& extent);
};

extern template void far_sums<double>(const CollocationPointBlock<double>&, const Samples<double>&,
                                      std::vector<Pack>&, FarSums<double>&);
extern template struct FarView<double>;
extern template struct FarBounds<double>;

extern template void far_sums<Mpfr<50>>(const CollocationPointBlock<Mpfr<50>>&, const Samples<Mpfr<50>>&,
                                        std::vector<Mpfr<50>>&, FarSums<Mpfr<50>>&);
extern template struct FarView<Mpfr<50>>;
extern template struct FarBounds<Mpfr<50>>;

}  // namespace radcert
