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

CutAtVertex cut_at_vertex(const SectorBox& box) {
  CutAtVertex cut{.beside = box, .above = box, .at_vertex = box};
  const double quarter = 0.25 * (box.s1 - box.s0);
  if (box.s0 == 0)
    cut.beside.s0 = cut.above.s1 = cut.at_vertex.s1 = box.s0 + quarter;
  else
    cut.beside.s1 = cut.above.s0 = cut.at_vertex.s0 = box.s1 - quarter;
  cut.above.t0 = cut.at_vertex.t1 = 0.25 * box.t1;
  return cut;
}

std::vector<SectorElement> graded_elements(const SectorScene& scene, int layers, int cuts_at_vertices) {
  expects(layers >= 1 && cuts_at_vertices >= 0 && layers + cuts_at_vertices <= 12,
          "1 <= layers, 0 <= cuts_at_vertices, at most 12 in all", named("layers", layers),
          named("cuts_at_vertices", cuts_at_vertices));
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
  const auto at_vertex = [](const SectorBox& box) { return box.t0 == 0 && (box.s0 == 0 || box.s1 == 1); };
  for (std::size_t k = 0; k < boxes.size(); ++k)
    for (int cut = 0; at_vertex(boxes[k]) && cut < cuts_at_vertices; ++cut) {
      const CutAtVertex parts = cut_at_vertex(boxes[k]);
      boxes[k] = parts.at_vertex;
      boxes.push_back(parts.beside);
      boxes.push_back(parts.above);
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
