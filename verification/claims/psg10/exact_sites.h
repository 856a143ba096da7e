// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "radcert/meshless/mother_function.h"
#include "radcert/meshless/site.h"

namespace radcert::verification::psg10 {

/// Sites with rational points and rational unit normals.
/// Maths     normals: the stereographic image of multiples of 1/8
/// Source    the sites: [psg10, section III]
/// Result    exact; the same on every run
/// Limits    the normal -e_z is left out
class ExactSites {
public:
  explicit ExactSites(std::uint64_t seed) : bits_(seed) {}

  /// A whole number of so many.
  long below(long count) { return static_cast<long>(bits_() % static_cast<std::uint64_t>(count)); }
  /// A multiple of 1/8 between -range and range.
  Rational eighths(long range) { return {below(16 * range + 1) - 8 * range, 8}; }
  Vector<Rational> normal(long range) {
    const Rational s = eighths(range);
    const Rational t = eighths(range);
    const Rational q = s * s + t * t;
    const Rational scale = Rational(1) / (Rational(1) + q);
    return {Rational(2) * s * scale, Rational(2) * t * scale, (Rational(1) - q) * scale};
  }
  /// A normal whose cosine with e_z exceeds `least`, uniform on that cap of the sphere but for a grid.
  /// Maths     multiples of 1/64 as stereographic coordinates (s, t), taken with the probability (1 + s^2 +
  ///           t^2)^-2, to which the area that they stand for on the sphere is proportional
  /// Requires  0 <= least < 1
  Vector<Rational> normal_within(const Rational& least);
  /// A point of the plane z = 0, uniform in the disk of this radius about 0 but for the grid of eighths, and
  /// not its centre.
  Vector<Rational> point_of_disk(long radius);
  /// Sites at the places 0, 1, ..., count - 1 of the x-axis, moved by up to 3/8, with the normal e_z.
  std::vector<Site<Rational>> several_on_axis(std::size_t count);

private:
  std::mt19937_64 bits_;
};

/// max{0, p->.q->}.
[[nodiscard]] Rational normal_factor(const Site<Rational>& p, const Site<Rational>& q);

/// The raw elements (18) with the points in the place of the normals, all radii alpha, for points of the
/// x-axis.
[[nodiscard]] std::vector<Rational> raw_lehtinen(std::span<const Site<Rational>> sites, const Rational& alpha,
                                                 const Site<Rational>& p);

/// (11). Empty where the sum is zero.
template <Field R>
[[nodiscard]] std::vector<R> normalised(std::vector<R> raw) {
  R sum(0);
  for (const R& value : raw) sum = sum + value;
  if (sum == R(0)) return {};
  for (R& value : raw) value = value / sum;
  return raw;
}

/// (16) in a form that divides by no distance. Empty where every distance is infinite.
/// Maths     phi_i = prod_{j != i} d_j^2 / sum_k prod_{j != k} d_j^2 over the sites at a finite distance, 0
///           for others, d_j = |p^ - p_j^| / max{0, p->.p_j->}: (16) times the product of all d_j^2
/// Source    [psg10, (15), (16)]
/// Requires  no two sites of `sites` at p within 90 degrees of its normal
/// Result    exact
[[nodiscard]] std::vector<Rational> shepard_elements(std::span<const Site<Rational>> sites,
                                                     const Site<Rational>& p);

}  // namespace radcert::verification::psg10
