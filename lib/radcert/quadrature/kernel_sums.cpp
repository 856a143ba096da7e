// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/quadrature/kernel_sums.h"

#include <algorithm>
#include <cmath>

#include "radcert/kernel/geometric_kernel.h"

namespace radcert {
namespace {

template <Real R>
using Lanes = std::array<R, Samples<R>::lanes>;

/// Adds the lanes in a fixed tree.
template <Real R>
R folded(const Lanes<R>& a) {
  return ((a[0] + a[4]) + (a[2] + a[6])) + ((a[1] + a[5]) + (a[3] + a[7]));
}

template <Real R>
R magnitude(const R& x) {
  using std::abs;
  return abs(x);
}

/// Running sums over blocks of lanes.
template <Real R>
struct Accumulator {
  std::array<Lanes<R>, KernelSums<R>::most_functions> value;
  std::array<Lanes<R>, KernelSums<R>::most_functions> size;
  std::array<Lanes<R>, KernelSums<R>::most_functions> tilt;
  Lanes<R> total{};
  Lanes<R> total_size{};

  explicit Accumulator(std::size_t functions) {
    for (std::size_t j = 0; j < functions; ++j) value[j] = size[j] = tilt[j] = Lanes<R>{};
  }

  void add(const Lanes<R>& g, const Lanes<R>& lean, const R* basis, std::size_t functions) {
    constexpr std::size_t lanes = Samples<R>::lanes;
    for (std::size_t i = 0; i < lanes; ++i) {
      total[i] += g[i];
      total_size[i] += magnitude(g[i]);
    }
    for (std::size_t j = 0; j < functions; ++j) {
      const R* l = basis + j * lanes;
      for (std::size_t i = 0; i < lanes; ++i) {
        const R term = g[i] * l[i];
        value[j][i] += term;
        size[j][i] += magnitude(term);
        tilt[j][i] += lean[i] * magnitude(l[i]);
      }
    }
  }

  KernelSums<R> sums(const Samples<R>& samples) const {
    KernelSums<R> result(samples.functions);
    result.points = samples.count;
    result.total = folded<R>(total);
    result.total_size = folded<R>(total_size);
    for (std::size_t j = 0; j < samples.functions; ++j) {
      result.value[j] = folded<R>(value[j]);
      result.size[j] = folded<R>(size[j]);
      result.tilt[j] = folded<R>(tilt[j]);
    }
    return result;
  }
};

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
KernelSums<R> kernel_sums(const Observer<R>& p, const Samples<R>& samples, const R& extent) {
  constexpr std::size_t lanes = Samples<R>::lanes;
  Accumulator<R> accumulator(samples.functions);
  for (std::size_t block = 0; block < samples.blocks(); ++block) {
    const std::size_t at = block * lanes;
    Lanes<R> g;
    Lanes<R> lean;
    for (std::size_t i = 0; i < lanes; ++i) {
      const R dx = samples.x[at + i] - p.point.x;
      const R dy = samples.y[at + i] - p.point.y;
      const R dz = samples.z[at + i] - p.point.z;
      const R seen_from_p = dx * p.normal.x + dy * p.normal.y + dz * p.normal.z;
      const R seen_from_q =
          -(dx * samples.normal_x[at + i] + dy * samples.normal_y[at + i] + dz * samples.normal_z[at + i]);
      const R weight = magnitude(samples.normal_x[at + i]) + magnitude(samples.normal_y[at + i]) +
                       magnitude(samples.normal_z[at + i]);
      const R squared = dx * dx + dy * dy + dz * dz;
      const R inverse = R(1) / (squared * squared);
      g[i] = seen_from_p * seen_from_q * inverse;
      lean[i] = extent * ((magnitude(seen_from_p) * weight + magnitude(seen_from_q)) * inverse);
    }
    accumulator.add(g, lean, samples.basis.data() + block * samples.functions * lanes, samples.functions);
  }
  return accumulator.sums(samples);
}

template <Real R>
KernelSums<R> chord_sums(const Observer<R>& p, const Chart& chart, const Samples<R>& samples) {
  constexpr std::size_t lanes = Samples<R>::lanes;
  const ChartIn<R>& formula = chart.in<R>();
  const bool singular = chart.facts().singular != SingularLine::none;
  const ParameterPoint<R> to_origin = samples.origin - p.at.at;
  Accumulator<R> accumulator(samples.functions);
  for (std::size_t block = 0; block < samples.blocks(); ++block) {
    const std::size_t at = block * lanes;
    Lanes<R> g;
    Lanes<R> lean;
    for (std::size_t i = 0; i < lanes; ++i) {
      // Not by the rounded parameters of Q: beside P their difference would have lost digits.
      ParameterPoint<R> w = to_origin + ParameterPoint<R>{samples.s[at + i], samples.t[at + i]};
      if (singular) w.s = std::max(w.s, -p.at.at.s);  // rounding must not cross the line s = 0
      const Vector<R> normal{samples.normal_x[at + i], samples.normal_y[at + i], samples.normal_z[at + i]};
      const Chord<R> chord = formula.chord(p.at.at, w);
      g[i] = chord_kernel(chord, p.normal, normal);
      lean[i] = chord_lean(chord, p.normal, normal);
    }
    accumulator.add(g, lean, samples.basis.data() + block * samples.functions * lanes, samples.functions);
  }
  return accumulator.sums(samples);
}

template struct KernelSums<double>;
template KernelSums<double> kernel_sums<double>(const Observer<double>&, const Samples<double>&,
                                                const double&);
template KernelSums<double> chord_sums<double>(const Observer<double>&, const Chart&, const Samples<double>&);

}  // namespace radcert
