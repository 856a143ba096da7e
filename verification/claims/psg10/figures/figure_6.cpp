// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <functional>

#include "radcert/core/text.h"
#include "radcert/meshless/radial_element.h"
#include "radcert/picture/curve_panel.h"
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

Figure draw_figure_6(const FigureWish& wish, const FigureProgress& progress) {
  constexpr std::array<double, 4> values{1, 3, 2, 4};
  constexpr double radius = 2;
  constexpr double low_x = -0.5;
  constexpr double high_x = 3.5;
  constexpr double low_y = -1.25;
  constexpr double high_y = 5.25;
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
  constexpr std::array<Colour, 4> light{
      {{0.35, 0.6, 0.95}, {0.95, 0.6, 0.3}, {0.4, 0.75, 0.45}, {0.75, 0.55, 0.9}}};

  Image image(wish.width, wish.height);
  Figure picture{.image = Image(1, 1),
                 .shows =
                     "psg10, figure 6: the elements of three bases at four sites of a line (light), and "
                     "what interpolates four values (dark)",
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
    CurvePanel panel{.title = std::string(bases[k].title),
                     .x_name = "x",
                     .y_name = "elements light, f dark",
                     .low_x = low_x,
                     .high_x = high_x,
                     .low_y = low_y,
                     .high_y = high_y};
    std::vector<PanelCurve> curves;
    for (const Colour& colour : light) curves.push_back({.points = {}, .colour = colour, .width = 0.8});
    curves.push_back({.points = {}, .colour = ink, .width = 1.1});
    // More than the pixels of any picture.
    constexpr std::size_t steps = 8000;
    for (std::size_t s = 0; s <= steps; ++s) {
      const double x = low_x + (high_x - low_x) * as_double(s) / as_double(steps);
      const std::vector<double> elements = bases[k].elements(x);
      double f = 0;
      for (std::size_t j = 0; j < elements.size(); ++j) {
        curves[j].points.push_back({x, elements[j]});
        f += coefficients[j] * elements[j];
      }
      curves.back().points.push_back({x, f});
    }
    panel.curves = std::move(curves);
    for (std::size_t i = 0; i < values.size(); ++i) panel.marks.push_back({as_double(i), values[i]});
    std::string text;
    for (const double c : coefficients) text += (text.empty() ? "" : ", ") + shortest(c);
    picture.facts.emplace_back("coefficients, " + std::string(bases[k].title), text);
    const std::size_t height = image.height() / bases.size();
    draw_panel(image, {.x = 0, .y = k * height, .width = image.width(), .height = height}, panel);
  }
  picture.image = std::move(image);
  return picture;
}

}  // namespace radcert::verification::psg10
