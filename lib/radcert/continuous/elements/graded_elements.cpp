// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/elements/graded_elements.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

PartOfInterval part_of(double from, double to, double whole_from, double whole_to) {
  const double width = whole_to - whole_from;
  return {.middle = ((from - whole_from) - (whole_to - to)) / width, .half = (to - from) / width};
}

}  // namespace

PartOfInterval part_in_s(const SectorBox& part, const SectorBox& whole) {
  return part_of(part.s0, part.s1, whole.s0, whole.s1);
}

PartOfInterval part_in_t(const SectorBox& part, const SectorBox& whole) {
  return part_of(part.t0, part.t1, whole.t0, whole.t1);
}

std::vector<SectorElement> graded_elements(const SectorScene& scene, int layers) {
  expects(layers >= 1 && layers <= 12, "1 <= layers <= 12", named("layers", layers));
  std::vector<SectorBox> boxes;
  for (int layer = 0; layer < layers; ++layer) {
    const double t1 = std::ldexp(1.0, -2 * layer);
    const double t0 = layer + 1 < layers ? t1 / 4 : 0;
    std::vector<double> cuts{0};
    for (int k = layer; k >= 0; --k) cuts.push_back(std::ldexp(0.5, -2 * k));
    for (int k = 1; k <= layer; ++k) cuts.push_back(1 - std::ldexp(0.5, -2 * k));
    cuts.push_back(1);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
      boxes.push_back({.s0 = cuts[i], .s1 = cuts[i + 1], .t0 = t0, .t1 = t1});
  }
  std::vector<SectorElement> elements;
  for (std::size_t sector = 0; sector < scene.sectors().size(); ++sector)
    for (const SectorBox& box : boxes) elements.push_back({sector, box});
  return elements;
}

double mesh_size(const SectorScene& scene, std::span<const SectorElement> elements) {
  double largest = 0;
  for (const SectorElement& element : elements) {
    const Sector& sector = scene.sectors()[element.sector];
    const SectorBox& box = element.box;
    const std::array<Vector<double>, 4> corners{sector.point(box.s0, box.t0), sector.point(box.s1, box.t0),
                                                sector.point(box.s0, box.t1), sector.point(box.s1, box.t1)};
    for (const Vector<double>& a : corners)
      for (const Vector<double>& b : corners) largest = std::max(largest, norm(a - b));
  }
  return largest;
}

}  // namespace radcert
