// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/occlusion/shade.h"

#include <algorithm>
#include <cmath>

namespace radcert::certificate {
namespace {

constexpr double unit = 0x1p-53;

}  // namespace

Shades::Shades(const PolyhedronCertificate& certificate, const Densities& densities)
    : certificate_(certificate), densities_(densities) {
  // |P_i'| <= i (i+1)/2
  const std::size_t powers = densities.powers();
  for (std::size_t e = 0; e < certificate.elements.size(); ++e)
    for (std::size_t k = 0; k < densities.count(); ++k) {
      double in_x = 0;
      double in_y = 0;
      for (std::size_t i = 0; i < powers; ++i)
        for (std::size_t j = 0; j < powers; ++j) {
          const double c = std::abs(densities.w(e)[(i * powers + j) * densities.stride() + k]);
          in_x += c * static_cast<double>(i * (i + 1)) / 2;
          in_y += c * static_cast<double>(j * (j + 1)) / 2;
        }
      slope_x_.push_back(in_x * upward);
      slope_y_.push_back(in_y * upward);
    }
}

Shades::Values Shades::values(std::size_t element, double s0, double s1, double t0, double t1) const {
  const Element& whole = certificate_.elements[element];
  const auto middle = [](double from, double to, double whole_from, double whole_to) {
    const auto exactly = [](double x) { return BoundedDouble::exactly(x); };
    return (exactly(from) - exactly(whole_from) + (exactly(to) - exactly(whole_to))) /
           (exactly(whole_to) - exactly(whole_from));
  };
  const LegendreTable p_s(densities_.degree(),
                          std::vector<BoundedDouble>{middle(s0, s1, whole.s0, whole.s1)});
  const LegendreTable p_t(densities_.degree(),
                          std::vector<BoundedDouble>{middle(t0, t1, whole.t0, whole.t1)});
  const double off = densities_.error(element, p_s, p_t);
  Values out{.middle = std::vector<double>(densities_.stride()), .spread = {}};
  Densities::values(densities_.w(element), densities_.stride(), p_s.values.data(), p_t.values.data(),
                    densities_.powers(), out.middle);
  const double half_x = (s1 - s0) / (whole.s1 - whole.s0) * upward;
  const double half_y = (t1 - t0) / (whole.t1 - whole.t0) * upward;
  for (std::size_t k = 0; k < densities_.count(); ++k) {
    const std::size_t own = element * densities_.count() + k;
    // The coefficients' error counts in the middle, and elsewhere.
    out.spread.push_back((slope_x_[own] * half_x + slope_y_[own] * half_y + 2 * off) * upward);
  }
  return out;
}

Shade Shades::made(std::span<const ShadedPart> shaded, std::span<const Values> values,
                   std::vector<double> constants, std::span<const double> spread) const {
  Shade out{.constants = std::move(constants), .shifts = {}, .radii = {}};
  for (std::size_t k = 0; k < densities_.count(); ++k) {
    const double c = out.constants[k];
    double above = 0;
    double below = 0;
    double most_above = 0;
    double most_below = 0;
    for (std::size_t p = 0; p < shaded.size(); ++p) {
      const double off = values[p].spread[k] + spread[k];
      const double rise = std::max(0.0, values[p].middle[k] - c + off);
      const double fall = std::max(0.0, c - values[p].middle[k] + off);
      above += shaded[p].mass * rise;
      below += shaded[p].mass * fall;
      most_above = std::max(most_above, rise);
      most_below = std::max(most_below, fall);
    }
    above = std::min(above, most_above);
    below = std::min(below, most_below);
    // Roundings: of sums of so many terms, of c and of the values by a few units of their size.
    const double of_sums = 1 + (2 * static_cast<double>(shaded.size()) + 16) * unit;
    const double of_values = shaded.empty() ? 0 : 8 * unit * (densities_.largest() + std::abs(c));
    out.shifts.push_back(0.5 * (above - below));
    out.radii.push_back((0.5 * (above + below) * of_sums + of_values) * upward);
    out.largest_constant = std::max(out.largest_constant, std::abs(c));
    out.largest_radius = std::max(out.largest_radius, out.radii.back());
  }
  return out;
}

Shade Shades::of(std::span<const ShadedPart> shaded) const {
  std::vector<Values> found;
  std::vector<double> constants(densities_.count());
  double all = 0;
  for (const ShadedPart& own : shaded) {
    const Box& box = own.part.box;
    found.push_back(values(own.part.element, box.s0, box.s1, box.t0, box.t1));
    all += own.mass;
    for (std::size_t k = 0; k < constants.size(); ++k) constants[k] += own.mass * found.back().middle[k];
  }
  if (all > 0)
    for (double& c : constants) c /= all;
  return made(shaded, found, std::move(constants), std::vector<double>(densities_.count()));
}

Shade Shades::at_edge(std::span<const ShadedPart> shaded, std::size_t element, double s0, double s1) const {
  const std::size_t face = certificate_.elements[element].face;
  std::vector<ShadedPart> elsewhere;
  std::vector<Values> found;
  for (const ShadedPart& own : shaded) {
    if (certificate_.elements[own.part.element].face == face) continue;
    const Box& box = own.part.box;
    elsewhere.push_back(own);
    found.push_back(values(own.part.element, box.s0, box.s1, box.t0, box.t1));
  }
  const Element& whole = certificate_.elements[element];
  Values edge = values(element, s0, s1, whole.t0, whole.t0);
  return made(elsewhere, found, std::move(edge.middle), edge.spread);
}

}  // namespace radcert::certificate
