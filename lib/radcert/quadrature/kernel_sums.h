// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

#include "radcert/kernel/rounded_kernel.h"
#include "radcert/polynomial/basis_limits.h"
#include "radcert/quadrature/collocation_point.h"
#include "radcert/quadrature/samples.h"

namespace radcert {

/// The sums of a rule for one collocation point over one cell.
/// Maths     value_j = sum g_q l_j(x_q),  size_j = sum |g_q| |l_j(x_q)|,  total = sum g_q,  size = sum |g_q|,
///           tilt_j: e tilt_j is what a change of all coordinates by e X does to the product of the two
///           scalar products at most, e = 8 u: sum of X (|(Q-P).n_P| + |(P-Q).n_Q| + e X) |l_j| / |P-Q|^4
///           (weighted), X the largest coordinate; for chords the products of lengths |bend| |n| stand for
///           |X|.  g_q = G(P,Q_q) times area element and weight
/// Source    [ac98, (40)]
/// Requires  at most 66 functions (degree 10)
/// Result    see `rounding`
template <Real R>
struct KernelSums {
  static constexpr std::size_t most_functions = most_basis_functions;
  std::size_t functions;  ///< the first so many places of the arrays are in use
  std::array<R, most_functions> value;
  std::array<R, most_functions> size;
  std::array<R, most_functions> tilt;
  R total{};
  R total_size{};
  std::size_t points = 0;

  explicit KernelSums(std::size_t count) : functions(count) {
    for (std::size_t j = 0; j < functions; ++j) value[j] = size[j] = tilt[j] = R(0);
  }
  KernelSums& operator+=(const KernelSums& other);
};

/// Running sums over blocks of points, lane by lane.
/// Maths     see KernelSums
/// Requires  as many basis functions as stated
/// Result    sums() folds the lanes in a fixed order
template <Real R>
class KernelSumsByLane {
public:
  using B = typename Block<R>::Type;

  explicit KernelSumsByLane(std::size_t functions) : functions_(functions) {
    for (std::size_t j = 0; j < functions; ++j) value_[j] = size_[j] = tilt_[j] = B(R(0));
  }

  /// Adds a block: g and lean of its points, and l_j at basis(j).
  template <class Basis>
  void add(const B& g, const B& lean, const Basis& basis) {
    using std::abs;
    total_ = total_ + g;
    total_size_ = total_size_ + abs(g);
    for (std::size_t j = 0; j < functions_; ++j) {
      const B& l = basis(j);  // no copy: one of 64 bytes stalls the loads that follow
      const B term = g * l;
      value_[j] = value_[j] + term;
      size_[j] = size_[j] + abs(term);
      tilt_[j] = tilt_[j] + lean * abs(l);
    }
  }

  /// Adds to the values alone.
  template <class Basis>
  void add_values(const B& g, const Basis& basis) {
    for (std::size_t j = 0; j < functions_; ++j) value_[j] = multiply_add(g, basis(j), value_[j]);
  }

  KernelSums<R> sums(std::size_t points) const {
    KernelSums<R> result(functions_);
    result.points = points;
    result.total = Block<R>::sum(total_);
    result.total_size = Block<R>::sum(total_size_);
    for (std::size_t j = 0; j < functions_; ++j) {
      result.value[j] = Block<R>::sum(value_[j]);
      result.size[j] = Block<R>::sum(size_[j]);
      result.tilt[j] = Block<R>::sum(tilt_[j]);
    }
    return result;
  }

private:
  std::size_t functions_;
  std::array<B, KernelSums<R>::most_functions> value_;
  std::array<B, KernelSums<R>::most_functions> size_;
  std::array<B, KernelSums<R>::most_functions> tilt_;
  B total_ = B(R(0));
  B total_size_ = B(R(0));
};

/// Sums of G over samples.
/// Maths     see KernelSums
/// Source    [ac98, (2), (40)]
/// Requires  P not among the samples; `extent` bounds the coordinates of P and of the samples
/// Result    the same bits on every machine; no allocation
/// Limits    loses digits near the diagonal of a smooth chart: there use chord_sums
template <Real R>
KernelSums<R> kernel_sums(const CollocationPoint<R>& p, const Samples<R>& samples, const R& extent);

/// The same where P = F(p) lies on the chart of the samples: through divided differences.
/// Maths     see KernelSums and Chord
/// Source    ours
/// Requires  p on `chart`, the chart of the samples, and not among them
/// Result    as kernel_sums, without its loss of digits near the diagonal
template <Real R>
KernelSums<R> chord_sums(const CollocationPoint<R>& p, const Chart& chart, const Samples<R>& samples);

/// A bound for what rounding did to value_j, to first order in the unit roundoff u.
/// Maths     (points + 60) u size_j + 8 u tilt_j: each term passes at most 60 roundings in chart, kernel,
///           weight and basis, a sum of k terms at most k more; coordinates are off by at most 8 u of the
///           largest. More than 45 functions have a degree above 8: 200 in place of 60, since the Bernstein
///           coefficients of Lagrange functions grow: the values of those at the nodes of degree 10 that
///           radcert has are off by up to 183 u of their means, of degree 8 by 64 u
/// Source    standard model of rounding; the counts are those of the formulas in this layer
/// Requires  no point of the cell nearer to P than least_distance
/// Result    a bound if the chart's own formula loses no more than 8 u of the largest coordinate
template <class V, class R>
V rounding_bound(std::size_t points, std::size_t functions, const V& size, const V& tilt, const R& u) {
  const std::size_t of_a_term = functions > 45 ? 200 : 60;
  return V(R(static_cast<double>(points + of_a_term)) * u) * size + V(R(coordinate_roundings) * u) * tilt;
}

/// The distance from which on P and Q are told apart by their rounded coordinates.
/// Maths     64 times what coordinates are off by, 512 u X: relatively |Q-P| then changes by sqrt(3)/64 at
///           most, and G by terms of second order that are below a tenth of those of first order
/// Requires  `extent` bounds the coordinates of P and Q
/// Result    rounded
/// Limits    nearer than that a sum over rounded points says nothing about the integral
template <class R>
R least_distance(const R& extent) {
  return R(64 * coordinate_roundings) * unit_roundoff<R>() * extent;
}

/// What rounding may have changed of the sum with function j, see rounding_bound.
template <Real R>
R rounding(const KernelSums<R>& sums, std::size_t j) {
  return rounding_bound(sums.points, sums.functions, sums.size[j], sums.tilt[j], unit_roundoff<R>());
}

extern template struct KernelSums<double>;
extern template KernelSums<double> kernel_sums<double>(const CollocationPoint<double>&,
                                                       const Samples<double>&, const double&);
extern template KernelSums<double> chord_sums<double>(const CollocationPoint<double>&, const Chart&,
                                                      const Samples<double>&);

extern template struct KernelSums<Mpfr<50>>;
extern template KernelSums<Mpfr<50>> kernel_sums<Mpfr<50>>(const CollocationPoint<Mpfr<50>>&,
                                                           const Samples<Mpfr<50>>&, const Mpfr<50>&);
extern template KernelSums<Mpfr<50>> chord_sums<Mpfr<50>>(const CollocationPoint<Mpfr<50>>&, const Chart&,
                                                          const Samples<Mpfr<50>>&);

}  // namespace radcert
