// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <functional>

#include "radcert/core/text.h"
#include "radcert/meshless/radial_element.h"
#include "radcert/solve/elimination.h"
#include "verification/claims/psg10/figures/figures.h"
#include "verification/claims/psg10/figures/panels.h"

namespace radcert::verification::psg10 {
namespace {

/// One of the bases of figure 6.
struct LineBasis {
  std::string_view title;
  std::function<std::vector<double>(double x)> elements;
};

}  // namespace

Figure draw_figure_6(const FigureWish&, const FigureProgress& progress) {
  constexpr std::array<double, 4> values{1, 3, 2, 4};
  constexpr double radius = 2;
  const auto site = [](double x) { return Site<double>{.point = {x, 0, 0}, .normal = {0, 0, 1}}; };
  std::vector<Site<double>> sites;
  for (std::size_t i = 0; i < values.size(); ++i) sites.push_back(site(as_double(i)));
  const std::vector<double> radii(sites.size(), radius);
  const auto shepard = [&](double x) {
    std::vector<double> squares;
    for (const Site<double>& p : sites) squares.push_back((p.point.x - x) * (p.point.x - x));
    return shepard_values<double>(squares);
  };
  const auto gauss = [&](double x) { return basis_values<double>(gaussian_basis(), sites, radii, site(x)); };
  const auto lehtinen = [&](double x) {
    return basis_values<double>(lehtinen_basis(), sites, radii, site(x));
  };
  const std::array<LineBasis, 3> bases{{{"Shepard", shepard}, {"Gauss", gauss}, {"Lehtinen", lehtinen}}};
  Figure figure{.shows =
                    "psg10, figure 6: the elements of three bases at four sites of a line (thin), and what "
                    "interpolates four values (thick)",
                .facts = {{"sites", "0, 1, 2, 3"}, {"values", "1, 3, 2, 4"}, {"radii", radius}}};
  for (std::size_t k = 0; k < bases.size(); ++k) {
    progress(as_double(k) / as_double(bases.size()), std::string(bases[k].title));
    // The system that solve_by_elimination takes is I - K.
    Matrix<double> k_matrix(sites.size(), sites.size());
    for (std::size_t i = 0; i < sites.size(); ++i) {
      const std::vector<double> at_site = bases[k].elements(as_double(i));
      for (std::size_t j = 0; j < sites.size(); ++j) k_matrix(i, j) = (i == j ? 1 : 0) - at_site[j];
    }
    const std::vector<double> coefficients =
        solve_by_elimination<double>(k_matrix, {values.begin(), values.end()});
    Plot plot{.title = std::string(bases[k].title),
              .description = figure.shows,
              .x = {.name = "x", .logarithmic = false, .range = std::pair(-0.5, 3.5)},
              .y = {.name = "elements and f", .logarithmic = false, .range = std::pair(-1.25, 5.25)}};
    for (std::size_t j = 0; j < sites.size(); ++j)
      plot.curves.push_back({.name = "element of the site " + std::to_string(j), .style = CurveStyle::thin});
    PlotCurve f{.name = "f", .style = CurveStyle::bold};
    PlotCurve data{.name = "values", .style = CurveStyle::dots};
    constexpr std::size_t steps = 800;  // more than a plot is wide
    for (std::size_t s = 0; s <= steps; ++s) {
      const auto [low, high] = *plot.x.range;
      const double x = low + (high - low) * as_double(s) / as_double(steps);
      const std::vector<double> elements = bases[k].elements(x);
      double sum = 0;
      for (std::size_t j = 0; j < elements.size(); ++j) {
        plot.curves[j].points.push_back({.x = x, .y = elements[j]});
        sum += coefficients[j] * elements[j];
      }
      f.points.push_back({.x = x, .y = sum});
    }
    for (std::size_t i = 0; i < values.size(); ++i)
      data.points.push_back({.x = as_double(i), .y = values[i]});
    plot.curves.push_back(std::move(f));
    plot.curves.push_back(std::move(data));
    std::string text;
    for (const double c : coefficients) text += (text.empty() ? "" : ", ") + shortest(c);
    figure.facts.emplace_back("coefficients, " + plot.title, text);
    figure.plots.push_back(std::move(plot));
  }
  return figure;
}

}  // namespace radcert::verification::psg10
