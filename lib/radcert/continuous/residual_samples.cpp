// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/residual_samples.h"

#include <array>
#include <utility>

#include "radcert/continuous/elements/element_interpolation.h"
#include "radcert/continuous/elements/gauss_tables.h"
#include "radcert/continuous/elements/local_values.h"
#include "radcert/continuous/occlusion/penumbra.h"
#include "radcert/continuous/transport/cell_transport.h"

namespace radcert {
namespace {

constexpr double unit = unit_roundoff<double>();

}  // namespace

ResidualSamples::ResidualSamples(const Trial& trial, ShadedParts shaded)
    : trial_(trial),
      shaded_(shaded),
      with_one_(with_one(trial.w, trial.elements.size())),
      transport_(trial.scene, trial.elements, trial.w),
      transport_with_one_(trial.scene, trial.elements, with_one_),
      count_(trial.w.count()) {}

/// What is sent to the nodes of cells: by w alone, or by w and 1 where a part of T 1 = 1 is wanted.
std::vector<Transport::Values> ResidualSamples::sent(std::span<const ObserverCell> cells,
                                                     const CellTolerances& tolerances) const {
  std::vector<Transport::Values> out(cells.size());
  if (!trial_.scene.sight().is_open()) {
    for (std::size_t c = 0; c < cells.size(); ++c)
      if (tolerances[c]) out[c] = sent_past_panels(cells[c], *tolerances[c]);
    return out;
  }
  for (std::size_t begin = 0; begin < cells.size();) {
    const std::size_t element = cells[begin].element;
    std::size_t end = begin;
    while (end < cells.size() && cells[end].element == element) ++end;
    for (const bool closed : {false, true}) {
      std::vector<std::size_t> places;
      std::vector<CellNodes> wanted;
      for (std::size_t c = begin; c < end; ++c)
        if (cells[c].closed == closed && tolerances[c]) {
          places.push_back(c);
          wanted.push_back({cells[c].box, cells[c].nodes_s, cells[c].nodes_t,
                            closed ? 0.5 * *tolerances[c] : *tolerances[c]});
        }
      if (places.empty()) continue;
      std::vector<Transport::Values> found =
          closed ? transport_to_cells(transport_with_one_, element, wanted, panel_beyond(element))
                 : transport_to_cells(transport_, element, wanted);
      for (std::size_t k = 0; k < places.size(); ++k) out[places[k]] = std::move(found[k]);
    }
    begin = end;
  }
  return out;
}

Transport::Values ResidualSamples::sent_past_panels(const ObserverCell& cell, double tolerance) const {
  const Sector& sector = trial_.sector(cell.element);
  const std::array<Vector<double>, 4> corners = corners_of(sector, cell.box);
  const ObserverGroup group{
      .panel = sector.panel,
      .points = ElementInterpolation(cell.nodes_s, cell.nodes_t).points(sector, cell.box),
      .hull = {corners.begin(), corners.end()},
      .least_mass = shaded_ == ShadedParts::ignored ? negligible_mass : cell.least_mass,
      .by_points = shaded_ == ShadedParts::ignored};
  if (cell.closed) return transport_with_one_(group, 0.5 * tolerance, panel_beyond(cell.element));
  return shaded_ == ShadedParts::ignored ? transport_(group, tolerance)
                                         : transport_with_one_(group, 0.5 * tolerance);
}

/// The panel on the other side of an element's edge.
std::size_t ResidualSamples::panel_beyond(std::size_t element) const {
  return trial_.sector(*trial_.closure.mirror(element)).panel;
}

std::vector<CellSamples> ResidualSamples::operator()(std::span<const ObserverCell> cells,
                                                     const CellTolerances& tolerances) const {
  // Of q and, at an edge, of xi, which has the degree of w.
  const auto powers = static_cast<double>(trial_.w.degree() + 1);
  const double rounding = 40 * powers * powers * unit * trial_.smoothness.largest_residual();
  const bool as_they_are = shaded_ == ShadedParts::ignored || trial_.scene.sight().is_open();
  std::vector<Transport::Values> values = sent(cells, tolerances);
  std::vector<CellSamples> out;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (values[c].values.empty()) {
      out.emplace_back();
      continue;
    }
    ShadedValues found = cells[c].closed ? closed(cells[c], values[c])
                         : as_they_are   ? ShadedValues{std::move(values[c])}
                                         : half_shaded(trial_.penumbra, values[c], trial_.smoothness.size());
    out.push_back({.values = std::move(found.values.values),
                   .radius = (found.values.radius + rounding + trial_.rounding) * upward,
                   .shade = std::move(found.shade),
                   .nodes = static_cast<std::size_t>(cells[c].nodes_s * cells[c].nodes_t)});
  }
  return out;
}

/// F of Smoothness' closure: what the other panels send, and xi times the rest of T 1 = 1.
ShadedValues ResidualSamples::closed(const ObserverCell& cell, const Transport::Values& found) const {
  const IntervalRule<double>& rule_s = gauss_on_interval(cell.nodes_s);
  const IntervalRule<double>& rule_t = gauss_on_interval(cell.nodes_t);
  const std::size_t mirror = *trial_.closure.mirror(cell.element);
  LocalValues at_edge(trial_.elements[mirror], trial_.w, mirror);
  const SectorBox across{
      .s0 = 1 - cell.box.s1, .s1 = 1 - cell.box.s0, .t0 = 0, .t1 = trial_.elements[mirror].box.t1};
  const std::size_t points = rule_s.nodes.size() * rule_t.nodes.size();
  ShadedValues out{
      .values = {.values = std::vector<double>(points * count_),
                 .radius = found.radius * (1 + trial_.smoothness.density_size(mirror)) * upward}};
  if (!found.shaded.empty()) out.shade = trial_.penumbra.rest_at_edge(found.shaded, mirror, across).bounds;
  std::vector<double> xi(count_);
  for (std::size_t i = 0; i < rule_s.nodes.size(); ++i) {
    at_edge.at(across, -rule_s.nodes[i], -1, xi);
    for (std::size_t j = 0; j < rule_t.nodes.size(); ++j) {
      const std::size_t place = i * rule_t.nodes.size() + j;
      const double* const sent = &found.values[place * (count_ + 1)];
      for (std::size_t k = 0; k < count_; ++k)
        out.values.values[place * count_ + k] = sent[k] + xi[k] * (1 - sent[count_]);
    }
  }
  return out;
}

}  // namespace radcert
