// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "output.h"
#include "verification/framework/finding.h"

namespace radcert::app {

namespace {

constexpr int digits = 5;

/// The value and its radius; the radius counts the digits that are not printed.
void push(std::vector<std::string>& row, const std::optional<Figure>& figure) {
  if (!figure) {
    row.insert(row.end(), {"-", "-"});
    return;
  }
  if (!figure->radius) {
    row.insert(row.end(), {fmt::format("{:.4e}", figure->value), "-"});
    return;
  }
  const auto text = verification::figure_text(figure->value, *figure->radius, digits);
  row.insert(row.end(), {text.value, text.radius});
}

std::string ratio_text(const std::optional<double>& ratio) {
  return ratio && std::isfinite(*ratio) ? fmt::format("{:.2f}", *ratio) : "-";
}

std::string level_table(const Result& result, bool with_errors) {
  std::vector<std::vector<std::string>> rows = {{"level", "elements", "unknowns", "h"}};
  if (with_errors)
    rows.front().insert(rows.front().end(),
                        {"|K(I-P_n)u|", "+-", "ratio", "|u-u_n| nodes", "+-", "ratio", "|u-u_n| sample"});
  rows.front().emplace_back("norm K");
  for (const LevelResult& level : result.levels) {
    std::vector<std::string> row = {std::to_string(level.level), std::to_string(level.elements),
                                    std::to_string(level.unknowns), fmt::format("{:.4g}", level.mesh_size)};
    if (with_errors) {
      push(row, level.discretisation_error);
      row.push_back(ratio_text(level.discretisation_ratio));
      push(row, level.node_error);
      row.push_back(ratio_text(level.node_ratio));
      row.push_back(level.uniform_error ? fmt::format("{:.3e}", level.uniform_error->value) : "-");
    }
    row.push_back(fmt::format("{:.6g}{}", level.norm_K.value, level.norm_K.guaranteed ? "" : " (estimate)"));
    rows.push_back(row);
  }
  // A radius and a ratio stay with their error.
  std::set<std::size_t> with_the_left;
  for (std::size_t column = 0; column < rows.front().size(); ++column)
    if (rows.front()[column] == "+-" || rows.front()[column] == "ratio") with_the_left.insert(column);
  return aligned(rows, with_the_left);
}

/// The means of u_n over the pieces, a row a level.
std::string means_table(const Result& result) {
  std::vector<std::vector<std::string>> rows = {{"level"}};
  if (!result.levels.empty())
    for (const auto& [piece, mean] : result.levels.front().piece_means) rows.front().push_back(piece);
  for (const LevelResult& level : result.levels) {
    std::vector<std::string> row = {std::to_string(level.level)};
    for (const auto& [piece, mean] : level.piece_means) row.push_back(fmt::format("{:.8g}", mean));
    rows.push_back(row);
  }
  return "Means of u_n over the pieces:\n" + aligned(rows);
}

/// The next number of two digits that is not smaller.
double rounded_up(double radius) {
  if (radius <= 0) return 0;
  const double unit = std::pow(10.0, std::floor(std::log10(radius)) - 1);
  return (std::floor(radius / unit) + 1) * unit;
}

std::string numbers(const std::vector<int>& levels) {
  std::string out;
  for (const int level : levels) out += (out.empty() ? "" : ", ") + std::to_string(level);
  return out;
}

std::string order_line(const OrderFit& fit) {
  const std::string name = fit.quantity == "node_error" ? "|u-u_n| at the nodes" : "|K(I-P_n)u|";
  std::string out = "Order of " + name + " in h: ";
  out += fit.order ? fmt::format("{:.2f}", *fit.order) : "not fitted";
  // Two levels have one slope, and no spread.
  if (fit.order && fit.halfwidth && fit.levels.size() > 2) out += fmt::format(" +- {:.2f}", *fit.halfwidth);
  if (!fit.levels.empty()) out += " (levels " + numbers(fit.levels) + ")";
  if (!fit.left_out.empty())
    out += "; left out, because the radius exceeds 5 % of the error: " + numbers(fit.left_out);
  return out + "\n";
}

/// How an iterative solver came to u_n, level by level; empty for another.
std::string iteration_line(const Result& result) {
  std::string iterations;
  double contraction = 0;
  double error_bound = 0;
  for (const LevelResult& level : result.levels) {
    if (!level.iteration) return {};
    iterations += (iterations.empty() ? "" : ", ") + std::to_string(level.iteration->iterations);
    contraction = std::max(contraction, level.iteration->contraction);
    error_bound = std::max(error_bound, level.iteration->error_bound);
  }
  return fmt::format("Iterations of {}: {}; contraction {:.3g}, error of the linear system at most {:.2g}\n",
                     solver_name(result.problem.solver.name), iterations, contraction, error_bound);
}

/// Whether the errors at the nodes are proved on every level, and u_n itself.
bool nodes_are_guaranteed(const Result& result) {
  return !result.levels.empty() &&
         std::all_of(result.levels.begin(), result.levels.end(), [](const LevelResult& level) {
           const auto proved = [](const std::optional<Figure>& figure) {
             return !figure || figure->guaranteed;
           };
           return level.verified && proved(level.discretisation_error) && proved(level.node_error);
         });
}

/// What is proved and what is not, in words.
std::string guarantee_text(const Result& result) {
  std::string out =
      "Guaranteed: at every level the collocation equations have one solution, and u_n at the nodes is known "
      "within\n  ";
  for (std::size_t i = 0; i < result.levels.size(); ++i)
    out += fmt::format("{}{:.1e} (level {})", i == 0 ? "" : ", ",
                       rounded_up(result.levels[i].verified->solution_radius), result.levels[i].level);
  out += ".\n";
  if (result.problem.solution)
    out +=
        "  |K(I-P_n)u| and |u-u_n| at the nodes lie within the radii (+-), all errors and the printed digits "
        "included.\n";
  out += "Not guaranteed: ";
  if (result.problem.solution) out += "the error on the sample, the orders, ";
  out += "the means";
  if (std::any_of(result.levels.begin(), result.levels.end(),
                  [](const LevelResult& level) { return !level.norm_K.guaranteed; }))
    out += ", the norm of K";
  return out + ".\n";
}

}  // namespace

std::string solve_table(const Result& result) {
  const bool with_errors = result.problem.solution.has_value();
  std::string out = level_table(result, with_errors) + "\n" + means_table(result) + "\n";
  for (const OrderFit& fit : result.orders)
    if (with_errors && (!fit.levels.empty() || !fit.left_out.empty())) out += order_line(fit);
  out += iteration_line(result);
  if (!with_errors) out += "No solution is given, so there are no errors to show.\n";
  if (nodes_are_guaranteed(result))
    out += guarantee_text(result);
  else if (with_errors)
    out += "The radii (+-) are estimates, not proofs; they include the rounding of the printed digits.\n";
  return out;
}

}  // namespace radcert::app
