// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/transport/cell_transport.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "radcert/continuous/elements/element_interpolation.h"
#include "radcert/continuous/elements/gauss_tables.h"
#include "radcert/continuous/elements/lagrange_table.h"
#include "radcert/continuous/occlusion/penumbra.h"
#include "radcert/continuous/transport/far_bound.h"
#include "radcert/continuous/transport/source_rule.h"
#include "radcert/core/contract.h"

namespace radcert {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double unit = unit_roundoff<double>();
/// What interpolation may be off by, relative to all that a cell may be off by.
constexpr double part_of_interpolation = 0.25;

/// A source that is not far is cut where it is this many times as large as the observers' box.
constexpr double large_source = 2;

SectorBox box_about(const SectorBox& a, const SectorBox& b) {
  return {.s0 = std::min(a.s0, b.s0),
          .s1 = std::max(a.s1, b.s1),
          .t0 = std::min(a.t0, b.t0),
          .t1 = std::max(a.t1, b.t1)};
}

bool overlap(const SectorBox& a, const SectorBox& b) {
  return a.s0 < b.s1 && b.s0 < a.s1 && a.t0 < b.t1 && b.t0 < a.t1;
}

/// The cells of an element, and what is summed for each.
class CellSums {
public:
  CellSums(const Transport& transport, std::size_t element, std::span<const CellNodes> cells)
      : transport_(transport),
        scene_(transport.scene()),
        element_(transport.elements()[element]),
        sector_(scene_.sectors()[element_.sector]),
        cells_(cells) {
    for (const CellNodes& cell : cells)
      sums_.push_back({.values = std::vector<double>(size_of(cell) * transport.count())});
  }

  /// Adds what the sources send to some of the cells, in the order in which an element is cut.
  void add(std::span<const std::size_t> family, std::vector<PartOfElement> sources) {
    SectorBox box = cells_[family[0]].box;
    std::size_t nodes = 0;
    double tolerance = infinity;
    for (const std::size_t c : family) {
      box = box_about(box, cells_[c].box);
      nodes += size_of(cells_[c]);
      tolerance = std::min(tolerance, cells_[c].tolerance);
    }
    take_far(family, box, nodes, tolerance, sources);
    if (sources.empty()) return;
    if (family.size() == 1) {
      const CellNodes& cell = cells_[family[0]];
      const Transport::Values found = transport_.from(
          sources, observers(cell.box, cell.nodes_s, cell.nodes_t), (1 - part_of_interpolation) * tolerance);
      add_to(sums_[family[0]], found.values, found.radius);
      return;
    }
    const std::size_t first = size_of_first_half(family);
    add(family.first(first), sources);
    add(family.subspan(first), std::move(sources));
  }

  [[nodiscard]] std::vector<Transport::Values> take() && {
    // A cell is in no more families than there are cells, and each adds once.
    const double additions = 2 * static_cast<double>(cells_.size() + 1) * unit;
    for (Transport::Values& sum : sums_)
      sum.radius = (sum.radius + additions * (transport_.size() + sum.radius)) * upward;
    return std::move(sums_);
  }

private:
  /// A source as a box of observers sees it.
  struct Far {
    FarBound in_s;
    FarBound in_t;
    int needed_s;
    int needed_t;
    double size;  ///< the radius of the source
    [[nodiscard]] bool is_far() const { return needed_s <= most_gauss_nodes && needed_t <= most_gauss_nodes; }
  };

  static std::size_t size_of(const CellNodes& cell) {
    return static_cast<std::size_t>(cell.nodes_s) * static_cast<std::size_t>(cell.nodes_t);
  }

  [[nodiscard]] ObserverGroup observers(const SectorBox& box, int nodes_s, int nodes_t) const {
    return {.panel = sector_.panel, .points = ElementInterpolation(nodes_s, nodes_t).points(sector_, box)};
  }

