// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/transport/transport_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "radcert/continuous/elements/sector.h"

namespace radcert {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

double tube_bound(const ObserverLines& lines, double axis) {
  const double a = lines.half * axis;
  // Nearer to the panel the difference below would have no relative accuracy, and the bound no use.
  if (!(a < 0.99 * lines.distance)) return infinity;
  const double gap = lines.distance - a;
  const double quotient = lines.distance / gap;
  const double by_area = std::numbers::inv_pi * lines.area * (lines.highest + axis * lines.turned) *
                         quotient / (gap * gap * gap) * upward;
  const double by_rings = (lines.rings ? 2 : 1) * (lines.highest + axis * lines.turned) *
                          (1 + a / gap + a * a / (3 * gap * gap)) / gap * upward;
  const double least = std::min(by_area, by_rings);
  if (!(lines.height > 0)) return least;
  const double by_nearest = quotient * quotient * quotient * quotient * lines.mass;
  return std::min(least, (1 + axis * lines.turned / lines.height) * by_nearest * upward);
}

double slide_part(double half, double reach, double axis) {
  const double a = half * axis;
  if (!(a < reach)) return infinity;
  const double b = half * std::sqrt(axis * axis - 1);
  const double squared = b * b / (reach * reach - a * a) * upward;
  return squared < 1 ? std::sqrt(squared) * upward : infinity;
}

double slide_bound(double part) {
  const double squared = part * part * upward;
  if (!(squared < 1)) return infinity;
  return std::sqrt(1 + squared) / ((1 - squared) * (1 - squared)) * upward;
}

double turned_kernel(double k, double logarithm) {
  const double quotient = (k + 1) * (k + 1) / (k * k + 1);
  return quotient * quotient * std::hypot(1, 0.5 * std::numbers::pi / logarithm);
}

double turn_bound(double size, double reach) {
  double least = infinity;
  for (const double k : {3.0, 5.0, 9.0, 20.0}) {
    const double logarithm = std::log(reach / (k * size));
    if (!(logarithm > 0)) continue;
    least = std::min(least, (1 + 2 * (turned_kernel(k, logarithm) - 1) / (k - 1)) * upward);
  }
  return least;
}

}  // namespace radcert
