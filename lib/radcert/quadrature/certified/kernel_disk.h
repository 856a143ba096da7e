// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "radcert/geometry/vector.h"
#include "radcert/scalar/functions/taylor_model.h"

namespace radcert {

/// At least |(x, y, z)|.
[[nodiscard]] double upper_norm(double x, double y, double z);

/// A part of a chart over the disk of one complex variable, and over smaller disks, split as DiskBound takes
/// it.
/// Maths     Q = sum c_ij z^i v^j + remainder, z complex with |z| < 1, v real with |v| < 1. About a real c
///           Q - c = r + e, r = sum of Re c_ij z^i v^j with i <= 1 and i + j > 0, e the others: Re c_00 - c,
///           all imaginary parts, powers of z from the second on, the remainder. On |z| <= s < 1 terms of z^i
///           are s^i times as large
/// Requires  three models that have not failed
/// Result    bounds of |r| and of |e|, rounded up
class KernelDisk {
public:
  KernelDisk(const Vector<TaylorModel>& q, const Vector<double>& centre);

  /// On |z| <= s.
  [[nodiscard]] double linear(double s) const;
  [[nodiscard]] double rest(double s) const;

private:
  static constexpr auto powers = static_cast<std::size_t>(TaylorModel::highest_degree + 1);
  std::array<double, powers> linear_{};  ///< lengths of the real vectors, by the power of z
  std::array<std::array<double, 3>, powers> rest_{};
  std::array<double, 3> remainder_{};
};

}  // namespace radcert