  [[nodiscard]] Far far(const PartOfElement& source, const SectorBox& box, double tolerance) const {
    const Sector& sector = scene_.sectors()[transport_.elements()[source.element].sector];
    const std::array<Vector<double>, 4> corners = corners_of(sector, source.box);
    const ObserverBall ball = ball_about(corners, scene_.extent());
    const SeenPart seen = seen_part(scene_, element_, box, ball);
    const Vector<double>& n = scene_.normal(sector_.panel);
    double height = 0;
    for (const Vector<double>& corner : corners) height = std::max(height, dot(n, corner - sector_.a));
    height += 64 * unit * scene_.extent();
    const double area = sector.jacobian * source.box.weight() * upward;
    const double mass = std::numbers::inv_pi * area * transport_.size(source.element) * upward;
    const double near = std::min(seen.to_s, seen.to_t);
    // As Transport counts what an element contributes, about.
    const double share = near > 0 ? std::min(1.0, area * std::min(1.0, height / near) / (near * near)) : 1;
    const double allowed = 0.5 * part_of_interpolation * tolerance * transport_.size() *
                           std::max(0.25 * share, 0.1 / static_cast<double>(transport_.elements().size()));
    Far out{.in_s = {seen.to_s, seen.half_s, height, mass},
            .in_t = {seen.to_t, seen.half_t, height, mass},
            .needed_s = 0,
            .needed_t = 0,
            .size = ball.radius};
    out.needed_s = out.in_s.needed(allowed);
    out.needed_t = out.in_t.needed(allowed);
    return out;
  }

  /// Adds what is far from a box about a family, and leaves the rest of the sources.
  void take_far(std::span<const std::size_t> family, const SectorBox& box, std::size_t nodes,
                double tolerance, std::vector<PartOfElement>& sources) {
    const double size = ball_about(corners_of(sector_, box), scene_.extent()).radius;
    constexpr std::size_t most = most_gauss_nodes;
    std::array<std::array<std::size_t, most + 1>, most + 1> within{};
    std::vector<Far> seen;
    std::vector<PartOfElement> parts;
    // What is still to be looked at, the next part last.
    std::vector<PartOfElement> ahead(sources.rbegin(), sources.rend());
    while (!ahead.empty()) {
      const PartOfElement part = ahead.back();
      ahead.pop_back();
      const Far found = far(part, box, tolerance);
      if (!found.is_far() && found.size > large_source * size) {
        const auto [lower, upper] =
            halves(scene_.sectors()[transport_.elements()[part.element].sector], part.box);
        ahead.push_back({part.element, upper});
        ahead.push_back({part.element, lower});
        continue;
      }
      if (found.is_far())
        ++within[static_cast<std::size_t>(found.needed_s)][static_cast<std::size_t>(found.needed_t)];
      seen.push_back(found);
      parts.push_back(part);
    }
    sources = std::move(parts);
    // The rule that saves most points times sources.
    int nodes_s = 0;
    int nodes_t = 0;
    double best = 0;
    for (std::size_t s = 1; s <= most; ++s)
      for (std::size_t t = 1; t <= most; ++t) {
        within[s][t] += within[s - 1][t] + within[s][t - 1] - within[s - 1][t - 1];
        const double saved = (static_cast<double>(nodes) - 1.2 * static_cast<double>(s * t)) *
                             static_cast<double>(within[s][t]);
        if (saved <= best) continue;
        best = saved;
        nodes_s = static_cast<int>(s);
        nodes_t = static_cast<int>(t);
      }
    if (nodes_s == 0) return;

    FarError error;
    std::vector<PartOfElement> taken;
    std::vector<PartOfElement> left;
    for (std::size_t k = 0; k < sources.size(); ++k) {
      if (seen[k].needed_s > nodes_s || seen[k].needed_t > nodes_t) {
        left.push_back(sources[k]);
        continue;
      }
      taken.push_back(sources[k]);
      error.add(seen[k].in_s, seen[k].in_t, nodes_s, nodes_t);
    }
    const double gain = lagrange_moduli_at_the_ends(nodes_s) * lagrange_moduli_at_the_ends(nodes_t);
    const Transport::Values at_nodes = transport_.from(taken, observers(box, nodes_s, nodes_t),
                                                       0.5 * part_of_interpolation * tolerance / gain);
    for (const std::size_t c : family) interpolate(at_nodes, box, nodes_s, nodes_t, error, c);
    sources = std::move(left);
  }

