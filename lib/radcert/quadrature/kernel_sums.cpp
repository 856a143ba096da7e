// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/quadrature/kernel_sums.h"

#include <algorithm>
#include <cmath>

namespace radcert {
namespace {

template <Real R>
using BlockOf = typename Block<R>::Type;

template <Real R>
Vector<BlockOf<R>> broadcast(const Vector<R>& v) {
  return {BlockOf<R>(v.x), BlockOf<R>(v.y), BlockOf<R>(v.z)};
}

/// The basis functions at block `b` of the samples.
template <Real R>
auto basis_of_block(const Samples<R>& samples, std::size_t b) {
  const R* values = samples.basis.data() + b * samples.functions * Samples<R>::lanes;
  return [values](std::size_t j) { return Block<R>::load(values + j * Samples<R>::lanes); };
}

}  // namespace

template <Real R>
KernelSums<R>& KernelSums<R>::operator+=(const KernelSums& other) {
  for (std::size_t j = 0; j < functions; ++j) {
    value[j] += other.value[j];
    size[j] += other.size[j];
    tilt[j] += other.tilt[j];
  }
  total += other.total;
  total_size += other.total_size;
  points = std::max(points, other.points) + 1;
  return *this;
}

template <Real R>
KernelSums<R> kernel_sums(const CollocationPoint<R>& p, const Samples<R>& samples, const R& extent) {
  using B = BlockOf<R>;
  const Vector<B> point = broadcast<R>(p.point);
  const Vector<B> minus_normal_p = broadcast<R>(-p.normal);
  const B largest_coordinate = B(extent);
  const B blur = B(R(coordinate_roundings) * unit_roundoff<R>() * extent);
  KernelSumsByLane<R> sums(samples.functions);
  for (std::size_t block = 0; block < samples.blocks(); ++block) {
    const std::size_t at = block * Samples<R>::lanes;
    const auto load = [at](const std::vector<R>& array) { return Block<R>::load(&array[at]); };
    const Vector<B> normal_q{load(samples.normal_x), load(samples.normal_y), load(samples.normal_z)};
    const Vector<B> d = point - Vector<B>{load(samples.x), load(samples.y), load(samples.z)};
    const RoundedKernel<B> g = rounded_kernel<B>(d, minus_normal_p, normal_q, largest_coordinate, blur);
    sums.add(g.value, g.lean, basis_of_block(samples, block));
  }
  return sums.sums(samples.count);
}

template <Real R>
KernelSums<R> chord_sums(const CollocationPoint<R>& p, const Chart& chart, const Samples<R>& samples) {
  using B = BlockOf<R>;
  using std::max;
  const ChartIn<B>& formula = chart.in<B>();
  const bool singular = chart.facts().singular != SingularLine::none;
  const ParameterPoint<B> at_p{B(p.at.at.s), B(p.at.at.t)};
  const Vector<B> normal_p = broadcast<R>(p.normal);
  const ParameterPoint<R> to_origin = samples.origin - p.at.at;
  KernelSumsByLane<R> sums(samples.functions);
  for (std::size_t block = 0; block < samples.blocks(); ++block) {
    const std::size_t at = block * Samples<R>::lanes;
    const auto load = [at](const std::vector<R>& array) { return Block<R>::load(&array[at]); };
    // Not by the rounded parameters of Q: beside P their difference would have lost digits.
    ParameterPoint<B> w{B(to_origin.s) + load(samples.s), B(to_origin.t) + load(samples.t)};
    if (singular) w.s = max(w.s, -at_p.s);  // rounding must not cross the line s = 0
    const Vector<B> normal_q{load(samples.normal_x), load(samples.normal_y), load(samples.normal_z)};
    const RoundedKernel<B> g = rounded_kernel<B>(formula.chord(at_p, w), normal_p, normal_q);
    sums.add(g.value, g.lean, basis_of_block(samples, block));
  }
  return sums.sums(samples.count);
}

template struct KernelSums<double>;
template KernelSums<double> kernel_sums<double>(const CollocationPoint<double>&, const Samples<double>&,
                                                const double&);
template KernelSums<double> chord_sums<double>(const CollocationPoint<double>&, const Chart&,
                                               const Samples<double>&);
template struct KernelSums<Mpfr<50>>;
template KernelSums<Mpfr<50>> kernel_sums<Mpfr<50>>(const CollocationPoint<Mpfr<50>>&,
                                                    const Samples<Mpfr<50>>&, const Mpfr<50>&);
template KernelSums<Mpfr<50>> chord_sums<Mpfr<50>>(const CollocationPoint<Mpfr<50>>&, const Chart&,
                                                   const Samples<Mpfr<50>>&);

}  // namespace radcert
