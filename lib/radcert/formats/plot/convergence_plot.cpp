// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/plot/convergence_plot.h"

#include <cmath>
#include <map>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/formats/table/order_text.h"
#include "radcert/study/errors/error_order.h"

namespace radcert {

namespace {

double abscissa(const LevelResult& level, ErrorAgainst against) {
  return against == ErrorAgainst::mesh_size ? level.mesh_size : static_cast<double>(level.unknowns);
}

/// The exponent of the axis has this sign where errors fall.
double sign_of(ErrorAgainst against) { return against == ErrorAgainst::mesh_size ? 1 : -1; }

PlotAxis axis_of(ErrorAgainst against) {
  return against == ErrorAgainst::mesh_size ? PlotAxis{.name = "mesh size h", .latex = "mesh size $h$"}
                                            : PlotAxis{.name = "unknowns", .latex = "unknowns $N$"};
}

/// Whether an error is no more than what has moved u_n: by its radius, or by that of u_n at the nodes where
/// it has none, as over a sample.
bool is_noise(const LevelResult& level, Approximation error) {
  if (!error.has_radius() && level.node_error) error.radius = level.node_error->radius;
  return error.has_radius() && !stands_above_radius(error);
}

/// The fit of an error; of one that is not among the fits, over those of its levels whose slopes are steady.
OrderFit order_of(const ErrorHistory& problem, const ErrorKind& kind, ErrorAgainst against) {
  for (const OrderFit& fit : problem.orders)
    if (fit.quantity == kind.name) return fit;
  OrderFit fit{.quantity = kind.name, .order = {}, .halfwidth = {}, .levels = {}, .left_out = {}};
  std::vector<CostPoint> curve;
  for (const LevelResult& level : problem.levels) {
    const auto at = plot_point(abscissa(level, against), level.*kind.figure);
    if (!at) continue;
    if (is_noise(level, *(level.*kind.figure))) {
      fit.left_out.push_back(level.level);
      continue;
    }
    fit.levels.push_back(level.level);
    curve.push_back({at->x, at->y});
  }
  const AsymptoticLaw found = asymptotic_law(curve);
  const auto first = fit.levels.begin() + static_cast<std::ptrdiff_t>(found.from);
  fit.pre_asymptotic.assign(fit.levels.begin(), first);
  fit.levels.erase(fit.levels.begin(), first);
  if (found.law) {
    fit.order = sign_of(against) * found.law->exponent;
    fit.halfwidth = found.law->halfwidth;
  }
  return fit;
}

std::string order_text(const OrderFit& fit) {
  const auto order = fitted_order_text(fit, " \u00b1 ");
  if (!order) return "no steady order";
  std::string out = "order " + *order;
  if (fit.levels.size() < 3 || !fit.halfwidth)
    out += " from two levels";
  else if (!fit.left_out.empty() || !fit.pre_asymptotic.empty())
    out += " from " + std::to_string(fit.levels.size()) + " levels";
  return out;
}

PlotCurve curve_of(std::string name, const ErrorHistory& problem, const ErrorKind& kind,
                   ErrorAgainst against) {
  PlotCurve curve{.name = std::move(name)};
  for (const LevelResult& level : problem.levels)
    if (const auto at = plot_point(abscissa(level, against), level.*kind.figure)) curve.points.push_back(*at);
  const OrderFit fit = order_of(problem, kind, against);
  curve.fit = order_text(fit);
  if (fit.order) curve.exponent = sign_of(against) * *fit.order;
  return curve;
}

std::string description(ErrorAgainst against) {
  return "Both axes are logarithmic. The order is " +
         std::string(against == ErrorAgainst::mesh_size ? "the exponent of the mesh size"
                                                        : "minus the exponent of the unknowns") +
         " that is fitted to the levels, its uncertainty the spread of the slopes between levels. Bars: what "
         "quadrature and "
         "rounding may have changed, where more than a marker.";
}

struct ErrorWords {
  std::string plain;
  std::string latex;
};

/// Of every kind that there is.
const ErrorWords& words_of(const ErrorKind& kind) {
  static const std::map<std::string, ErrorWords> words = {
      {"discretisation_error", {"max |K(I - P_n)u| over the nodes", "$\\max|K(I-P_n)u|$ over the nodes"}},
      {"node_error", {"max |u - u_n| over the nodes", "$\\max|u-u_n|$ over the nodes"}},
      {"uniform_error", {"max |u - u_n| over a sample of S", "$\\max|u-u_n|$ over a sample of $S$"}},
      {"l2_error", {"|u - u_n| in L2(S)", "$\\|u-u_n\\|_{L^2(S)}$"}},
      {"mean_error", {"max |mean of u - u_n| over the pieces", "the largest mean of $u-u_n$ over a piece"}},
      {"iterated_error", {"max |u - E - K u_n| over check points", "$\\max|u-E-Ku_n|$ over check points"}}};
  const auto found = words.find(kind.name);
  expects(found != words.end(), "an error with words", named("name", kind.name));
  return found->second;
}

}  // namespace

std::string in_words(const ErrorKind& kind) { return words_of(kind).plain; }

std::string in_latex(const ErrorKind& kind) { return words_of(kind).latex; }

std::optional<PlotPoint> plot_point(double x, const std::optional<Approximation>& error) {
  if (!error || !std::isnormal(error->value) || error->value < 0) return std::nullopt;
  return PlotPoint{.x = x, .y = error->value, .radius = error->has_radius() ? error->radius : 0};
}

Plot convergence_plot(std::string title, const ErrorKind& kind, ErrorAgainst against,
                      std::span<const ErrorHistory> problems) {
  Plot plot{.title = std::move(title),
            .description = description(against),
            .x = axis_of(against),
            .y = {.name = in_words(kind), .latex = in_latex(kind)}};
  for (std::size_t i = 0; i < problems.size(); ++i) {
    PlotCurve curve = curve_of(problems[i].name, problems[i], kind, against);
    if (curve.points.size() < 2) continue;
    curve.number = i;
    plot.curves.push_back(std::move(curve));
  }
  return plot;
}

Plot convergence_plot(std::string title, const ErrorHistory& problem) {
  Plot plot{.title = std::move(title),
            .description = description(ErrorAgainst::mesh_size),
            .x = axis_of(ErrorAgainst::mesh_size),
            .y = {.name = "error"}};
  std::vector<ErrorKind> kinds = error_kinds();
  kinds.push_back(iterated_kind());
  for (const ErrorKind& kind : kinds) {
    if (!is_for_plots(kind, problem.levels)) continue;
    PlotCurve curve = curve_of(in_words(kind), problem, kind, ErrorAgainst::mesh_size);
    if (curve.points.size() < 2) continue;
    curve.latex = in_latex(kind);
    plot.curves.push_back(std::move(curve));
  }
  return plot;
}

}  // namespace radcert
