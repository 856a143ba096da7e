// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/plot/error_points.h"

#include <cmath>

namespace radcert {

std::string axis_name(PlotAxis axis) { return axis == PlotAxis::mesh_size ? "mesh size h" : "unknowns"; }

std::string error_words(const std::string& quantity) {
  if (quantity == "uniform_error") return "max |u - u_n| over a sample of S";
  return quantity == "node_error" ? "max |u - u_n| over the nodes" : "max |K(I - P_n)u| over the nodes";
}

std::optional<PlotPoint> error_point(double x, const std::optional<Approximation>& error) {
  if (!error || !std::isnormal(error->value) || error->value < 0) return std::nullopt;
  return PlotPoint{.x = x, .y = error->value, .radius = error->has_radius() ? error->radius : 0};
}

std::vector<PlotPoint> error_points(std::span<const LevelResult> levels, const ErrorKind& kind,
                                    PlotAxis axis) {
  std::vector<PlotPoint> out;
  for (const LevelResult& level : levels) {
    const double x = axis == PlotAxis::mesh_size ? level.mesh_size : static_cast<double>(level.unknowns);
    if (const auto at = error_point(x, level.*kind.figure)) out.push_back(*at);
  }
  return out;
}

OrderFit fitted_order(std::span<const LevelResult> levels, std::span<const OrderFit> fits,
                      const ErrorKind& kind, PlotAxis axis) {
  for (const OrderFit& fit : fits)
    if (fit.quantity == kind.name) return fit;
  OrderFit fit{.quantity = kind.name, .order = {}, .halfwidth = {}, .levels = {}, .left_out = {}};
  std::vector<CostPoint> curve;
  for (const PlotPoint& at : error_points(levels, kind, axis)) curve.push_back({at.x, at.y});
  for (const LevelResult& level : levels) fit.levels.push_back(level.level);
  if (const auto law = power_law(curve)) {
    fit.order = (axis == PlotAxis::mesh_size ? 1 : -1) * law->exponent;
    fit.halfwidth = law->halfwidth;
  }
  return fit;
}

}  // namespace radcert