  void interpolate(const Transport::Values& at_nodes, const SectorBox& box, int nodes_s, int nodes_t,
                   const FarError& error, std::size_t c) {
    const CellNodes& cell = cells_[c];
    const LagrangeTable in_s(nodes_s, part_in_s(cell.box, box), cell.nodes_s);
    const LagrangeTable in_t(nodes_t, part_in_t(cell.box, box), cell.nodes_t);
    const std::size_t count = transport_.count();
    const auto from_s = static_cast<std::size_t>(nodes_s);
    const auto from_t = static_cast<std::size_t>(nodes_t);
    const auto to_s = static_cast<std::size_t>(cell.nodes_s);
    const auto to_t = static_cast<std::size_t>(cell.nodes_t);
    // By node of the box in s, node of the cell in t, function.
    std::vector<double> half(from_s * to_t * count);
    for (std::size_t a = 0; a < from_s; ++a)
      for (std::size_t j = 0; j < to_t; ++j)
        for (std::size_t b = 0; b < from_t; ++b)
          add_times(in_t(j, b), &at_nodes.values[(a * from_t + b) * count], &half[(a * to_t + j) * count],
                    count);
    std::vector<double> values(to_s * to_t * count);
    for (std::size_t i = 0; i < to_s; ++i)
      for (std::size_t j = 0; j < to_t; ++j)
        for (std::size_t a = 0; a < from_s; ++a)
          add_times(in_s(i, a), &half[(a * to_t + j) * count], &values[(i * to_t + j) * count], count);
    add_to(sums_[c], values, error.of_interpolant(in_s, in_t, at_nodes.radius, transport_.size()));
  }

  static void add_to(Transport::Values& sum, std::span<const double> values, double radius) {
    for (std::size_t i = 0; i < values.size(); ++i) sum.values[i] += values[i];
    sum.radius += radius * upward;
  }
  static void add_times(double factor, const double* from, double* to, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) to[k] += factor * from[k];
  }

  /// Where the first cut of a family leaves two boxes apart, as near the middle as can be.
  [[nodiscard]] std::size_t size_of_first_half(std::span<const std::size_t> family) const {
    const std::size_t size = family.size();
    std::vector<SectorBox> after(size);
    for (std::size_t k = size; k-- > 0;) {
      after[k] = cells_[family[k]].box;
      if (k + 1 < size) after[k] = box_about(after[k], after[k + 1]);
    }
    std::size_t best = size / 2;
    std::size_t away = size;
    SectorBox before = cells_[family[0]].box;
    for (std::size_t k = 1; k < size; ++k) {
      const std::size_t from_middle = 2 * k > size ? 2 * k - size : size - 2 * k;
      if (from_middle < away && !overlap(before, after[k])) {
        best = k;
        away = from_middle;
      }
      before = box_about(before, cells_[family[k]].box);
    }
    return best;
  }

  const Transport& transport_;
  const SectorScene& scene_;
  const SectorElement& element_;
  const Sector& sector_;
  std::span<const CellNodes> cells_;
  std::vector<Transport::Values> sums_;
};

}  // namespace

std::vector<Transport::Values> transport_to_cells(const Transport& transport, std::size_t element,
                                                  std::span<const CellNodes> cells,
                                                  std::optional<std::size_t> without) {
  expects(transport.scene().sight().is_open(), "no panel hides another",
          named("panels", transport.scene().panels().size()));
  CellSums sums(transport, element, cells);
  std::vector<std::size_t> family(cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) family[c] = c;
  const std::size_t panel = transport.scene().sectors()[transport.elements()[element].sector].panel;
  if (!cells.empty()) sums.add(family, transport.sources(panel, without));
  return std::move(sums).take();
}

}  // namespace radcert
