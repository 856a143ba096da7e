// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/quadrature/certified/kernel_disk.h"

#include <cmath>

namespace radcert {
namespace {

/// More than the roundings of any bound below: each takes fewer than 2^12 operations on positive numbers.
constexpr double up = 1 + 0x1p-40;

}  // namespace

double upper_norm(double x, double y, double z) { return std::sqrt(x * x + y * y + z * z) * up; }

KernelDisk::KernelDisk(const Vector<TaylorModel>& q, const Vector<double>& centre)
    : remainder_{q.x.remainder(), q.y.remainder(), q.z.remainder()} {
  const std::array<const TaylorModel*, 3> f{&q.x, &q.y, &q.z};
  const std::array<double, 3> c_00{centre.x, centre.y, centre.z};
  for (std::size_t i = 0; i < powers; ++i)
    for (std::size_t j = 0; i + j < powers; ++j) {
      std::array<double, 3> real{};
      for (std::size_t c = 0; c < 3; ++c) {
        const ComplexDouble a = f[c]->coefficient(static_cast<int>(i), static_cast<int>(j));
        if (i + j == 0) {
          rest_[i][c] += std::abs(a.real - c_00[c]) * up + std::abs(a.imag);
        } else if (i >= 2) {
          rest_[i][c] += std::abs(a.real) + std::abs(a.imag);
        } else {
          real[c] = a.real;
          rest_[i][c] += std::abs(a.imag);
        }
      }
      linear_[i] += upper_norm(real[0], real[1], real[2]);
    }
}

double KernelDisk::linear(double s) const { return (linear_[0] + linear_[1] * s) * up; }

double KernelDisk::rest(double s) const {
  std::array<double, 3> others = remainder_;
  double scale = 1;
  for (std::size_t i = 0; i < powers; ++i, scale *= s)
    for (std::size_t c = 0; c < 3; ++c) others[c] += rest_[i][c] * scale;
  return upper_norm(others[0], others[1], others[2]) * up;
}

}  // namespace radcert
